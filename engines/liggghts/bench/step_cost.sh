#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Time of a step of our models beside LIGGGHTS's own `model hooke`, all with tangential history, in a settled packing:
# 1000 grains and the same ten times over. What is measured: engines/bench/packing.sh.
#   step_cost.sh [PATH-OF-liggghts-ricochet]      REPEATS=5 STEPS=1000 by default, a fourth of it for 10000 grains
#   MODELS="hooke fractional-zener" by default all; the first is what the others are compared with

set -euo pipefail

here=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")
# shellcheck source=engines/bench/packing.sh
source "$here/../../bench/packing.sh"
driver=${1:-$here/../../../build/release/bin/liggghts-ricochet}
driver=$(readlink -f "$driver")
kind=model line_format=format
read -ra models <<<"${MODELS:-hooke fractional fractional-kelvin-voigt fractional-hertz fractional-zener}"

# Collision time 4e-4 s, restitution 0.5; hooke's Young's modulus gives the stiffness of the same collision time.
common() {
  cat <<'DECK'
units si
atom_style granular
atom_modify map array
boundary p p f
newton off
communicate single vel yes
soft_particles yes
processors * * 1
DECK
}
physics() {
  cat <<DECK
neighbor 0.0006 bin
neigh_modify delay 0
fix a all property/global coefficientRestitution peratomtypepair 1 0.5
fix b all property/global coefficientFriction peratomtypepair 1 0.5
fix c all property/global collisionTime peratomtypepair 1 4e-4
fix d all property/global youngsModulus peratomtype 2.5e6
fix e all property/global poissonsRatio peratomtype 0.3
fix f all property/global characteristicVelocity scalar 1
pair_style gran model $1 tangential history
pair_coeff * *
fix floor all wall/gran model $1 tangential history primitive type 1 zplane 0
fix g all gravity 9.81 vector 0 0 -1
fix move all nve/sphere
timestep 8e-6
DECK
}

compare_laws "${models[@]}"
