#!/usr/bin/env bash
# Builds FFmpeg's libraries for the portable folder from Debian's source, of the version that is installed: nothing but the formats
# that rotatebook writes and reads. What is built already is kept.
#
#   scripts/portable_ffmpeg.sh FOLDER   leaves FOLDER/current, a link to FOLDER/VERSION: source/, as Debian has it, and lib/
#
# Exit status: 0 done; 3 the source can't be had, or its build failed.
set -euo pipefail

say() { echo "portable ffmpeg: $*"; }
fail() { say "$*" >&2; exit 3; }

# Options of apt that take sources from a list of our own, and leave the machine's as they are.
apt_own() {
  local command=$1
  shift
  "$command" -o Dir::Etc::sourcelist="$folder/sources.list" -o Dir::Etc::sourceparts=- -o Dir::State::lists="$folder/lists" \
    -o APT::Sandbox::User=root "$@"
}

# The machine's sources of Debian packages, as sources of their sources.
source_list() {
  # shellcheck disable=SC2016  # apt's words, not the shell's.
  apt-get indextargets --format 'deb-src $(REPO_URI) $(SUITE) $(COMPONENT) $(ORIGIN)' 'Created-By: Packages' |
    sed -nE 's/ (Debian|Ubuntu)$//p' | sort -u
}

# Gets the source, whose checksums apt compares with those that the archive signed.
fetch() {
  mkdir -p "$folder/lists/partial" "$folder/fetched"
  source_list >"$folder/sources.list"
  [ -s "$folder/sources.list" ] || fail "apt knows no Debian archive here"
  apt_own apt-get update -qq || fail "apt can't read the archive's list of sources"
  (cd "$folder/fetched" && apt_own apt-get source -qq --download-only "ffmpeg=$version") ||
    fail "the archive has no source of FFmpeg $version any more: apt-get upgrade, make program, then try again"
  dpkg-source --no-check --no-copy -x "$folder/fetched/ffmpeg_${version#*:}.dsc" "$made/source" >/dev/null
}

# What there is of FFmpeg: what the formats need, and the decoders by which clips are verified.
configure() {
  ./configure --prefix=/nowhere --extra-version="${version##*-}" --enable-gpl --enable-shared --disable-static \
    --disable-autodetect --disable-everything --disable-programs --disable-doc --disable-network --disable-avdevice \
    --disable-postproc --disable-swresample --enable-zlib --enable-libx264 --enable-libvpx \
    --enable-encoder=libx264,libvpx_vp9,gif,apng,prores_ks --enable-decoder=h264,vp9,libvpx_vp9,gif,apng,png \
    --enable-muxer=mp4,webm,gif,apng,mov --enable-demuxer=mov,matroska,gif,apng --enable-parser=h264,vp9,png,gif \
    --enable-bsf=h264_mp4toannexb,vp9_superframe,vp9_superframe_split,extract_extradata \
    --enable-protocol=file,pipe --enable-filter=split,palettegen,paletteuse,format,scale,null,buffer,buffersink
}

build() {
  (cd "$made/source" && configure && make -j"$(nproc)") >"$made/log" 2>&1 || {
    tail -n 5 "$made/log" >&2
    fail "the build failed; its messages are in $made/log"
  }
  mkdir "$made/lib.making"
  find "$made/source" -name 'lib*.so.*' -exec cp -P {} "$made/lib.making/" \;
  mv "$made/lib.making" "$made/lib"
}

[ $# = 1 ] || { say "name one folder" >&2; exit 3; }
folder=$(realpath -m "$1")
# shellcheck disable=SC2016  # dpkg's word, not the shell's.
version=$(dpkg-query -W -f '${source:Version}' libavcodec-dev)
made=$folder/${version#*:}  # A colon would divide lists of folders.
mkdir -p "$folder"
ln -sfn "${made##*/}" "$folder/current"
[ ! -d "$made/lib" ] || exit 0
rm -rf "$made"
mkdir "$made"
say "Debian's source of FFmpeg $version"
fetch
say "building what rotatebook needs of it: some minutes"
build
say "done in $SECONDS s"
