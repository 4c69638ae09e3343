#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Time of a step of our styles beside LAMMPS's own linear spring and dashpot, in a settled packing on a plane: 1000
# grains and the same ten times over. In LAMMPS of 2025 all are models of pair granular with tangential history; of 2021
# they are frictionless, `pair_style fractional` beside `gran/hooke`. What is measured: engines/bench/packing.sh.
#   step_cost.sh [PATH-OF-lammps-ricochet]      REPEATS=5 STEPS=1000 by default, a fourth of it for 10000 grains
#   STYLES="hooke fractional/zener" by default all; the first is what the others are compared with

set -euo pipefail

here=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")
# shellcheck source=engines/bench/packing.sh
source "$here/../../bench/packing.sh"
driver=${1:-$here/../../../build/release/bin/lammps-ricochet}
driver=$(readlink -f "$driver")
kind=style line_format='format line'
if [[ $("$driver" -h 2>/dev/null) == *"Simulator - 29 Sep 2021"* ]]; then
  read -ra styles <<<"${STYLES:-gran/hooke fractional}"
  physics_of=physics_of_2021
else
  read -ra styles <<<"${STYLES:-hooke fractional fractional/kelvin_voigt fractional/hertz fractional/zener}"
  physics_of=granular
fi

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

compare_laws "${styles[@]}"
