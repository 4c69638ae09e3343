#!/usr/bin/env bash
# targets.sh CALIBRATE: many rows, on any number of threads to the same bytes, in bounded memory; nothing is left of
# what is interrupted. Exit code 77 where all was well but the memory could not be bounded.
set -euo pipefail
source "$(dirname "$0")/same_files.sh"
calibrate=$(realpath "$1")
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
fail() { echo "targets.sh: $*" >&2; exit 1; }

# 150 000 rows of all laws and ends, some of them bad: several blocks a thread.
LC_ALL=C awk 'BEGIN {
  split("linear kuwabara-kono tsuji hysteretic fractional", law)
  print "law,en,tcol,velocity"
  for (i = 0; i < 150000; ++i)
    printf "%s,%.7g,%.7g,%.5g\n", law[i % 5 + 1],
      i % 20000 == 7 ? 2 : 0.01 + 0.98 * (i * 7919 % 100003) / 100003, 1e-6 * (1 + i % 1000), 0.1 + i % 9
}' >rows.csv

# 300 MB of address space hold the program, its threads and a few blocks: not the answers to a file of any size.
code=0
room=300000 skipped=
if grep -qE '__[at]san_init' "$calibrate"; then
  room=unlimited skipped='bounded memory (a sanitizer reserves terabytes for itself)'
fi
(ulimit -v $room; "$calibrate" --targets rows.csv --threads 2 -o two.csv 2>two.err) || code=$?
[[ $code == 1 ]] || fail "exit code $code with bad rows"
drop_progress two.err
"$calibrate" --targets rows.csv --threads 1 >one.csv 2>one.err && fail "bad rows went unnoticed"
drop_progress one.err
cmp one.csv two.csv
cmp one.err two.err
for threads in 3 7; do
  "$calibrate" --targets rows.csv --threads $threads >more.csv 2>more.err && fail "bad rows went unnoticed"
  drop_progress more.err
  cmp one.csv more.csv
  cmp one.err more.err
done
[[ $(wc -l <one.csv) == 150001 ]] || fail "rows are missing"
[[ $(wc -l <one.err) == 8 ]] || fail "complaints: $(wc -l <one.err)"
[[ $(head -1 one.err) == 'calibrate: rows.csv:9: en = 2: must be in (0, 1]' ]] || fail "$(head -1 one.err)"
# In order: the velocity of every answer is that of its row.
cmp <(cut -d, -f4 rows.csv | tail -n +2) <(cut -d, -f3 one.csv | tail -n +2)

# What is interrupted leaves the file that was there.
echo before >kept.csv
mkfifo slow
# Enough rows for the first of them to be written.
(cat rows.csv; sleep 20) >slow 2>/dev/null & feeder=$!
"$calibrate" --targets slow -o kept.csv 2>/dev/null & job=$!
begun() { [[ -n $(find . -name '.kept.csv.*') ]]; } # to write
for ((k = 0; k < 300; ++k)); do begun && break || sleep 0.05; done
begun || fail 'nothing to interrupt: no temporary file'
kill -TERM "$job"
code=0
wait "$job" || code=$?
kill "$feeder" 2>/dev/null || true
[[ $code == 143 ]] || fail "exit code $code after SIGTERM"
[[ $(cat kept.csv) == before ]] || fail "an interrupted run changed the file"
[[ -z $(find . -name '*kept.csv?*' -o -name '.*kept*') ]] || fail "an interrupted run left a temporary file: $(ls -A)"
[[ -z $skipped ]] || { echo "skipped: $skipped"; exit 77; }
