#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# decks.sh CALIBRATE PROGRAM liggghts|lammps PAGE SPEED...: exports each law as the page says, runs the example that
# includes it, and looks whether the bead that came at 2 m/s leaves at SPEED, to 0.3 %: the file's own time step
# promises 0.1 % of the restitution. A speed that the page gives to a thousandth is the one that comes out.
set -euo pipefail
calibrate=$(realpath "$1") program=$2 engine=$3
root=$(cd "$(dirname "$0")/../.." && pwd)
page=$root/$4
shift 4

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
ln -s "$root/data" data
mkdir bin
ln -s "$calibrate" bin/calibrate
mapfile -t lines < <(sed -nE "s,^\\$ \./ricochet (calibrate .* -o law\.$engine( .*)?)\$,\1,p" "$page")
((${#lines[@]} == $#)) || { echo "$page exports ${#lines[@]} laws, not $#"; exit 1; }
for line in "${lines[@]}"; do
  PATH=$PWD/bin:$PATH bash -c "$line"
  "$program" -in "$root/examples/$engine/bounce.$engine" >out.txt 2>&1 || { cat out.txt; exit 1; }
  # Rows of step, time and velocity.
  last=$(awk '$1 ~ /^[0-9]+$/ && NF == 3 && $2 ~ /^[0-9.e+-]+$/ { if ($1 == 0) first = $3; last = $3 }
    END { if (first == -2) printf "%.3f", last }' out.txt)
  echo "leaves at ${last:-no speed}"
  awk -v last="${last:-0}" -v wanted="$1" 'BEGIN { exit !(last > 0.997 * wanted && last < 1.003 * wanted) }'
  told=$(grep -oE '(leaves at|go at) [0-9]\.[0-9]{3} m/s' "$page" || true)
  [[ ! $told || $told == *" $last m/s"* ]] || { echo "the page says: $told"; exit 1; }
  shift
done
