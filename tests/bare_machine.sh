#!/usr/bin/env bash
# Follows the README on a bare machine: a minimal Debian 12 in a folder of its own, in which nothing is installed but git, make
# and ca-certificates. It takes what is committed, and the commands from README.md as they are there. Only root can run it.
#
#   tests/bare_machine.sh             make render, make figures and make test: 20 to 60 minutes, 14 GB
#   tests/bare_machine.sh --quick     make render alone, which is set-up, build and one clip: 3 to 6 minutes, 3 GB
#
#   --folder DIR   make the machine in DIR, which mustn't exist yet, instead of in a folder of temporary files
#   --base DIR     copy Debian's base from DIR; where there is none yet, make it there first, and leave it
#   --keep         leave the machine when done, to look into it with chroot
#
# From this machine it takes Debian's package sources with apt's settings for fetching, http_proxy and the like, how names of
# hosts are resolved, and the certificates in /usr/local/share/ca-certificates. It has /proc, as every machine does and fonts are
# read through it, and terminals (/dev/pts) where they can be had; but no /sys, no /dev/shm of its own, no TERM, no locale.
# All mounts and processes are in namespaces of their own, and end with them.
#
# Exit status: 0 all went well; 1 a command failed; 2 wrong arguments; 77 skipped, as no such machine can be made here; 129, 130 or
# 143 interrupted.
set -euo pipefail
root=$(cd "$(dirname "$0")/.." && pwd)
label="bare machine"
# shellcheck source=tests/bare_debian.sh
. "$root/tests/bare_debian.sh"

commands="render figures test" words=0
while [ $# -gt 0 ]; do
  case $1 in
    --quick) commands=render words=1 ;;
    *) option "$@" ;;
  esac
  shift $words
done
require_means

# The README's first command `make WORD ...`, from its blocks of code.
readme_command() {
  local line
  line=$(awk -v start="^make $1( |\$)" '/^ *```/ {fenced = !fenced}
    (fenced || /^    /) {sub(/ *(#.*)?$/, ""); sub(/^ *(\$ )?/, ""); if ($0 ~ start) {print; exit}}' "$root/README.md")
  [ -n "$line" ] || fail "README.md has no command: make $1"
  echo "$line"
}

[ -z "$(git -C "$root" status --porcelain)" ] || say "what isn't committed is left out"
make_machine
connect
git clone --quiet --bare "file://$root" "$folder/root/rotatebook.git"

on_machine "export DEBIAN_FRONTEND=noninteractive; apt-get update -q && apt-get install -q -y --no-install-recommends git make ca-certificates"
on_machine "git clone --quiet rotatebook.git rotatebook"
for command in $commands; do
  line=$(readme_command "$command")
  on_machine "$line"
  [ "$command" != render ] || on_machine "build/release/rotatebook doctor"
done
say "passed: $(git -C "$root" rev-parse --short HEAD), make $(echo $commands | sed 's/ /, make /g') in $SECONDS s"
