#!/bin/sh
# Installs the packages of sections of packages.txt (program by default) that are missing; says the
# command and stops where it may not.
set -eu
list=$(dirname "$0")/packages.txt
[ $# -gt 0 ] || set -- program

# Prints the packages that have the section.
packages_of() {
  awk -v section="$1" '{ sub(/#.*/, ""); for (i = 2; i <= NF; ++i) if ($i == section) print $1 }' "$list"
}

wanted=
for section in "$@"; do
  packages=$(packages_of "$section")
  [ -n "$packages" ] || { echo "setup: $section: $list has no such section; its beginning names them" >&2; exit 2; }
  wanted="$wanted $packages"
done

if ! command -v dpkg-query >/dev/null 2>&1; then
  echo "setup: not a Debian or Ubuntu machine; install what these packages hold, then run" \
       "'cmake --preset release' yourself, for the program alone with -DBUILD_TESTING=OFF:" $wanted >&2
  exit 3
fi

missing=
for package in $wanted; do
  status=$(dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null || true)
  [ "$status" = installed ] && continue
  # A program from elsewhere does as well, and its package may not go with it: npm comes with some nodejs.
  command -v "$package" >/dev/null 2>&1 || missing="$missing $package"
done
[ -n "$missing" ] || exit 0

install="apt-get install -y --no-install-recommends$missing"
if [ "$(id -u)" = 0 ]; then
  as_root=
elif command -v sudo >/dev/null 2>&1 && sudo -n true 2>/dev/null; then
  as_root="sudo -n"
else
  echo "setup: these packages are missing; run this as root, then try again:" >&2
  echo "  apt-get update && $install" >&2
  exit 3
fi

echo "setup: installing$missing"
$as_root apt-get update -qq
$as_root env DEBIAN_FRONTEND=noninteractive $install
