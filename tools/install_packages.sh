#!/usr/bin/env bash
# install_packages.sh [SECTION]: installs the packages of packages.txt that are missing,
# up to and including SECTION (default: all). Does nothing when nothing is missing.
set -euo pipefail
cd "$(dirname "$0")/.."
section=${1:-}

if [[ -n $section ]] && ! grep -q "^\[$section\]" packages.txt; then
  echo "install_packages.sh: packages.txt has no section [$section]" >&2
  exit 2
fi
mapfile -t wanted < <(awk -v last="[$section]" '
  /^\[/ { if (done) exit; done = ($1 == last); next }
  { sub(/#.*/, "") } NF { print $1 }' packages.txt)

if ! command -v dpkg-query >/dev/null; then
  echo "install_packages.sh: not a Debian system; install by hand what packages.txt names" >&2
  exit 1
fi
installed=$(dpkg-query -W -f='${Package} ${db:Status-Status}\n' "${wanted[@]}" 2>/dev/null || true)
missing=()
for package in "${wanted[@]}"; do
  grep -qx "$package installed" <<<"$installed" || missing+=("$package")
done
((${#missing[@]})) || exit 0

as_root=()
if ((EUID != 0)); then
  if ! command -v sudo >/dev/null; then
    echo "install_packages.sh: neither root nor sudo; ask for: apt-get install ${missing[*]}" >&2
    exit 1
  fi
  as_root=(sudo)
fi
"${as_root[@]}" apt-get update -q
"${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
  apt-get install -q -y --no-install-recommends "${missing[@]}" </dev/null
