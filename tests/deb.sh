#!/usr/bin/env bash
# Installs the Debian package on a bare machine, a minimal Debian 12 in a folder of its own, as README.md says, and renders there;
# then makes the package anew, which must have the same bytes. Only root can run it.
#
#   tests/deb.sh [PACKAGE]   by default the package that `make deb` has left in build/deb
#
#   --folder DIR   make the machine in DIR, which mustn't exist yet, instead of in a folder of temporary files
#   --base DIR     copy Debian's base from DIR; where there is none yet, make it there first, and leave it
#   --keep         leave the machine when done, to look into it with chroot
#
# Exit status: 0 all went well; 1 something failed; 2 wrong arguments; 77 skipped, as no such machine can be made here; 129, 130 or
# 143 interrupted.
set -euo pipefail
root=$(cd "$(dirname "$0")/.." && pwd)
label="package"
# shellcheck source=tests/bare_debian.sh
. "$root/tests/bare_debian.sh"

package=$(echo "$root"/build/deb/*.deb) words=0
while [ $# -gt 0 ]; do
  case $1 in
    -*) option "$@" ;;
    *) package=$(realpath "$1") words=1 ;;
  esac
  shift $words
done
[ -f "$package" ] || refuse "there is no $package: make deb makes it"
require_means

# README's line that installs the package.
install_line() {
  local line
  line=$(sed -nE 's/ *#.*//; s/^(sudo )?(apt install .*\.deb)$/\2/p' "$root/README.md" | head -n 1)
  [ -n "$line" ] || fail "README.md has no line that installs the package"
  [ "${line##*/}" = "${package##*/}" ] || fail "README.md installs ${line##*/}, and the package is ${package##*/}"
  echo "${line/ install/ install -q -y --no-install-recommends}"
}

# Whatever lintian calls an error.
if command -v lintian >/dev/null; then
  lintian --allow-root --fail-on error "$package" || fail "lintian finds errors"
  say "lintian finds no error"
fi
line=$(install_line)
make_machine
connect
cp "$package" "$folder/root/"
on_machine "export DEBIAN_FRONTEND=noninteractive; apt-get update -q && $line"
on_machine "rotatebook doctor -o /tmp | tail -n 1 | tee -a /dev/stderr | grep -q '^Ready to render'"
on_machine "rotatebook render /usr/share/rotatebook/scenes/starter.toml -o clips --quiet --no-png"
on_machine "rotatebook verify clips/starter.mp4"
on_machine "rotatebook new my.toml >/dev/null && head -n 1 my.toml | grep -x '#:schema file:///usr/share/rotatebook/scene.schema.json' && test -s /usr/share/rotatebook/scene.schema.json"
# The live book is in the package if it was made before.
on_machine "test ! -e /usr/share/rotatebook/play.html || { timeout -s INT 10 rotatebook watch /usr/share/rotatebook/scenes/starter.toml --live -o starter.png; test -s starter.live.html; }"
on_machine "test -s /usr/share/bash-completion/completions/rotatebook && zgrep -q '^.SH COMMANDS' /usr/share/man/man1/rotatebook.1.gz"
on_machine "apt-get purge -q -y rotatebook >/dev/null && test ! -e /usr/share/rotatebook"
if [ "$package" = "$root/build/deb/${package##*/}" ]; then
  touch "$root/build/release/rotatebook"  # Another time of its files.
  make -s -C "$root" deb >/dev/null
  cmp "$package" "$folder/root/${package##*/}" || fail "made twice, the package has other bytes"
  say "made twice, it has the same bytes"
fi
say "passed: ${package##*/}, $(($(stat -c %s "$package") / 1000000)) MB, in $SECONDS s"
