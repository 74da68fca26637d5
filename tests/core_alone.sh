#!/usr/bin/env bash
# The core alone, as other programs take it: built by clang++ and tested; built by g++ without optimisation, where the motions of
# all scenes must have the same bits; installed and used by examples/, as a package and as a subdirectory, with other flags; and
# refused with a reason by a program that is built with another layout. tests/core_alone.sh [--quick] [FOLDER]: three minutes on
# two cores; --quick takes one: only the motions' bits by clang++, and a program that uses the installed package.
set -euo pipefail
cd "$(dirname "$0")/.."
quick=
if [ "${1:-}" = --quick ]; then
  quick=1
  shift
fi
build=$(realpath -m "${1:-build/core-alone}")
mkdir -p "$build"

step() { echo "core alone: $*"; }

# configure NAME COMPILER FLAGS...
configure() {
  cmake -G Ninja -S . -B "$build/$1" -DROTATEBOOK_CORE_ONLY=ON -DCMAKE_CXX_COMPILER="$2" -DCMAKE_UNITY_BUILD=ON "${@:3}" > "$build/$1.log"
}

# A program that shows the throw of examples/throw.cpp, built with FLAGS: throws NAME FLAGS OPTIONS...
throws() {
  CXXFLAGS=$2 cmake -G Ninja -S examples -B "$build/$1" "${@:3}" > "$build/$1.log"
  cmake --build "$build/$1" >> "$build/$1.log"
  local shown
  shown=$("$build/$1/throw")
  [ "$shown" = "$expected" ] || { echo "$1: $shown, not $expected" >&2; exit 1; }
  step "examples/throw, $1: $shown"
}
# The motion of examples/clip.cpp as a video, where the program is built.
draws() {
  [ -x build/release/rotatebook ] || return 0
  local program=$PWD/build/release
  (cd "$build/installed" && rm -f motion.* && PATH="$program:$PATH" ./clip > clip.log && "$program/rotatebook" verify motion.mp4 > clip.log)
  step "examples/clip: $(tail -2 "$build/installed/clip.log" | head -1 | cut -c1-60)"
}
expected="2 flips, motion 496a5d3b94ba3d62b27d8e72f7542f28"

# Runs the tests of the build NAME that OPTIONS of ctest choose: tested NAME OPTIONS...
tested() {
  ctest --test-dir "$build/$1" -j "$(nproc)" --output-on-failure "${@:2}" > "$build/$1-tests.log" || { tail -40 "$build/$1-tests.log"; exit 1; }
}

# Installs the build NAME into an empty folder: no header for its room alone, and none that needs one.
install_build() {
  local include="$build/prefix/include/rotatebook"
  rm -rf "$build/prefix"
  cmake --install "$build/$1" --prefix "$build/prefix" > "$build/install.log"
  (cd "$include" && find . -name '*.h' -printf '#include "%P"\n') | sort > "$build/headers.cpp"
  [ "$(wc -l < "$build/headers.cpp")" -gt 40 ] || { echo "headers are missing in $include" >&2; exit 1; }
  ! grep -rlE "Inside the room|room only\.|toml\+\+/" "$include" || { echo "these aren't for other programs" >&2; exit 1; }
  g++ -std=c++20 -fsyntax-only -DEIGEN_DONT_VECTORIZE -I"$include" $(pkg-config --cflags eigen3) "$build/headers.cpp"
  step "installed, with $(wc -l < "$build/headers.cpp") headers"
}

configure clang clang++ -DCMAKE_BUILD_TYPE=Release
if [ "$quick" ]; then
  cmake --build "$build/clang" --target same_bits >> "$build/clang.log"
  tested clang -R SameBits
  step "clang++ -O3: the same bits, also without FMA and AVX2"
  install_build clang
  throws installed "" -DCMAKE_PREFIX_PATH="$build/prefix"
  draws
  exit
fi
cmake --build "$build/clang" >> "$build/clang.log"
tested clang -E Rooms.HaveHeaders
step "clang++ -O3: $(grep 'tests passed' "$build/clang-tests.log")"

configure gcc g++ -DCMAKE_CXX_FLAGS=-O0
cmake --build "$build/gcc" >> "$build/gcc.log"
tested gcc -R SameBits
step "g++ -O0: the same bits, also without FMA and AVX2"

install_build gcc
throws installed "" -DCMAKE_PREFIX_PATH="$build/prefix"
throws installed-O0 -O0 -DCMAKE_PREFIX_PATH="$build/prefix"
throws installed-avx2 "-O3 -mavx2 -mfma" -DCMAKE_PREFIX_PATH="$build/prefix"
throws subdirectory "-O1 -mavx2 -mfma" -DROTATEBOOK_SOURCE="$PWD"

# Without CMake nobody passes the flags on.
libraries=$(printf -- '-lrotatebook_%s ' study timeline scene geometry physics recording meshes body rigid base)
library=$(dirname "$(find "$build/prefix" -name librotatebook_base.a)")
# A program that takes no scene and simulates by itself.
cat > "$build/simulator.cpp" << 'END'
#include <iostream>

#include "physics/make_simulator.h"

int main() {
  rotatebook::physics::MotionSettings settings;
  settings.initial.value = {5, 0.01, 0};
  const auto simulator = rotatebook::physics::makeSimulator(settings);
  simulator->advance(1.0 / 60, 64);
  std::cout << simulator->state().angularVelocity.transpose() << '\n';
}
END

# other PROGRAM FLAGS: builds it without CMake.
other() {
  g++ -std=c++20 -I"$build/prefix/include/rotatebook" $(pkg-config --cflags eigen3) $2 "$1" -L"$library" $libraries -o "$build/other"
}
# refused PROGRAM FLAGS WORDS
refused() {
  other "$1" "$2"
  local words
  words=$("$build/other" 2>&1) && { echo "no difference is noticed with $2" >&2; exit 1; }
  case $words in *"$3"*) step "refused: ${words##*what():  }" ;; *) echo "$words" >&2; exit 1 ;; esac
}
same="-DEIGEN_DONT_VECTORIZE -ffp-contract=off"
for program in examples/throw.cpp "$build/simulator.cpp"; do
  other "$program" "-O2 $same"
  "$build/other" > /dev/null
  refused "$program" "-O2" "with -DEIGEN_DONT_VECTORIZE, this program without it"
  refused "$program" "-O2 -mavx2" "with -DEIGEN_DONT_VECTORIZE, this program without it"
  refused "$program" "-O2 -mfma -DEIGEN_DONT_VECTORIZE" "with -ffp-contract=off, this program without it"
  refused "$program" "-O2 $same -DEIGEN_DEFAULT_TO_ROW_MAJOR" "without -DEIGEN_DEFAULT_TO_ROW_MAJOR, this program with it"
  refused "$program" "-O2 $same -funsafe-math-optimizations" "without -fassociative-math, this program with it"
done
