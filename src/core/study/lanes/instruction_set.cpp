#include "study/lanes/instruction_set.h"

#include <array>

#include "study/lanes/kernels.h"

namespace rotatebook::study::lanes {
namespace {

constexpr std::array kSets{InstructionSet::None, InstructionSet::Base, InstructionSet::Avx2,
                           InstructionSet::Avx512};

}  // namespace

bool isAvailable(InstructionSet set) {
  switch (set) {
#ifdef ROTATEBOOK_WIDE_LANES
    case InstructionSet::Avx2:
      return __builtin_cpu_supports("avx2");
    case InstructionSet::Avx512:
      return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
             __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512bw");
#else
    case InstructionSet::Avx2:
    case InstructionSet::Avx512:
      return false;
#endif
    default:
      return true;
  }
}

std::vector<InstructionSet> availableSets() {
  std::vector<InstructionSet> sets;
  for (const InstructionSet set : kSets) {
    if (isAvailable(set)) sets.push_back(set);
  }
  return sets;
}

InstructionSet widestSet() {
  return availableSets().back();
}

std::string_view nameOf(InstructionSet set) {
  constexpr std::array<std::string_view, kSets.size()> kNames{"none", "base", "AVX2", "AVX-512"};
  return kNames.at(static_cast<std::size_t>(set));
}

const Kernels& kernelsFor(InstructionSet set) {
#ifdef ROTATEBOOK_WIDE_LANES
  if (set == InstructionSet::Avx2) return kAvx2Kernels;
  if (set == InstructionSet::Avx512) return kAvx512Kernels;
#else
  static_cast<void>(set);
#endif
  return kBaseKernels;
}

}  // namespace rotatebook::study::lanes
