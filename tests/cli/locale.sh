#!/usr/bin/env bash
# locale.sh BIN SOURCE HOST_LOCALE: a locale of decimal commas changes no byte of what programs print and write, nor
# what they read. HOST_LOCALE is a library that, preloaded, makes the programs adopt the locale, which by themselves
# they don't.
set -euo pipefail
source "$(dirname "$0")/same_files.sh"
bin=$(realpath "$1") source=$(realpath "$2") host_locale=$(realpath "$3")
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
fail() { echo "locale.sh: $*" >&2; exit 1; }

command -v localedef >/dev/null || { echo 'skipped: localedef is missing'; exit 77; }
mkdir locales
localedef -i de_DE -f UTF-8 locales/de_DE.UTF-8 2>/dev/null ||
  { echo "skipped: localedef cannot make de_DE (Debian's package locales)"; exit 77; }
export LC_ALL=C LOCPATH=$folder/locales PATH=$bin:$PATH
export ASAN_OPTIONS=${ASAN_OPTIONS:+$ASAN_OPTIONS:}verify_asan_link_order=0
german=(env LC_ALL=de_DE.UTF-8 LD_PRELOAD="$host_locale")
[[ $(SHOW_LOCALE=1 "${german[@]}" calibrate --version 2>&1 >/dev/null) == 0,5* ]] ||
  fail 'the locale has no decimal comma'

# Another digit, another word, another exit code: all would show. out/ is where commands write.
same() {
  local code_c=0 code_de=0
  mkdir out
  "$@" >out/stdout 2>out/stderr </dev/null || code_c=$?
  rm -rf out_c
  mv out out_c
  mkdir out
  "${german[@]}" "$@" >out/stdout 2>out/stderr </dev/null || code_de=$?
  [[ $code_c == "$code_de" ]] || fail "$*: exit codes $code_c and $code_de: $(cat out/stderr)"
  same_files out_c out || fail "$*: differs"
  rm -rf out
}

target=(--tcol 1e-4 --en 0.5)
for format in table json csv markdown; do same calibrate "${target[@]}" --format $format; done
for engine in liggghts lammps yade mercurydpm mfix; do
  same calibrate --tcol 1.5e-4 --en 0.25 --radius 0.0015 --density 1250.5 --export $engine
done
same calibrate "${target[@]}" --law fractional --report out/page.html
same calibrate --tcol 1e-4 --en 0,5
same calibrate --tcol 1e-4 --en 1.5
same calibrate --fit "$source/data/restitution_ice_bridges1984.csv" --figures out
same calibrate --fit "$source/data/restitution_ice_hatzes1988.csv" --alpha-of-speed --format json
same calibrate --targets "$source/data/targets.csv"
printf 'tcol,en\n1.5e-4,0.25\n"1,5e-4",0.5\n' >comma.csv
same calibrate --targets comma.csv -o out/rows.csv
same verify tcol --format csv
same verify table1 --format json
same verify figures --figures out
mkdir scene
sed 's/"duration": 0.5/"duration": 0.05/' "$source/data/scenes/bounce.json" >scene/bounce.json
same simulate scene/bounce.json -o out/run
same simulate "$source/data/scenes/column.json" -o out/run
sed 's/"duration": 0.05/"duration": 0,05/' scene/bounce.json >scene/comma.json
same simulate scene/comma.json -o out/run

# LIGGGHTS reads numbers by the C library: not under a host's locale, but under the user's it must be what it is in C.
[[ -x $bin/liggghts-ricochet ]] || { echo 'skipped: liggghts-ricochet (not built)'; exit 0; }
export OMPI_MCA_ess_singleton_isolated=1 OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
{
  printf '%s\n' 'atom_style granular' 'atom_modify map array sort 0 0' 'boundary f f f' 'newton off' \
    'communicate single vel yes' 'units si' 'region box block -0.02 0.02 -0.02 0.02 -0.02 0.02 units box' \
    'create_box 1 box' 'neighbor 0.0015 bin' 'neigh_modify delay 0'
  calibrate "${target[@]}" --radius 0.0015 --density 1000 --law fractional --export liggghts
  printf '%s\n' 'create_atoms 1 single -0.0015001 0 0 units box' 'create_atoms 1 single 0.0015001 0 0 units box' \
    'set group all diameter 0.003 density 1000' 'set atom 1 vx 0.25' 'set atom 2 vx -0.25' 'timestep 1e-6' \
    'fix integrate all nve/sphere' 'thermo_style custom step atoms ke' 'thermo 100' \
    'dump out all custom 10 out/dump id x vx fx' \
    'dump_modify out format "%d %.17g %.17g %.17g"' 'run 300'
} >deck
german=(env LC_ALL=de_DE.UTF-8)
# Of what it prints the rows of numbers: dates and durations differ from run to run.
deterministic() { liggghts-ricochet -in deck -log none | grep -E '^ +[0-9]+ +2 '; }
export -f deterministic
same bash -c 'set -o pipefail; deterministic'
[[ $(wc -l <out_c/dump) -gt 300 ]] || fail "liggghts-ricochet wrote little: $(cat out_c/stdout)"
