#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# debian13.sh make            makes the system and builds lammps-ricochet in it, which takes root, debootstrap, a Debian
#                             mirror ($RICOCHET_MIRROR) and some minutes
# debian13.sh verify VERIFY   runs `verify engines` with the LAMMPS of Debian 13 (4 Feb 2025), and with lammps-ricochet,
#                             which it builds there
# debian13.sh driver TEST     builds lammps-ricochet there and runs this test program with it
# debian13.sh lmp COMMAND…    runs a command for which `lmp` is that LAMMPS
# debian13.sh lammps-ricochet COMMAND…   builds that there and runs a command for which it is `lammps-ricochet`
# debian13.sh yade COMMAND…   runs a command for which `yade` is that of Debian 13 (2025.2.0), if it is installed there
# debian13.sh shell COMMAND   runs a command in the checkout's copy there, once the driver is built: for benchmarks
# The system is in $RICOCHET_DEBIAN13, by default /var/tmp/ricochet-debian-13, outside of every checkout, and stays for
# the next run. Where there is none, or none can be made, the test is skipped (exit code 77) and says why.
set -euo pipefail
system=${RICOCHET_DEBIAN13:-/var/tmp/ricochet-debian-13}
mirror=${RICOCHET_MIRROR:-http://deb.debian.org/debian}
root=$(cd "$(dirname "$0")/../.." && pwd)
task=${1:-} argument=${2:-}
readonly for_driver=(lammps liblammps-dev g++ cmake ninja-build dpkg-dev openmpi-bin libopenmpi-dev
  libboost-dev libeigen3-dev libgsl-dev libfmt-dev)

skip() {
  echo "SKIPPED: $*"
  exit 77
}

inside() { # COMMAND: in the system
  chroot "$system" env -i HOME=/root PATH=/usr/sbin:/usr/bin:/sbin:/bin LANG=C.UTF-8 DEBIAN_FRONTEND=noninteractive \
    RICOCHET_MIRROR="$mirror" bash -c "$1"
}

make_system() {
  [[ -e $system ]] || {
    [[ $task == make ]] || skip "no Debian 13 in $system; tests/engines/debian13.sh make makes it"
    command -v debootstrap >/dev/null || skip "no Debian 13 in $system, and debootstrap is not installed to make it"
    rm -rf "$system.new" # of a run that was stopped
    debootstrap --variant=minbase trixie "$system.new" "$mirror" >"$log" 2>&1 ||
      skip "debootstrap failed: $(tail -n 1 "$log")"
    mv "$system.new" "$system"
  }
  [[ $(inside '. /etc/os-release; echo $VERSION_CODENAME' 2>/dev/null) == trixie ]] || skip "$system is not Debian 13"
}

install_packages() { # PACKAGE…
  inside "dpkg-query -W -f '\${db:Status-Status}\n' $* 2>&1 | grep -qvx installed" || return 0
  cp /etc/resolv.conf "$system/etc/resolv.conf"
  inside "apt-get -q update && apt-get -q install -y --no-install-recommends $*" >"$log" 2>&1 ||
    skip "no packages for the system in $system: $(tail -n 1 "$log")"
}

# The sources go to the system as they are here, uncommitted changes and all. What is the same there is left alone: a
# build, which stays from run to run, goes by the files' dates.
copy_sources() {
  local checkout=$system/root/ricochet file
  mkdir -p "$work/sources" "$checkout"
  (cd "$root" && tar -c CMakeLists.txt CMakePresets.json cmake core console verify engines) | tar -x -C "$work/sources"
  while read -r file; do
    if [[ ! -e $work/sources/$file ]]; then rm "$checkout/$file"; fi
  done < <(cd "$checkout" && find . -path ./build -prune -o -type f -print)
  while read -r file; do
    cmp -s "$work/sources/$file" "$checkout/$file" && continue
    mkdir -p "$(dirname "$checkout/$file")"
    cp "$work/sources/$file" "$checkout/$file"
  done < <(cd "$work/sources" && find . -type f)
}

build_driver() {
  copy_sources
  inside 'cd /root/ricochet && cmake -S . -B build/lammps -G Ninja -DCMAKE_BUILD_TYPE=Release -DRICOCHET_PROGRAMS=OFF \
      -DRICOCHET_TESTS=OFF -DRICOCHET_INSTALL=OFF -DRICOCHET_LAMMPS=ON &&
    cmake --build build/lammps --target lammps-ricochet -j "$(nproc)"' >"$log" 2>&1 || { tail -n 40 "$log"; exit 1; }
}

((EUID == 0)) || skip "only root can enter the system in $system"
[[ $task == make || ($task =~ ^(verify|driver|lmp|lammps-ricochet|yade|shell)$ && $argument) ]] ||
  { sed -n 's/^# //; 4,12p' "$0" >&2; exit 2; }
mkdir -p "$(dirname "$system")"
exec 9>"$system.lock"
flock 9
work=$(mktemp -d) log=$work/log mounted=
tidy_up() {
  rm -rf "$work" ${scratch:+"$scratch"}
  if [[ $mounted ]]; then umount "$system/proc"; fi
}
trap tidy_up EXIT
make_system
# Open MPI looks for its processes there.
if ! mountpoint -q "$system/proc"; then
  mount -t proc proc "$system/proc" 2>"$log" || skip "cannot mount $system/proc: $(tail -n 1 "$log")"
  mounted=yes
fi
case $task in
  lmp) install_packages lammps ;;
  yade) [[ -x $system/usr/bin/yade ]] || skip "no Yade in $system, nearly 300 MB: apt-get install yade in it" ;;
  *) install_packages "${for_driver[@]}" ;;
esac
[[ $task == yade || $(inside 'lmp -h' 2>/dev/null || true) == *"4 Feb 2025"* ]] ||
  skip "$system/usr/bin/lmp does not run here, or is of another version"

# The programs' scratch folders are inside the system, so that the engine finds them under the rest of their path.
scratch=$(mktemp -d "$system/tmp/ricochet.XXXXXX")
write_wrapper() { # NAME COMMAND: runs it in the present folder, seen from inside
  cat >"$work/$1" <<WRAPPER
#!/bin/sh
exec chroot "$system" /usr/bin/env PATH=/usr/bin:/bin LANG=C.UTF-8 \
  /bin/sh -c 'cd "\$1" && shift && $2' sh "\${PWD#$system}" "\$@"
WRAPPER
  chmod +x "$work/$1"
}
case $task in
  verify)
    build_driver
    write_wrapper lmp 'exec lmp "$@"'
    write_wrapper lammps-ricochet 'exec /root/ricochet/build/lammps/bin/lammps-ricochet "$@"'
    # A copy beside that driver: the one beside the program itself is of another LAMMPS.
    cp "$argument" "$work/verify"
    TMPDIR=$scratch PATH=$work:$PATH "$work/verify" engines --engine lammps --require lammps lammps-ricochet
    ;;
  lmp | yade)
    write_wrapper "$task" "exec $task \"\$@\""
    shift
    TMPDIR=$scratch PATH=$work:$PATH "$@"
    ;;
  lammps-ricochet)
    build_driver
    write_wrapper "$task" 'exec /root/ricochet/build/lammps/bin/lammps-ricochet "$@"'
    shift
    TMPDIR=$scratch PATH=$work:$PATH "$@"
    ;;
  make) build_driver ;;
  driver)
    build_driver
    write_wrapper run 'ranks=$1 && shift && driver=/root/ricochet/build/lammps/bin/lammps-ricochet
      [ "$ranks" = 1 ] && exec "$driver" "$@"
      exec mpirun --allow-run-as-root --oversubscribe -np "$ranks" "$driver" "$@"'
    export RICOCHET_LAMMPS_RUN=$work/run RICOCHET_LAMMPS_RUNS=$scratch
    shift
    "$@"
    ;;
  shell)
    build_driver
    inside "cd /root/ricochet && $argument"
    ;;
esac
