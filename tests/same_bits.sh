#!/usr/bin/env bash
# The motions of all scenes from two other builds: g++ without optimisation, clang++ with all of it, each on this processor and as
# if it had neither FMA nor AVX2. Only what computes motions is compiled: tests/same_bits.sh [FOLDER]
set -euo pipefail
cd "$(dirname "$0")/.."
build=${1:-build/same-bits}
mkdir -p "$build"
mask=glibc.cpu.hwcaps=-AVX2,-AVX2_Usable,-FMA,-FMA_Usable,-FMA4,-AVX512F
flags=$(pkg-config --cflags eigen3)
common="-std=c++20 -ffp-contract=off -fno-math-errno -DEIGEN_DONT_VECTORIZE -w -Isrc $flags"

# Each room's sources as one
rooms() {
  for room in base physics scene; do
    find src -path "*/$room/*.cpp" ! -name integrator_table.cpp | sort | sed 's/.*/#include "&"/' > "$build/$room.cpp"
  done
  {
    find src -name integrator_table.cpp
    find src -name checksum.cpp
    find src -name clip_motion.cpp
    find src -name motion_checksum.cpp
    find src -name simulate_scene.cpp
    find src -name trajectory_csv.cpp
    echo tests/same_bits/same_bits.cpp
  } | sed 's/.*/#include "&"/' > "$build/rest.cpp"
}

# compare NAME COMPILER...
compare() {
  local name=$1
  shift
  printf '%s\n' base physics scene rest |
    xargs -P "$(nproc)" -I ROOM "$@" $common -I. -DROTATEBOOK_VERSION='"0"' -DTOML_HEADER_ONLY=1 -c "$build/ROOM.cpp" \
      -o "$build/$name-ROOM.o"
  "$@" "$build/$name"-*.o -lxxhash -o "$build/$name"
  "$build/$name" tests/same_bits/motions.txt scenes > "$build/$name.txt"
  GLIBC_TUNABLES=$mask "$build/$name" tests/same_bits/motions.txt scenes > "$build/$name-masked.txt"
  echo "same bits: $name, and without FMA and AVX2"
}

rooms
compare gcc-O0 g++ -O0
compare clang-O3 clang++ -O3
