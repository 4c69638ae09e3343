#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# tutorial.sh CALIBRATE PROGRAM liggghts|lammps: exports the law as docs/tutorial.md says, runs the example that
# includes it, and looks whether the bead that came at 2 m/s leaves at 1 m/s, to 0.3 %: the file's own time step
# promises 0.1 % of the restitution.
set -euo pipefail
calibrate=$(realpath "$1") program=$2 engine=$3
root=$(cd "$(dirname "$0")/../.." && pwd)

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
line=$(grep -E "^\\$ \./ricochet calibrate .* -o law\.$engine\$" "$root/docs/tutorial.md")
# shellcheck disable=SC2086 # words of the line
"$calibrate" ${line#*calibrate }
# The deck has the grain of that line: else its collision would take another time.
deck=$root/examples/$engine/bounce.$engine
awk -v line="$line" '
  function of(text, word,   words, n, i) {
    n = split(text, words, /[ \t]+/)
    for (i = 1; i < n; ++i) if (words[i] == word) return words[i + 1] + 0
  }
  /^set group/ { diameter = of($0, "diameter"); density = of($0, "density") }
  END { if (diameter != 2 * of(line, "--radius") || density != of(line, "--density")) {
          print FILENAME ": not the grain of: " line; exit 1 } }' "$deck"
"$program" -in "$deck" >out.txt 2>&1 || { cat out.txt; exit 1; }
# Rows of step, time and velocity.
awk '$1 ~ /^[0-9]+$/ && NF == 3 && $2 ~ /^[0-9.e+-]+$/ { last = $3 }
  NR == 1 || $1 == "0" && NF == 3 { first = $3 }
  END { print "from", first, "to", last
        exit !(first == -2 && last > 0.997 && last < 1.003) }' out.txt
