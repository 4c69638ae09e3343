#!/usr/bin/env bash
# memcheck.sh BIN SOURCE: typical commands of every program under valgrind's memcheck: no invalid access, no decision on
# what was never set, nothing lost.
set -uo pipefail
bin=$(realpath "$1") source=$(realpath "$2")
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder" || exit 1
sed 's/"duration": 0.5/"duration": 0.02/' "$source/data/scenes/bounce.json" >bounce.json
sed 's/"duration": [0-9.e-]*/"duration": 3e-4/' "$source/data/scenes/column.json" >column.json
{ echo law,tcol,en; printf '%s,1e-4,0.5\n' linear kuwabara-kono tsuji hysteretic fractional; } >targets.csv
failures=0
while read -r expected command; do
  program=${command%% *}
  # shellcheck disable=SC2086  # the commands are this script's own words
  valgrind --quiet --error-exitcode=99 --leak-check=full --show-leak-kinds=definite,indirect \
    --errors-for-leak-kinds=definite,indirect "$bin/$program" ${command#"$program"} >out 2>err </dev/null
  code=$?
  if [[ $code != "$expected" ]]; then
    echo "memcheck.sh: $command: exit code $code, not $expected" >&2
    cat err >&2
    failures=$((failures + 1))
  fi
done <<EOL
0 calibrate --tcol 1e-4 --en 0.5 --format json
0 calibrate --tcol 1e-4 --en 0.5 --method direct --export liggghts
0 calibrate --tcol 1e-4 --en 0.5 --law linear --export yade -o deck.py
3 calibrate --tcol 1e-4 --en 0.5 --law fractional --export yade -o deck.py
2 calibrate --tcol 1e-4 --en 1.5
3 calibrate --tcol 1e-4 --en 0.001 --law fractional --end overlap
0 calibrate --targets targets.csv --threads 2 -o rows.csv
0 calibrate --fit $source/data/restitution_ice_bridges1984.csv --law fractional
4 calibrate --tcol 1e-4 --en 0.5 --law linear -o /dev/full
0 verify table2 --format json
0 verify peers --format csv
2 verify nothing
0 simulate bounce.json -o bounce --view bounce.html
0 simulate column.json -o column
2 simulate none.json -o none
EOL
((failures == 0))
