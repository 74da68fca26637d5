// From what failed and how the machine is set up to what its user can do. Asks the machine nothing.
// Inside the room only.
#pragma once

#include <string>
#include <vector>

#include "diagnose/graphics_check.h"
#include "diagnose/graphics_facts.h"

namespace rotatebook::diagnose {

/// Something that doesn't work, and what mends it.
struct Problem {
  std::string what;  ///< Who, the call, the error by its name.
  /// The one that fits the cause. A line that begins with two spaces is a command.
  std::string remedy;
};

/// What is wrong with the machine's graphics, the deepest cause first. That the surfaceless
/// platform or the default display fails is none while something draws. Never empty where nothing
/// does.
std::vector<Problem> diagnose(const GraphicsCheck& check, const GraphicsFacts& facts);

}  // namespace rotatebook::diagnose
