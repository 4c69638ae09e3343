#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# fetch_headers.sh FOLDER: the headers of GRANULAR that Debian's liblammps-dev leaves out, from the source package of
# the version that is installed (132 MB, read and thrown away). They are LAMMPS's and stay in the build folder.
# RICOCHET_MIRROR names another Debian mirror. Needs apt-get and dpkg-dev, not root. Exit code 4: not to be had.
set -euo pipefail
folder=$1

fail() {
  echo "fetch_headers.sh: $*" >&2
  exit 4
}
version=$(dpkg-query -W -f '${source:Version}' liblammps-dev 2>/dev/null) || fail "liblammps-dev is not installed"
complete=$folder/.complete-$version
[[ ! -e $complete ]] || exit 0
rm -f "$folder"/*.h "$folder"/.complete* # of another version
release=$(. /etc/os-release && echo "${VERSION_CODENAME:-}")
mkdir -p "$folder"
work=$(mktemp -d "$folder/source.XXXXXX")
trap 'rm -rf "$work"' EXIT
cd "$work"

# Lists of its own: those of the system stay as they are, and need no line for sources.
mkdir lists
echo "deb-src ${RICOCHET_MIRROR:-http://deb.debian.org/debian} $release main" >sources.list
apt=(apt-get -q -o Dir::Etc::SourceList="$work/sources.list" -o Dir::Etc::SourceParts=-
  -o Dir::State::Lists="$work/lists" -o Dir::Cache::pkgcache= -o Dir::Cache::srcpkgcache= -o APT::Sandbox::User=)
"${apt[@]}" update >log 2>&1 && "${apt[@]}" source --tar-only --download-only "lammps=$version" >>log 2>&1 ||
  { tail -n 5 log >&2; fail "no source package lammps $version of $release"; }
tar -xf lammps_*.orig.tar.* --strip-components=2 --wildcards --no-anchored \
  'src/GRANULAR/gran*.h' 'src/GRANULAR/pair_granular.h'
cp GRANULAR/*.h "$folder"
touch "$complete"
