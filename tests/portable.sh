#!/usr/bin/env bash
# Runs the portable folder on a bare machine: a minimal Debian 12 without Mesa, fonts, /dev/dri and HOME, as root and as nobody. It
# looks for devices, renders, and proves what it rendered, and each file must be that of the program that the folder was made from.
# The machine is made by the Dockerfile's steps, and README's line unpacks and runs the archive here.
#
#   tests/portable.sh [ARCHIVE]   by default the archive that `make portable` has left in build/portable
#
#   --program FILE  compare with this program's files; by default build/release/rotatebook
#   --folder DIR    make the machine in DIR, which mustn't exist yet, instead of in a folder of temporary files
#   --base DIR      copy Debian's base from DIR; where there is none yet, make it there first, and leave it
#   --keep          leave the machine when done, to look into it with chroot
#
# Exit status: 0 all went well; 1 something failed; 2 wrong arguments; 77 skipped, as no such machine can be made here; 129, 130 or
# 143 interrupted.
set -euo pipefail
root=$(cd "$(dirname "$0")/.." && pwd)
label="portable"
# shellcheck source=tests/bare_debian.sh
. "$root/tests/bare_debian.sh"

program=$root/build/release/rotatebook archive="" words=0
while [ $# -gt 0 ]; do
  case $1 in
    --program) [ $# -gt 1 ] || refuse "$1 needs a file"; program=$(realpath "$2") words=2 ;;
    -*) option "$@" ;;
    *) archive=$(realpath "$1") words=1 ;;
  esac
  shift $words
done
[ -x "$program" ] || refuse "there is no $program"
name=rotatebook-$("$program" --version | cut -d' ' -f2)-x86_64-linux
archive=${archive:-$root/build/portable/$name.tar.xz}
[ -f "$archive" ] || refuse "there is no $archive: make portable makes it"
require_means
readonly scene=share/rotatebook/scenes/starter.toml
readonly small=(--size 320x180 --set clip.duration=2 --set 'overlay.show=["caption","clock","axes"]')

# Runs the folder's program on the machine as a user, by a symbolic link in PATH: on_machine USER [NAME=VALUE...] -- WORD...
on_machine() {
  local user=$1 variables=() status=0
  shift
  while [ "$1" != -- ]; do variables+=("$1"); shift; done
  shift
  # shellcheck disable=SC2016  # The inner shell's.
  apart sh -c 'mount -t proc proc "$0/proc" && exec chroot "$@"' "$folder" --userspec="$user" "$folder" env -i PATH=/usr/bin:/bin "${variables[@]}" sh -c 'cd "/opt/$0" && exec rotatebook "$@"' "$name" "$@" </dev/null || status=$?
  [ $status = 0 ] || fail "$user: ${variables[*]} rotatebook $* (exit status $status)"
}

# Makes a container of the machine, by the steps of the Dockerfile: Docker itself needn't be here.
unpack() {
  local step words
  while read -r step words; do
    case $step in
      FROM) [[ $words == debian:12* ]] || fail "the machine is Debian 12, and the Dockerfile's $words" ;;
      ADD)
        # shellcheck disable=SC2053  # A pattern.
        [[ $root/build/portable/${archive##*/} == $root/${words% *} ]] || fail "the Dockerfile doesn't add ${archive##*/}"
        mkdir -p "$folder${words#* }" && tar -xf "$archive" -C "$folder${words#* }" ;;
      RUN) chroot "$folder" sh -c "$words" || fail "$words" ;;
      ENTRYPOINT) [ "$words" = '["rotatebook"]' ] || fail "the container runs $words" ;;
      "" | "#"* | WORKDIR | CMD) ;;
      *) fail "what is $step in the Dockerfile?" ;;
    esac
  done <"$root/Dockerfile"
  [ ! -e "$folder/dev/dri" ] || fail "the machine has /dev/dri"
  [ ! -e "$folder/etc/fonts" ] || fail "the machine has fonts"
}

# README's line that unpacks and runs, here, as the machine has no xz.
run_line() {
  local line
  line=$(sed -n 's/ *#.*//; /^tar -xf /p' "$root/README.md")
  mkdir "$temporary/line"
  ln -s "$archive" "$temporary/line/"
  env -C "$temporary/line" sh -c "$line" >"$temporary/doctor" || { cat "$temporary/doctor"; fail "$line"; }
  grep -q '^Ready to render' "$temporary/doctor" || fail "$line"
  rm -r "$temporary/line"
  say "done: $line"
}

# The files of the program that is here, from the folder's scene.
render_here() {
  env -C "$folder/opt/$name" "$program" render $scene -o "$temporary/here" "${small[@]}" --quiet ||
    fail "the program here doesn't render"
}

# Each file of both renders, and no others, are equal: frames, MP4, tables and what is recorded about them.
compare() {
  diff -r "$temporary/here" "$folder/tmp/$1" || fail "$1: the files differ from those of the program here"
  say "$1: $(find "$folder/tmp/$1" -type f | wc -l) files equal those of the program here"
}

# Doctor finds the folder's own renderer, and nothing that the user should change.
check_doctor() {
  on_machine "$1" -- doctor -o /tmp >"$temporary/doctor"
  grep -q '^ *EGL device 0 *llvmpipe .*draws by default' "$temporary/doctor" || { cat "$temporary/doctor"; fail "$1: doctor"; }
  grep -q '^Ready to render' "$temporary/doctor" || { cat "$temporary/doctor"; fail "$1: doctor"; }
  say "$1: $(tail -n 1 "$temporary/doctor")"
}

# Whatever is loaded comes from the folder, but for glibc.
check_libraries() {
  local others
  on_machine root LD_DEBUG=files -- still $scene --time 1 -o /tmp/still.png "${small[@]:0:2}" >"$temporary/loaded" 2>&1
  grep -q "calling init: /opt/$name/lib/dri/swrast_dri.so" "$temporary/loaded" || fail "the folder's driver isn't loaded"
  others=$(sed -n 's/.*calling init: //p' "$temporary/loaded" | sort -u | grep -vE "^/opt/$name/(bin/\.\./)?lib/" |
    grep -vE '/(lib(c|m|mvec|dl|pthread|rt|resolv|util)|ld-linux-x86-64)\.so\.[0-9]+$' || true)
  [ -z "$others" ] || fail "libraries from elsewhere: $others"
}

# A cluster's LD_LIBRARY_PATH doesn't change what is loaded, and the user's variables count.
check_variables() {
  mkdir -p "$folder/opt/others"
  echo "no library" | tee "$folder/opt/others/libpng16.so.16" >"$folder/opt/others/libEGL_mesa.so.0"
  on_machine nobody LD_LIBRARY_PATH=/opt/others -- still $scene --time 1 -o /tmp/other.png "${small[@]:0:2}" --quiet
  cmp "$folder/tmp/still.png" "$folder/tmp/other.png" || fail "LD_LIBRARY_PATH changes the picture"
  if (on_machine root __EGL_VENDOR_LIBRARY_FILENAMES=/none.json -- doctor -o /tmp) >"$temporary/doctor" 2>&1; then
    fail "the user's __EGL_VENDOR_LIBRARY_FILENAMES doesn't count"
  fi
  grep -q "unset __EGL_VENDOR_LIBRARY_FILENAMES" "$temporary/doctor" || { cat "$temporary/doctor"; fail "no remedy"; }
}

make_machine
unpack
run_line
render_here
for user in root nobody; do
  check_doctor $user
  began=$SECONDS
  on_machine $user -- render $scene -o /tmp/$user "${small[@]}" --quiet
  say "$user: rendered in $((SECONDS - began)) s"
  compare $user
  on_machine $user -- verify "/tmp/$user/starter.mp4" >"$temporary/verified"
  say "$user: $(grep -m 1 -i proved "$temporary/verified")"
done
check_libraries
check_variables
say "passed: $name in $SECONDS s"
