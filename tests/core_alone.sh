#!/usr/bin/env bash
# The core alone, as other programs take it: built by clang++ and tested; built by g++ without optimisation, where the motions of
# all scenes must have the same bits; installed and used by examples/, as a package and as a subdirectory, with other flags; and
# refused with a reason by a program that is built with another layout. tests/core_alone.sh [FOLDER]: three minutes on two cores.
set -euo pipefail
cd "$(dirname "$0")/.."
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
expected="2 half-turns, motion 496a5d3b94ba3d62b27d8e72f7542f28"

configure clang clang++ -DCMAKE_BUILD_TYPE=Release
cmake --build "$build/clang" >> "$build/clang.log"
ctest --test-dir "$build/clang" -j "$(nproc)" -E Rooms.HaveHeaders --output-on-failure > "$build/clang-tests.log" || { tail -40 "$build/clang-tests.log"; exit 1; }
step "clang++ -O3: $(grep 'tests passed' "$build/clang-tests.log")"

configure gcc g++ -DCMAKE_CXX_FLAGS=-O0
cmake --build "$build/gcc" >> "$build/gcc.log"
ctest --test-dir "$build/gcc" -R SameBits --output-on-failure > "$build/gcc-tests.log" || { tail -40 "$build/gcc-tests.log"; exit 1; }
step "g++ -O0: the same bits, also without FMA and AVX2"

cmake --install "$build/gcc" --prefix "$build/prefix" > "$build/install.log"
throws installed "" -DCMAKE_PREFIX_PATH="$build/prefix"
throws installed-O0 -O0 -DCMAKE_PREFIX_PATH="$build/prefix"
throws installed-avx2 "-O3 -mavx2 -mfma" -DCMAKE_PREFIX_PATH="$build/prefix"
throws subdirectory "-O1 -mavx2 -mfma" -DROTATEBOOK_SOURCE="$PWD"

# Without CMake nobody passes the flags on.
libraries=$(printf -- '-lrotatebook_%s ' study timeline scene physics base)
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
