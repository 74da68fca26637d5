// The instruction sets for which there are lanes. Inside the room only.
#pragma once

#include <string_view>
#include <vector>

namespace rotatebook::study::lanes {

/// A processor's vectors, by the number of doubles in one.
enum class InstructionSet {
  None,    ///< One motion after the other, by its simulator.
  Base,    ///< Two, as every processor of the build's target has them.
  Avx2,    ///< Four.
  Avx512,  ///< Eight.
};

/// Returns whether this build has code for it, and this processor runs it.
bool isAvailable(InstructionSet set);
/// Returns those that are available, narrowest first.
std::vector<InstructionSet> availableSets();
/// Returns the widest that is available.
InstructionSet widestSet();
std::string_view nameOf(InstructionSet set);

}  // namespace rotatebook::study::lanes
