#!/usr/bin/env bash
# endings.sh BIN SOURCE: however a program ends, each of its files is the old one or the new one, whole, nothing
# temporary is left, and the exit code and one line on stderr say what happened. INSTANTS (default 9) signals a
# command, spread over its run; more find rarer moments. Exit code 77 where all was well but some endings could not be
# brought about: protected folders and small disks take root's rights.
set -euo pipefail
source "$(dirname "$0")/same_files.sh"
bin=$(realpath "$1") source=$(realpath "$2") instants=${INSTANTS:-9}
umask 022 # others run our programs here
folder=$(realpath "$(mktemp -d)")
chmod 755 "$folder"
# Not in a job that a signal reaches before it has become its program: it is this shell still, traps and all.
trap 'if [[ $BASHPID == "$$" ]]; then umount "$folder/small" 2>/dev/null || true; rm -rf "$folder"; fi' EXIT
cd "$folder"
mkdir tmp small
chmod 1777 tmp
export TMPDIR=$folder/tmp LC_ALL=C.UTF-8 PATH=$bin:$PATH
declare -i failures=0 checks=0 skipped=0
fail() { echo "endings.sh: $*" >&2; failures+=1; }
skip() { echo "skipped: $*"; skipped+=1; }

# Rows for --targets: half a second of them.
awk 'BEGIN {
  split("linear tsuji hysteretic fractional", law)
  print "law,en,tcol"
  for (i = 0; i < 120000; ++i)
    printf "%s,%.7g,%.7g\n", law[i % 4 + 1], 0.01 + 0.98 * (i * 7919 % 100003) / 100003, 1e-6 * (1 + i % 1000)
}' >rows.csv
ln -s "$source" source
simulate source/data/scenes/five_spheres_weak.json -o finished 2>/dev/null

# Every way in which a program makes files: each line runs in this folder and writes into out/ only.
commands=(
  'calibrate --tcol 1e-4 --en 0.5 -o out/table.txt'
  'calibrate --tcol 1e-4 --en 0.5 --format json -o out/laws.json'
  'calibrate --tcol 1e-4 --en 0.5 --export liggghts -o out/deck.liggghts'
  'calibrate --tcol 1e-4 --en 0.5 --law fractional --report out/page.html -o out/laws.csv --format csv'
  'calibrate --fit source/data/restitution_ice_bridges1984.csv --figures out -o out/study.json --format json'
  'calibrate --targets rows.csv -o out/rows_out.csv'
  'verify table1 --format markdown -o out/study.md'
  'verify figures --figures out -o out/study.txt'
  'simulate source/data/scenes/five_spheres_weak.json -o finished --resume --view out/run.html'
)

# is before / is new: out/ is byte for byte the folder of that name.
is() { same_files "$1" out >/dev/null 2>&1; }

# Runs "$2…" with out/ as it was before; the exit code in $code, stderr in err.
run() {
  rm -rf out
  cp -a before out
  code=0
  # Through a pipe, which no limit on files holds up.
  { "$@" 2>&1 >stdout </dev/null || echo $? >&3; } 3>code | cat >err
  [[ ! -s code ]] || code=$(cat code)
  drop_progress err
}

# The run failed as $1 says, said so in one line that matches $2, and left all as it was.
must_fail() {
  local want=$1 pattern=$2 what=$3
  checks+=1
  [[ $code == "$want" ]] || fail "$what: exit code $code, not $want: $(cat err)"
  [[ $(wc -l <err) == 1 ]] || fail "$what: not one line: $(cat err)"
  grep -qE "$pattern" err || fail "$what: stderr is: $(cat err)"
  is before || fail "$what: changed: $(same_files before out)"
  no_litter "$what"
}

no_litter() {
  [[ -z $(find tmp -mindepth 1) ]] || { fail "$1: left $(find tmp -mindepth 1)"; rm -rf tmp/*; }
}

# What the command writes when nothing happens, and as `before` other files of these names. How long it takes is the
# least of three runs: one that is held up would put all signals past the end.
reference() {
  local start took
  micros=
  for _ in 1 2 3; do
    rm -rf out new before
    mkdir out
    start=${EPOCHREALTIME/./}
    bash -c "$1" >new_stdout 2>err || fail "$1: exit code $?: $(cat err)"
    took=$((${EPOCHREALTIME/./} - start))
    ((took < ${micros:-took + 1})) && micros=$took
  done
  mv out new
  mkdir before
  for file in new/*; do echo "what was here before" >"before/${file##*/}"; done
}

# --- signals --------------------------------------------------------------------------------------------------------
# A shell's background jobs ignore SIGINT: env gives it back, which takes a moment.
ignores_interrupts() {
  local mask
  mask=$(awk '/^SigIgn/ { print $2 }' "/proc/$1/status" 2>/dev/null) && ((0x${mask:-0} & 2))
}
signalled() {
  local name=$1 number=$2 after=$3
  shift 3
  env --default-signal bash -c "exec $*" >stdout 2>err </dev/null &
  local job=$!
  while ignores_interrupts "$job"; do sleep 0.01; done
  sleep "$after"
  kill "-$name" "$job" 2>/dev/null || true
  code=0
  wait "$job" 2>/dev/null || code=$?
  expected=$((128 + number))
}

spread() { # the k-th of n instants of the run, in seconds
  local at=$((micros * (2 * $1 + 1) / (2 * instants)))
  printf '%d.%06d' $((at / 1000000)) $((at % 1000000))
}

numbers=(HUP 1 INT 2 TERM 15)
each_signal() { # command, checker
  local caught=0
  for ((k = 0; k < instants; ++k)); do
    local s=$((k % 3 * 2))
    rm -rf out
    cp -a before out
    signalled "${numbers[s]}" "${numbers[s + 1]}" "$(spread $k)" "$1"
    [[ $code == 0 ]] || caught=$((caught + 1))
    "$2" "$1 on SIG${numbers[s]} after $(spread $k) s"
    no_litter "$1"
    checks+=1
  done
  ((caught > 0)) || fail "$1: no signal came in time"
}

all_or_nothing() {
  if [[ $code == "$expected" ]]; then
    # A signal between the last rename and the end of the program finds all done.
    is before || is new || fail "$1: half done: $(same_files before out)"
  elif [[ $code == 0 ]]; then
    is new || fail "$1: exit code 0, but not written: $(same_files new out)"
  else
    fail "$1: exit code $code: $(cat err)"
  fi
}

for command in "${commands[@]}"; do
  reference "$command"
  each_signal "$command" all_or_nothing
done

# A report of all studies takes long; what is stopped anywhere in it leaves the old one.
mkdir -p before && rm -rf before/* new && echo old >before/index.html && cp -a before new
micros=3000000 instants_all=$instants instants=6
each_signal 'verify all --quick --report out' all_or_nothing
instants=$instants_all

# Folders that were made for it go with it.
for path in fresh fresh/a/b; do
  signalled TERM 15 0.3 "verify all --quick --report $path"
  [[ $code == 143 ]] || fail "verify all --report $path: exit code $code: $(cat err)"
  [[ ! -e fresh ]] || fail "verify all --report $path: left $(find fresh)"
  checks+=1
done

# simulate's files grow; stopped, they hold whole frames and rows, and --resume goes on to the very bytes of a whole
# run.
whole_records() {
  [[ $code == "$expected" || $code == 0 ]] || fail "$1: exit code $code: $(cat err)"
  [[ -e out/trajectory.xyz ]] || return 0
  awk 'NR % 4 == 1 && $0 != 2 || NR % 4 == 2 && !/^Lattice=.* Properties=.* pbc="F F F"$/ ||
       NR % 4 == 3 && NF != 13 || NR % 4 == 0 && NF != 13 { exit 1 }
       END { if (NR % 4) exit 1 }' out/trajectory.xyz || fail "$1: a frame is not whole"
  for csv in contacts energy; do
    awk -F, 'NR == 1 { n = NF } NF != n { exit 1 }' out/$csv.csv || fail "$1: $csv.csv has a row that is not whole"
    [[ -z $(tail -c 1 out/$csv.csv) ]] || fail "$1: $csv.csv does not end with its row"
  done
}
resumed() {
  whole_records "$1"
  [[ $code == "$expected" ]] || return 0
  if [[ -e out/state.json ]]; then
    grep -q 'go on with: simulate' err || fail "$1: does not say how to go on: $(cat err)"
    simulate source/data/scenes/bounce.json -o out --resume 2>err || fail "$1: --resume: $(cat err)"
    is new || fail "$1: resumed to other bytes"
  elif [[ -n $(find out -type f -size +0) ]]; then
    fail "$1: files but no state"
  fi
}
reference 'simulate source/data/scenes/bounce.json -o out'
rm -rf before && mkdir before
each_signal 'simulate source/data/scenes/bounce.json -o out' resumed

# --- no room, no right, no reader -----------------------------------------------------------------------------------
full='No space left on device'
streams=(
  'calibrate --tcol 1e-4 --en 0.5'
  'calibrate --tcol 1e-4 --en 0.5 --format json'
  'calibrate --tcol 1e-4 --en 0.5 --export mfix'
  'calibrate --targets rows.csv'
  'calibrate --fit source/data/restitution_ice_bridges1984.csv'
  'calibrate --help'
  'verify table1'
  'verify figures --format csv'
  'simulate --version'
)
rm -rf before && mkdir before
for command in "${streams[@]}"; do
  run bash -c "$command >/dev/full"
  must_fail 4 "^${command%% *}: standard output: cannot write: $full\$" "$command >/dev/full"
  run bash -c "$command >&-"
  must_fail 4 "^${command%% *}: standard output: cannot write: Bad file descriptor\$" "$command >&-"
  # A pipe whose reader has gone before the first byte.
  exec {pipe}> >(:)
  wait $!
  run bash -c "$command >&$pipe"
  exec {pipe}>&-
  must_fail 4 "^${command%% *}: standard output: cannot write: Broken pipe\$" "$command | :"
done
code=0
set +o pipefail
{ calibrate --targets rows.csv 2>err || echo $? >stopped; } | head -1 >/dev/null
set -o pipefail
[[ $(cat stopped 2>/dev/null) == 4 ]] || fail "calibrate --targets | head -1: exit code $(cat stopped): $(cat err)"
code=4
must_fail 4 'standard output: cannot write: Broken pipe$' 'calibrate --targets | head -1'

for command in "${commands[@]}"; do
  program=${command%% *}
  reference "$command"

  # The file that one of the options names is a full device, or no file at all.
  for option in '-o' --report --view; do
    [[ $command == *" $option out/"* ]] || continue
    file=$(sed -E "s,.* $option (out/[^ ]*).*,\1," <<<"$command")
    run bash -c "${command/"$file"//dev/full}"
    must_fail 4 "^$program: /dev/full: cannot write: $full\$" "$command with $option /dev/full"
    for case in 'none/x|No such file or directory' 'rows.csv/x|Not a directory' 'source|Is a directory'; do
      run bash -c "${command/"$file"/"${case%|*}"}"
      must_fail 2 "^$program: ${case%|*}: cannot write: ${case#*|}\$" "$command with $option ${case%|*}"
    done
  done
  if [[ $command == *'--figures out'* ]]; then
    run bash -c "${command/--figures out/--figures rows.csv\/x}"
    must_fail 2 "^$program: rows.csv/x: cannot make the folder: Not a directory\$" "$command with --figures rows.csv/x"
    # One of several files cannot be put in its place: none is.
    rm -rf aside && cp -a before aside
    picture=$(cd new && ls *.svg | head -1)
    rm "before/$picture" && mkdir "before/$picture"
    run bash -c "$command"
    must_fail 2 "^$program: out/$picture: cannot write: Is a directory\$" "$command over a folder"
    rm -rf before && mv aside before
  fi

  # A file that may not grow: at its start, in its middle, at its end.
  largest=$(stat -c %s new/* | sort -n | tail -1)
  for blocks in 0 $((largest / 2048)) $(((largest - 1) / 1024)); do
    run bash -c "ulimit -f $blocks; $command"
    must_fail 4 "^$program: .*(File too large|File size limit exceeded)\$" "$command with ulimit -f $blocks"
  done

  # stderr closed: nothing lands in the files instead.
  run bash -c "$command 2>&- >&-"
  [[ $code == 0 ]] || { fail "$command 2>&-: exit code $code"; continue; }
  is new || fail "$command 2>&-: $(same_files new out)"
done

# Complaints of bad rows would be the first to go astray.
{ echo tcol,en; echo 1e-4,0.5; echo 1e-4,2; } >bad.csv
calibrate --targets bad.csv >bad_rows.csv 2>err && fail 'calibrate --targets with a bad row: exit code 0'
calibrate --targets bad.csv -o bad_too.csv >&- 2>&- <&- && fail 'calibrate --targets with a bad row: exit code 0'
cmp bad_rows.csv bad_too.csv || failures+=1

# Without root's rights a folder and a file can be protected.
nobody='setpriv --reuid 65534 --regid 65534 --clear-groups'
if ((EUID == 0)) && $nobody bash -c "'$bin/calibrate' --version && test -r source/data" >/dev/null 2>&1; then
  as_nobody=$nobody
elif ((EUID != 0)); then
  as_nobody=env
else
  as_nobody= && skip 'protected folders (nobody cannot run the programs, or read their sources, here)'
fi
if [[ -n $as_nobody ]]; then
  for command in "${commands[@]}"; do
    reference "$command"
    chmod -R a-w before
    run bash -c "$as_nobody $command"
    must_fail 2 "^${command%% *}: out[^:]*: cannot write: Permission denied\$" "$command into a protected folder"
    chmod -R u+w before out
  done
fi

# A small disk, as root: full after the first bytes, in the middle, and among the temporary files.
on_small_disk() { # size, command
  run unshare -m bash -c "mount -t tmpfs -o size=$1 none small && mkdir small/out && cp -a before/. small/out &&
    (cd small && ln -s ../source ../rows.csv ../finished . && ${2}); code=\$?
    rm -rf out; cp -a small/out out; exit \$code"
}
if ((EUID == 0)) && unshare -m mount -t tmpfs none small 2>/dev/null; then
  for command in "${commands[@]}"; do
    reference "$command"
    # Pages of 4096 bytes: one for each old file, and for the new ones none, half of them, or all but one.
    old=$(ls new | wc -l) pages=$(stat -c %s new/* | awk '{ n += int(($1 + 4095) / 4096) } END { print n }')
    for size in $old $((old + pages / 2)) $((old + pages - 1)); do
      on_small_disk $((4096 * size)) "$command"
      must_fail 4 "^${command%% *}: out/[^:]*: cannot write: $full\$" "$command on a disk of $size pages"
    done
  done
  # A name that nothing may take, as something is mounted there, comes last: what has its place gives it back.
  for command in 'calibrate --tcol 1e-4 --en 0.5 --law fractional --report out/page.html -o out/laws.csv --format csv' \
    'verify tcol --figures out -o out/laws.csv'; do
    reference "$command"
    run unshare -m bash -c "mount --bind rows.csv out/laws.csv && $command"
    must_fail 4 "^${command%% *}: out/laws.csv: cannot write: Device or resource busy\$" "$command, which is mounted"
  done
  run unshare -m bash -c "mount -t tmpfs -o size=8k none tmp && verify figures --figures out"
  must_fail 4 "^verify: .*: cannot write: $full\$" 'verify figures with a full /tmp'
  rm -rf before && mkdir before
  for size in 4k 16k 32k 48k; do
    on_small_disk $size 'simulate source/data/scenes/bounce.json -o out'
    [[ $code == 4 ]] || fail "simulate on a disk of $size: exit code $code: $(cat err)"
    grep -qE "^simulate: out/[a-z.]*: cannot write: $full\$" err || fail "simulate on a disk of $size: $(cat err)"
    expected=4
    whole_records "simulate on a disk of $size"
    checks+=1
  done
else
  skip 'small disks (only root can mount one)'
fi
run simulate source/data/scenes/bounce.json -o rows.csv/x
must_fail 2 '^simulate: rows.csv/x: cannot make the folder: Not a directory$' 'simulate into a file'
run bash -c 'ulimit -f 8; simulate source/data/scenes/bounce.json -o out'
[[ $code == 4 ]] && grep -qE '^simulate: out/[a-z.]*: cannot write: File too large$' err ||
  fail "simulate with ulimit -f: $code: $(cat err)"
expected=4
whole_records 'simulate with ulimit -f'

# --- the other exit codes -------------------------------------------------------------------------------------------
ends() { # code, pattern of stderr, command
  rm -rf out && mkdir out
  code=0
  bash -c "$3" >stdout 2>err </dev/null || code=$?
  drop_progress err
  checks+=1
  [[ $code == "$1" ]] || fail "$3: exit code $code, not $1: $(cat err)"
  grep -qE "$2" err || fail "$3: stderr is: $(cat err)"
  [[ $(wc -l <err) -le 1 ]] || fail "$3: not one line: $(cat err)"
  ! grep -qwiE 'nan|inf' stdout || fail "$3: not a number on stdout"
}
ends 1 '^calibrate: bad.csv:3: en = 2: must be in' 'calibrate --targets bad.csv'
ends 1 'gate failed: lammps is installed' "PATH=/none $bin/verify engines --require lammps"
ends 2 '^calibrate: --en = 2: must be in' 'calibrate --tcol 1e-4 --en 2'
ends 2 '^calibrate: none.csv: cannot be read' 'calibrate --targets none.csv'
ends 2 '^calibrate: none.csv: cannot be read' 'calibrate --fit none.csv'
ends 2 '^verify: ' 'verify nothing'
ends 2 '^verify: --format = xml: must be' 'verify tcol --format xml'
ends 2 '^simulate: none.json: cannot be read' 'simulate none.json -o out/x'
ends 2 '^simulate: ' 'simulate source/data/scenes/bounce.json'
ends 2 '^simulate: out/x/state.json: cannot be read' 'simulate source/data/scenes/bounce.json -o out/x --resume'
ends 3 '^calibrate: --en = 0.001: must be in .* with --law fractional --end overlap' \
  'calibrate --tcol 1e-4 --en 0.001 --law fractional --end overlap'
ends 4 'gnuplot: not found' "PATH=/none $bin/verify figures --figures out"
ends 4 'gnuplot: not found' "PATH=/none $bin/calibrate --tcol 1e-4 --en 0.5 --report out/page.html"

echo "$checks endings looked at"
((failures == 0)) || { echo "endings.sh: $failures failures" >&2; exit 1; }
((skipped == 0)) || exit 77
