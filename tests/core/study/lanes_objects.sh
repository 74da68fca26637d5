#!/usr/bin/env bash
# The object files have no fused multiply-add, which rounds once where two roundings are meant, but those of AVX-512 that lanes
# ask for: sums and rests of whole vectors, and no difference, which compilers make of cross products. And those for one kind of
# processor define nothing that other sources may define, too, but templates of their own width: the linker keeps one definition.
# lanes_objects.sh OBJECT...
set -euo pipefail

# Whatever other sources may define, but templates of lanes of this width: check_templates OBJECT WIDTH
check_templates() {
  local weak
  weak=$(nm -C --defined-only "$1" | grep -E ' [WVu] ' || true)
  [ -n "$weak" ] || { echo "no templates in $1" >&2; exit 1; }
  if grep -vE "lanes::(Lanes|Mask)<$2>" <<< "$weak"; then
    echo "$1 defines these for other sources, too" >&2
    exit 1
  fi
  echo "$1: $(wc -l <<< "$weak") templates"
}

lanes=0
for object in "$@"; do
  code=$(objdump -d --no-show-raw-insn "$object")
  [ "$(grep -c . <<< "$code")" -gt 50 ] || { echo "no code in $object" >&2; exit 1; }
  if [[ $object == *lanes_avx512* ]]; then
    code=$(sed -E 's/\bvfn?madd[0-9]+pd( .*%zmm)/asked for\1/' <<< "$code")
  fi
  if grep -E '\bv?f(n?m(add|sub)|maddsub|msubadd)' <<< "$code"; then
    echo "fused multiply-adds in $object" >&2
    exit 1
  fi
  case $object in
    *lanes_base*) check_templates "$object" 2 ;;
    *lanes_avx2*) check_templates "$object" 4 ;;
    *lanes_avx512*) check_templates "$object" 8 ;;
    *) continue ;;
  esac
  lanes=$((lanes + 1))
done
[ "$lanes" -gt 0 ] || { echo "no lanes among $*" >&2; exit 1; }
