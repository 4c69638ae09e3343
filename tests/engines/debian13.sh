#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# debian13.sh COMMAND [ARGUMENT…]    runs the command, for which `lmp` is the LAMMPS of Debian 13 (4 Feb 2025) and,
#                                    where it is installed, `yade` its Yade (2025.2.0)
# debian13.sh --make                 makes the system that it runs in: needs root, debootstrap and a Debian mirror;
#                                    minutes
# The system is in $RICOCHET_DEBIAN13, by default /var/tmp/ricochet-debian-13, outside of every checkout. Where there is
# none the test is skipped (exit code 77) and says so.
set -euo pipefail
system=${RICOCHET_DEBIAN13:-/var/tmp/ricochet-debian-13}
mirror=${RICOCHET_MIRROR:-http://deb.debian.org/debian}

skip() {
  echo "SKIPPED: $*"
  exit 77
}

if [[ ${1:-} == --make ]]; then
  if ! command -v debootstrap >/dev/null; then
    echo "debian13.sh: debootstrap is missing: apt-get install debootstrap" >&2
    exit 4
  fi
  exec debootstrap --variant=minbase --include=lammps,yade trixie "$system" "$mirror"
fi
[[ -x $system/usr/bin/lmp ]] || skip "no LAMMPS of Debian 13 in $system; tests/engines/debian13.sh --make makes it"
((EUID == 0)) || skip "only root can enter the system in $system"
said=$(chroot "$system" lmp -h 2>/dev/null || true)
[[ $said == *"4 Feb 2025"* ]] || skip "$system/usr/bin/lmp does not run here, or is of another version"

programs=$(mktemp -d) scratch=$(mktemp -d "$system/tmp/ricochet.XXXXXX")
trap 'rm -rf "$programs" "$scratch"' EXIT
# The programs' scratch folders are inside the system, so that the engine finds them under the rest of their path.
for program in lmp yade; do
  [[ -x $system/usr/bin/$program ]] || continue
  cat >"$programs/$program" <<WRAPPER
#!/bin/sh
exec chroot "$system" /bin/sh -c 'cd "\$1" && shift && exec $program "\$@"' sh "\${PWD#$system}" "\$@"
WRAPPER
  chmod +x "$programs/$program"
done
TMPDIR=$scratch PATH=$programs:$PATH "$@"
