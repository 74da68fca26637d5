#!/usr/bin/env bash
# Makes the portable folder, and its archive: the program with all libraries that it needs, Mesa's software rasteriser and a small
# FFmpeg among them. It runs on x86-64 Linux with a glibc no older than this machine's, without anything being installed.
#
#   scripts/portable.sh PROGRAM FOLDER   leaves FOLDER/rotatebook-VERSION-x86_64-linux and the same with .tar.xz
#
#   bin/rotatebook       finds ../lib by its DT_RPATH, which also serves libraries that libraries load, and comes before
#                        LD_LIBRARY_PATH; sets the variables that libraries read by itself (src/platform/system/portable_folder.h)
#   lib/, lib/dri/       all libraries but glibc's, which belongs to the system and its loader
#   share/, etc/         what libEGL, fontconfig and the program look for; scenes
#   licences/            of each Debian package that something comes from, and their versions
#
# Exit status: 0 done; 2 wrong arguments; 3 something is missing here.
set -euo pipefail
root=$(cd "$(dirname "$0")/.." && pwd)
readonly system=/usr/lib/x86_64-linux-gnu
# Loaded by name while the program runs, so that ldd of the program doesn't list them: by libepoxy, libEGL and Mesa.
readonly loaded=("$system/libEGL.so.1" "$system/libEGL_mesa.so.0" "$system/libGL.so.1" "$system/libOpenGL.so.0")
readonly driver=$system/dri/swrast_dri.so
# Compiled into the program: their packages' licences go with it.
readonly headers=(libeigen3-dev libtomlplusplus-dev libcli11-dev libxxhash-dev)

say() { echo "portable: $*"; }
fail() { say "$*" >&2; exit 3; }

# Which packages files come from, "PATH PACKAGE"; what is in /usr/lib may be listed as in /lib. One call, as each reads all lists.
owners() {
  { dpkg-query -S "$@" "${@#/usr}" 2>/dev/null || true; } | sed -nE 's|^([^:, ]+)[^/]*: (/usr)?(/.*)$|/usr\3 \1|p' | sort -u
}

# A library in place of one that LLVM names but that nothing here calls: stub SONAME < symbols, one a line, "NAME" or
# "NAME@VERSION". Each ends the program if it is called after all.
stub() {
  local source=$stubs/${1%%.*}.c
  sort -u >"$stubs/symbols"
  sed -E 's/@.*//; s/.*/void &(void) { __builtin_trap(); }/' "$stubs/symbols" >"$source"
  awk -F@ 'NF == 2 {of[$2] = of[$2] " " $1 ";"} END {for (version in of) print version " {" of[version] " };"}' \
    "$stubs/symbols" >"$stubs/versions"
  local script=()
  [ ! -s "$stubs/versions" ] || script=(-Xlinker "--version-script=$stubs/versions")
  cc -shared -fPIC -nostdlib -w -O1 -Xlinker "-soname=$1" "${script[@]}" -o "$stubs/$1" "$source"
}

# LLVM's solver and its reader of Windows manifests, of 23 MB and, with ICU's tables, 33 MB. Without them LLVM can't be loaded;
# shaders need neither.
make_stubs() {
  local llvm
  llvm=$(ldd "$driver" | sed -nE 's/.*(libLLVM[^ ]*) => ([^ ]+) .*/\2/p')
  [ -n "$llvm" ] || fail "$driver uses no LLVM: make the folder on Debian 12"
  rm -rf "$stubs"
  mkdir -p "$stubs"
  nm -D --undefined-only "$llvm" | awk '{print $2}' >"$stubs/undefined"
  grep '^Z3_' "$stubs/undefined" | stub libz3.so.4
  grep '@LIBXML2_' "$stubs/undefined" | stub libxml2.so.2
}

# What the program and the libraries that it loads need, "NAME PATH", as the loader finds it with our FFmpeg and the stubs. The
# program itself loads FFmpeg's, by the names that end in one number.
needed() {
  local file
  for file in "$program" "${loaded[@]}" "$driver" "$ffmpeg"/lib/*.so.*; do
    LD_LIBRARY_PATH=$stubs:$ffmpeg/lib ldd "$file"
  done | sed -nE 's/^\t([^ ]+) => (.+) \(0x.*/\1 \2/p; s/^\t([^ ]+) => not found/\1 missing/p' | sort -u
  for file in "${loaded[@]}" "$ffmpeg"/lib/*.so.[0-9] "$ffmpeg"/lib/*.so.[0-9][0-9]; do echo "$(basename "$file") $file"; done
}

# Copies a library, without a path of its own, which would switch that of the program off.
copy_library() {
  install -m 755 "$1" "$2"
  patchelf --remove-rpath "$2"
}

# Copies all libraries but those of glibc, and lists the packages that they come from.
copy_libraries() {
  local name path package paths
  needed | while read -r name path; do
    [ "$path" != missing ] || fail "$name isn't installed"
    echo "$name $(realpath "$path")"
  done | sort -u >"$made/needed"
  mapfile -t paths < <(cut -d' ' -f2 "$made/needed" && echo "$driver")
  owners "${paths[@]}" >"$made/owners"
  while read -r name path; do
    package=$(awk -v path="$path" '$1 == path {print $2; exit}' "$made/owners")
    case $path in "$stubs"/* | "$ffmpeg"/*) package=own ;; esac
    [ -n "$package" ] || fail "$path belongs to no package, so its licence is unknown"
    [ "$package" = libc6 ] || copy_library "$path" "$folder/lib/$name"
  done <"$made/needed"
  copy_library "$driver" "$folder/lib/dri/${driver##*/}"
  cut -d' ' -f2 "$made/owners" | grep -v '^libc6$' >"$made/packages"
  strip --strip-unneeded "$folder"/lib/libav*.so.* "$folder"/lib/libsw*.so.*
}

copy_program() {
  install -m 755 "$program" "$folder/bin/rotatebook"
  strip --strip-unneeded "$folder/bin/rotatebook"
  # shellcheck disable=SC2016  # The loader's word, not the shell's.
  patchelf --force-rpath --set-rpath '$ORIGIN/../lib' "$folder/bin/rotatebook"
}

# The files that libEGL, fontconfig and the program look for, and scenes to begin with.
write_shared_files() {
  install -D -m 644 /usr/share/glvnd/egl_vendor.d/50_mesa.json -t "$folder/share/glvnd/egl_vendor.d"
  mkdir -p "$folder/share/rotatebook" "$folder/etc/fonts"
  echo 'By this file the program knows that its libraries lie beside it.' >"$folder/share/rotatebook/portable"
  cp -r "$root/scenes" "$folder/share/rotatebook/"
  "$program" check --schema >"$folder/share/rotatebook/scene.schema.json"
  # Where make play has made it, with parts of Emscripten.
  if [ -f "$root/build/play/play.html" ]; then
    install -m 644 "$root/build/play/play.html" "$folder/share/rotatebook/"
    echo emscripten >>"$made/packages"
  fi
  # The program brings its own font.
  printf '%s\n' '<?xml version="1.0"?>' '<!DOCTYPE fontconfig SYSTEM "urn:fontconfig:fonts.dtd">' \
    '<fontconfig></fontconfig>' >"$folder/etc/fonts/fonts.conf"
}

write_licences() {
  local package
  printf '%s\n' "${headers[@]}" >>"$made/packages"
  sort -u "$made/packages" | while read -r package; do
    install -m 644 "$(realpath "/usr/share/doc/$package/copyright")" "$folder/licences/$package"
  done
  install -m 644 "$root/LICENSE" "$folder/licences/rotatebook"
  install -m 644 "$ffmpeg/source/debian/copyright" "$folder/licences/ffmpeg"
  write_sources >"$folder/licences/SOURCES"
}

# Which sources all of it was made from, as the licences want it.
write_sources() {
  echo "Each part is under its own licence, which lies beside this file. x264 and this FFmpeg are under the GPL, version 2 or later;"
  echo "as OpenSSL's licence goes with version 3 alone, the folder as a whole can be passed on under the GPL, version 3."
  echo "Its libraries are those of these Debian packages, without change but for their paths. Debian has the sources:"
  echo "apt-get source PACKAGE=VERSION. libz3.so.4 and libxml2.so.2 are rotatebook's own, and empty: scripts/portable.sh."
  echo
  # shellcheck disable=SC2016  # dpkg's words, not the shell's.
  sort -u "$made/packages" | xargs dpkg-query -W -f '${source:Package} ${source:Version}\n' | sort -u
  echo
  echo "FFmpeg is built from Debian's source ffmpeg ${ffmpeg##*/} with"
  sed -n 's/^#define FFMPEG_CONFIGURATION "\(.*\)"$/\1/p' "$ffmpeg/source/config.h"
}

# Looks whether the folder is whole: each library finds all that it needs in it, but for glibc.
check() {
  local problems
  problems=$(find "$folder/lib" "$folder/bin" -type f | while read -r file; do
    LD_LIBRARY_PATH=$folder/lib ldd -r "$file" 2>&1 | grep -vE "=> $folder/(bin/\.\./)?lib/|linux-vdso|ld-linux|statically linked" |
      grep -vE '=> [^ ]*/lib(c|m|mvec|dl|pthread|rt|resolv|util)\.so\.[0-9]+ \(' | sed "s|^|${file##*/}:|"
  done || true)
  [ -z "$problems" ] || { echo "$problems" >&2; fail "the folder isn't whole"; }
}

# The version of glibc that the folder needs.
needed_glibc() {
  find "$folder/lib" "$folder/bin" -type f -exec objdump -p {} + | grep -oE 'GLIBC_2\.[0-9]+' | sort -Vu | tail -n 1
}

# The archive is the same for the same folder: one owner, one time, one order.
pack() {
  local time
  time=${SOURCE_DATE_EPOCH:-$(git -C "$root" log -1 --format=%ct 2>/dev/null || echo 0)}
  tar --sort=name --owner=0 --group=0 --numeric-owner --mtime="@$time" -C "$made" -cf - "$name" | xz -6 -T2 >"$made/$name.tar.xz.making"
  mv "$made/$name.tar.xz.making" "$made/$name.tar.xz"
}

[ $# = 2 ] || { say "name the program and a folder" >&2; exit 2; }
program=$(realpath "$1")
mkdir -p "$2"
made=$(realpath "$2")
for file in "${loaded[@]}" "$driver"; do [ -e "$file" ] || fail "$file isn't here: make the folder on Debian 12"; done
"$root/scripts/portable_ffmpeg.sh" "$made/ffmpeg"
ffmpeg=$(realpath "$made/ffmpeg/current") stubs=$made/stubs
name=rotatebook-$("$program" --version | cut -d' ' -f2)-x86_64-linux
folder=$made/$name
rm -rf "$folder" "$made/packages"
mkdir -p "$folder"/{bin,lib/dri,licences}
make_stubs
copy_libraries
copy_program
write_shared_files
write_licences
check
say "$folder: $(find "$folder/lib" -name '*.so*' | wc -l) libraries, $(($(du -sb "$folder" | cut -f1) / 1000000)) MB, needs $(needed_glibc)"
pack
say "$folder.tar.xz: $(($(stat -c %s "$folder.tar.xz") / 1000000)) MB, in $SECONDS s"
