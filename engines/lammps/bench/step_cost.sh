#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Time of a step of our styles beside LAMMPS's own linear spring and dashpot, in a settled packing on a plane: 1000
# grains and the same ten times over. In LAMMPS of 2025 all are models of pair granular with tangential history; of 2021
# they are frictionless, `pair_style fractional` beside `gran/hooke`. Each settles its packing itself, so that all hold
# as many contacts. Prints a Markdown table; microseconds of CPU time a step on one rank, the least of REPEATS runs
# taken in turn: what else the machine does then counts least.
#   step_cost.sh [PATH-OF-lammps-ricochet]      REPEATS=5 STEPS=1000 by default, a fourth of it for 10000 grains
#   STYLES="hooke fractional/zener" by default all; the first is what the others are compared with

set -euo pipefail

driver=${1:-$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/../../../build/release/bin/lammps-ricochet}
driver=$(readlink -f "$driver")
repeats=${REPEATS:-5} steps=${STEPS:-1000}
if [[ $("$driver" -h 2>/dev/null) == *"Simulator - 29 Sep 2021"* ]]; then
  read -ra styles <<<"${STYLES:-gran/hooke fractional}"
  physics_of=physics_of_2021
else
  read -ra styles <<<"${STYLES:-hooke fractional fractional/kelvin_voigt fractional/hertz fractional/zener}"
  physics_of=granular
fi
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

common() {
  cat <<'DECK'
units si
atom_style sphere
atom_modify map array
boundary p p f
newton off
comm_modify vel yes
processors * * 1
DECK
}
# Collision time 4e-4 s and restitution 0.5 of two grains of 3 mm and 1000 kg/m^3.
physics_of_2021() {
  case $1 in
    gran/hooke) cat <<'DECK' ;;
pair_style gran/hooke 457.24 NULL 3465.74 NULL 0 0
pair_coeff * *
fix floor all wall/gran hooke 914.48 NULL 3465.74 NULL 0 0 zplane 0 NULL
DECK
    fractional) cat <<'DECK' ;;
pair_style fractional
pair_coeff * * target 4e-4 0.5
fix floor all wall/fractional zplane 0 NULL target 4e-4 0.5
DECK
  esac
}
granular() {
  local parts="damping fractional tangential linear_history 457.24 1 0.5" pair wall
  case $1 in
    hooke) parts="damping mass_velocity ${parts#*fractional }"
      pair="hooke 457.24 3465.74 $parts" wall="hooke 914.48 3465.74 $parts" ;;
    fractional) pair="$1/target 4e-4 0.5 $parts" wall=$pair ;;
    fractional/kelvin_voigt) pair="$1/target 4e-4 0.5 NULL $parts" wall=$pair ;;
    fractional/hertz) pair="$1/target 4e-4 0.5 NULL 1 $parts" wall=$pair ;;
    fractional/zener) pair="$1/target 4e-4 0.5 NULL NULL $parts" wall=$pair ;;
  esac
  cat <<DECK
pair_style granular
pair_coeff * * $pair
fix floor all wall/gran granular $wall zplane 0 NULL
DECK
}
physics() {
  "$physics_of" "$1"
  cat <<'DECK'
neighbor 0.0006 bin
neigh_modify delay 0
fix g all gravity 9.81 vector 0 0 -1
fix move all nve/sphere
timestep 8e-6
DECK
}

# A loose lattice, disturbed so that it does not fall as one, dropped and left to settle.
awk 'BEGIN {
  srand(1)
  print "grains\n\n1000 atoms\n1 atom types\n0 0.034 xlo xhi\n0 0.034 ylo yhi\n0 0.05 zlo zhi\n\nAtoms\n"
  for (i = 0; i < 1000; i++)
    printf "%d 1 0.003 1000 %.6f %.6f %.6f\n", i + 1, 0.0017 + 0.0034 * (i % 10) + 2e-4 * (rand() - 0.5),
      0.0017 + 0.0034 * (int(i / 10) % 10) + 2e-4 * (rand() - 0.5), 0.0017 + 0.0034 * int(i / 100) }' >loose.data

run() { # DECK: its CPU time [s] in cpu.out
  local TIMEFORMAT='%U %S'
  { time "$driver" -in "$1" -log none >run.out 2>run.err; } 2>cpu.out || { grep ERROR run.out >&2; exit 4; }
}

settle() { # STYLE GRAINS STEPS < data: settled packing as a restart file and as positions
  cat >start.data
  { common; echo 'read_data start.data'; physics "$1"; echo "run $3
write_restart ${1//\//_}.$2.restart
dump last all custom 1 ${1//\//_}.$2.dump id x y z
dump_modify last sort id format line \"%d %.9g %.9g %.9g\"
run 0"; } >settle.deck
  run settle.deck
}

side_by_side() { # NX NY < dump: the packing repeated
  awk -v nx="$1" -v ny="$2" -v side=0.034 'BEGIN {
      printf "grains\n\n%d atoms\n1 atom types\n0 %g xlo xhi\n0 %g ylo yhi\n0 0.05 zlo zhi\n\nAtoms\n\n",
        1000 * nx * ny, nx * side, ny * side }
    seen { for (i = 0; i < nx; i++) for (j = 0; j < ny; j++)
      printf "%d 1 0.003 1000 %.9f %.9f %s\n", ++n, $2 + i * side, $3 + j * side, $4 }
    /ITEM: ATOMS/ { seen = 1 }'
}

cpu_of() { # STYLE GRAINS STEPS: CPU time of a run [s], contacts a grain
  { common; echo "read_restart ${1//\//_}.$2.restart"; physics "$1"
    echo "compute touching all contact/atom
compute mean all reduce ave c_touching
thermo_style custom step atoms c_mean
thermo 100000
run $3"; } >run.deck
  run run.deck
  awk '/^Loop time/ { contacts = last } { last = $3 } END { print contacts }' run.out | paste cpu.out -
}

time_of() { # STYLE GRAINS STEPS: microseconds a step, contacts a grain
  { cpu_of "$1" "$2" 10; cpu_of "$1" "$2" $((10 + $3)); } | awk -v steps="$3" '
    { time = $1 + $2 - time; contacts = $3 } END { printf "%.1f %.2f\n", 1e6 * time / steps, contacts }'
}

for style in "${styles[@]}"; do
  settle "$style" 1000 25000 <loose.data
  side_by_side 5 2 <"${style//\//_}.1000.dump" >ten.data
  settle "$style" 10000 4000 <ten.data
done

printf '| grains | style | a step [µs] | of %s | contacts a grain |\n|---:|---|---:|---:|---:|\n' "${styles[0]}"
for grains in 1000 10000; do
  for ((i = 0; i < repeats; i++)); do
    for style in "${styles[@]}"; do
      echo "$style $(time_of "$style" "$grains" $((grains == 1000 ? steps : steps / 4)))"
    done
  done | awk -v grains="$grains" '
    !($1 in least) { order[++count] = $1; least[$1] = $2; contacts[$1] = $3 }
    $2 < least[$1] { least[$1] = $2 }
    END { for (i = 1; i <= count; i++) { m = order[i]
      printf "| %d | %s | %.0f | %.2f | %s |\n", grains, m, least[m], least[m] / least[order[1]], contacts[m] } }'
done
