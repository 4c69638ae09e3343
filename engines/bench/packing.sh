#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Time of a step in a settled packing on a plane, for the engines' step_cost.sh, which source this: 1000 grains and the
# same ten times over. Each law settles its packing itself, so that all hold as many contacts. Prints a Markdown table;
# microseconds of CPU time a step on one rank, the least of REPEATS runs taken in turn: what else the machine does then
# counts least.
#   compare_laws LAW…                       the first is what the others are compared with
# after the engine's script has set
#   driver, kind                            its path; what a law is called in the table
#   line_format                             the engine's keyword for how a dump's line looks
#   common, physics LAW                     functions: what every deck begins with; contacts, floor and motion
repeats=${REPEATS:-5} steps=${STEPS:-1000}

# Disturbed so that it does not fall as one, to be dropped and left to settle.
loose_lattice() {
  awk 'BEGIN {
    srand(1)
    print "grains\n\n1000 atoms\n1 atom types\n0 0.034 xlo xhi\n0 0.034 ylo yhi\n0 0.05 zlo zhi\n\nAtoms\n"
    for (i = 0; i < 1000; i++)
      printf "%d 1 0.003 1000 %.6f %.6f %.6f\n", i + 1, 0.0017 + 0.0034 * (i % 10) + 2e-4 * (rand() - 0.5),
        0.0017 + 0.0034 * (int(i / 10) % 10) + 2e-4 * (rand() - 0.5), 0.0017 + 0.0034 * int(i / 100) }'
}

run() { # DECK: its CPU time [s] in cpu.out
  local TIMEFORMAT='%U %S'
  { time "$driver" -in "$1" -log none >run.out 2>run.err; } 2>cpu.out || { grep ERROR run.out >&2; exit 4; }
}

settle() { # LAW GRAINS STEPS < data: settled packing as a restart file and as positions
  cat >start.data
  { common; echo 'read_data start.data'; physics "$1"; echo "run $3
write_restart ${1//\//_}.$2.restart
dump last all custom 1 ${1//\//_}.$2.dump id x y z
dump_modify last sort id $line_format \"%d %.9g %.9g %.9g\"
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

cpu_of() { # LAW GRAINS STEPS: CPU time of a run [s], contacts a grain
  { common; echo "read_restart ${1//\//_}.$2.restart"; physics "$1"
    echo "compute touching all contact/atom
compute mean all reduce ave c_touching
thermo_style custom step atoms c_mean
thermo 100000
run $3"; } >run.deck
  run run.deck
  awk '/^Loop time/ { contacts = last } { last = $3 } END { print contacts }' run.out | paste cpu.out -
}

time_of() { # LAW GRAINS STEPS: microseconds a step, contacts a grain
  { cpu_of "$1" "$2" 10; cpu_of "$1" "$2" $((10 + $3)); } | awk -v steps="$3" '
    { time = $1 + $2 - time; contacts = $3 } END { printf "%.1f %.2f\n", 1e6 * time / steps, contacts }'
}

compare_laws() {
  local laws=("$@") law grains i work
  work=$(mktemp -d)
  # shellcheck disable=SC2064 # now: it is gone with the function
  trap "rm -rf '$work'" EXIT
  cd "$work"
  for law in "${laws[@]}"; do
    loose_lattice | settle "$law" 1000 25000
    side_by_side 5 2 <"${law//\//_}.1000.dump" | settle "$law" 10000 4000
  done

  printf '| grains | %s | a step [µs] | of %s | contacts a grain |\n|---:|---|---:|---:|---:|\n' "$kind" "${laws[0]}"
  for grains in 1000 10000; do
    for ((i = 0; i < repeats; i++)); do
      for law in "${laws[@]}"; do
        echo "$law $(time_of "$law" "$grains" $((grains == 1000 ? steps : steps / 4)))"
      done
    done | awk -v grains="$grains" '
      !($1 in least) { order[++count] = $1; least[$1] = $2; contacts[$1] = $3 }
      $2 < least[$1] { least[$1] = $2 }
      END { for (i = 1; i <= count; i++) { m = order[i]
        printf "| %d | %s | %.0f | %.2f | %s |\n", grains, m, least[m], least[m] / least[order[1]], contacts[m] } }'
  done
}
