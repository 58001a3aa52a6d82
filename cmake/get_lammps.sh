#!/usr/bin/env bash
# Gets LAMMPS's sources from Debian's source package and prints the folder of the tree.
#
#   cmake/get_lammps.sh [20250204 | 20260704]
#
# The tree is kept in the cache folder (see cache_folder in setup.sh) and fetched only once.
# apt is the client, with a configuration of its own: nothing of the system's apt is changed,
# and no root is needed.  Fails where there is no apt or no Debian archive that has it.

set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/setup.sh"

version=${1:-20250204}
case $version in
  20250204)    # 4 Feb 2025: what LBM-IBB is developed with; stays in Debian stable
    suites="trixie"
    archive=lammps_20250204+dfsg.1.orig.tar.xz
    sha256=3671165bd52fad36734e0a9136c5bc5ecb225e03988f8c89aa13366a8b53b1c7
    top=lammps-4Feb2025/ ;;
  20260704)    # 4 Jul 2026: a newer one to test against; Debian replaces it in time
    suites="forky sid"
    archive=lammps_20260704+dfsg.orig.tar.gz
    sha256=cddbc45a047416bd48a4a0b87f24a5b61b3446982b74d18cafe619c22b17eb62
    top= ;;
  *) die "get_lammps.sh knows the versions 20250204 and 20260704, not '$version'" ;;
esac

cache=$(cache_folder)
tree=$cache/lammps-$version
mkdir -p "$cache"
lock "$tree.lock"    # two builds that start at once: the second waits and finds the tree
if [ -e "$tree/src/version.h" ]; then
  echo "$tree"
  exit
fi
command -v apt-get >/dev/null || die "no apt-get here: cannot use Debian's source package"

work=$(mktemp -d "$cache/download.XXXXXX")
trap 'rm -rf "$work"' EXIT

# The addresses of the system's own Debian archive, whatever the format of its sources.
archives() {
  if [ -n "${LBMIBB_DEBIAN_MIRROR:-}" ]; then
    echo "$LBMIBB_DEBIAN_MIRROR"
    return
  fi
  local codename
  codename=$(sed -n 's/^VERSION_CODENAME=//p' /etc/os-release)
  # shellcheck disable=SC2016  # $(...) are apt's fields
  apt-get indextargets --no-release-info --format '$(RELEASE) $(REPO_URI)' 2>/dev/null |
    awk -v release="$codename" '$1 == release && !seen[$2]++ { print $2 }'
}

# fetch URI SUITE: leaves the archive in $work
fetch() {
  local apt=(apt-get -qq
    -o Dir::Etc::sourcelist="$work/sources.list" -o Dir::Etc::sourceparts=-
    -o Dir::State::lists="$work/lists" -o Dir::Cache="$work/cache"
    -o Dir::State::status="$work/status"    # empty, or apt insists on the installed version
    -o APT::Sandbox::User=root -o Acquire::Retries=3
    # an older system may lack the key of a newer release: the checksum below decides
    -o Acquire::AllowInsecureRepositories=true)
  echo "deb-src $1 $2 main" > "$work/sources.list"
  mkdir -p "$work/lists/partial" "$work/cache/archives/partial"
  : > "$work/status"
  "${apt[@]}" update >&2 || true
  # without the .dsc file, which not every mirror serves
  apt+=(source --download-only --tar-only --allow-unauthenticated lammps)
  "${apt[@]}" --print-uris 2>/dev/null | grep -qF " $archive " || return    # another version
  (cd "$work" && "${apt[@]}" -q=0 >&2)
}

for uri in $(archives); do
  for suite in $suites; do
    say "downloading LAMMPS $version from $uri ($suite)"
    if fetch "$uri" "$suite"; then
      break 2
    fi
  done
done
[ -s "$work/$archive" ] || die "LAMMPS $version is not to be had from Debian's archive"
sha256sum --check --quiet - <<< "$sha256  $work/$archive" >&2 || {
  say "wrong checksum of $archive"
  exit 3    # not the same as not to be had
}

say "unpacking LAMMPS $version"
mkdir "$work/tree"
parts=()
for part in src cmake unittest tools doc potentials lib python; do
  parts+=("$top$part")
done
strip=0
if [ -n "$top" ]; then strip=1; fi
tar --no-same-owner -x -f "$work/$archive" -C "$work/tree" --strip-components="$strip" "${parts[@]}"
mv "$work/tree" "$tree"    # all of it or nothing
echo "$tree"
