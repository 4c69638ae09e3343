#!/usr/bin/env bash
# script.sh SOURCE: what ./ricochet does before it builds, in a checkout of its own, with cmake and dpkg-query played.
set -euo pipefail
source=$(realpath "$1")
umask 022 # somebody else runs the script here
folder=$(realpath "$(mktemp -d)")
chmod 755 "$folder"
trap 'rm -rf "$folder"' EXIT
declare -i failures=0
fail() { echo "script.sh: $*" >&2; failures+=1; }
says() { grep -qF -- "$2" "$1" || fail "$3: said $(cat "$1")"; }

mkdir -p "$folder/house" "$folder/bin"
cp "$source/ricochet" "$source/CMakeLists.txt" "$folder/house"
cat >"$folder/bin/cmake" <<'EOF'
#!/bin/sh
echo "cmake $*" >>"$PLAYED"
case "$1" in --preset) mkdir -p build/release/bin && for program in calibrate bench_played; do
  printf '#!/bin/sh\necho ran\n' >build/release/bin/$program && chmod +x build/release/bin/$program
done ;; esac
EOF
# Every package that is asked for is there.
cat >"$folder/bin/dpkg-query" <<'EOF'
#!/bin/sh
for word; do case $word in -*|*'{'*) ;; *) echo "$word installed" ;; esac; done
EOF
chmod +x "$folder/bin/cmake" "$folder/bin/dpkg-query"
export PATH=$folder/bin:$PATH PLAYED=$folder/played
cd "$folder/house"

for command in test bench; do
  ./ricochet "$command" --help >../out 2>../err || fail "$command --help: exit code $?"
  says ../out "./ricochet $command [" "$command --help"
  [[ ! -s ../err && ! -e build ]] || fail "$command --help: built, or said $(cat ../err)"
done

# A build folder that came along with a copy.
mkdir -p build/release/CMakeFiles
touch build/release/CMakeFiles/old build/release/.stamp-new.abcdef
echo 'CMAKE_HOME_DIRECTORY:INTERNAL=/somewhere/else' >build/release/CMakeCache.txt
./ricochet calibrate >../out 2>../err || fail "moved checkout: exit code $?: $(cat ../err)"
says ../err 'ricochet: build/ is of a checkout in /somewhere/else: configuring anew' 'moved checkout'
[[ ! -e build/release/CMakeFiles/old ]] || fail 'moved checkout: the old configuration stayed'
[[ -z $(find build/release -name '.stamp-new.*') ]] || fail 'a stamp of a build that was stopped stayed'
says "$PLAYED" 'cmake --preset release -DRICOCHET_TESTS=OFF' 'moved checkout'
[[ $(cat ../out) == ran ]] || fail "the program did not run: $(cat ../out)"

# One of its own stays.
echo "CMAKE_HOME_DIRECTORY:INTERNAL=$PWD" >build/release/CMakeCache.txt
touch CMakeLists.txt
./ricochet calibrate >../out 2>../err || fail "own build: exit code $?"
[[ -e build/release/CMakeCache.txt ]] || fail 'own build: its configuration is gone'

# Without the packages of the tests: a first build leaves the tests out, a later one lets them stay as they are.
for first in yes no; do
  if [[ $first == yes ]]; then rm -rf build
  else echo "CMAKE_HOME_DIRECTORY:INTERNAL=$PWD" >build/release/CMakeCache.txt; fi
  : >"$PLAYED"
  ./ricochet bench >../out 2>../err || fail "bench: exit code $?: $(cat ../err)"
  says "$PLAYED" '-DRICOCHET_BENCH=ON' bench
  [[ $first == no ]] || says "$PLAYED" '-DRICOCHET_TESTS=OFF' 'first bench'
  [[ $first == yes ]] || ! grep -q RICOCHET_TESTS "$PLAYED" || fail "later bench: $(cat "$PLAYED")"
  [[ $(cat ../out) == ran ]] || fail "the benchmark did not run: $(cat ../out)"
done
rm -rf build
: >"$PLAYED"
./ricochet test >../out 2>../err || true # no ctest of its own here
grep -q -- '-DRICOCHET_TESTS=OFF.* -DRICOCHET_TESTS=ON' "$PLAYED" || fail "test: the tests are not asked for last"

# Somebody else's build folder. Root may write everywhere.
as_other=()
if ((EUID == 0)); then as_other=(setpriv --reuid=65534 --clear-groups); else chmod -w build build/release; fi
touch CMakeLists.txt
code=0
"${as_other[@]}" ./ricochet calibrate >../out 2>../err || code=$?
[[ $code == 4 ]] || fail "another user's build folder: exit code $code: $(cat ../err)"
says ../err "ricochet: cannot write to $PWD/build, which is of $(id -un)" "another user's build folder"
chmod -R u+w build
((failures == 0))
