// Conclusions from what failed, and from the machine's set-up, to what its user can do. Depends on
// nothing but its arguments. Inside the room only.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "diagnose/graphics_check.h"
#include "diagnose/graphics_facts.h"

namespace rotatebook::diagnose {

/// Something that doesn't work, and how to fix it.
struct Problem {
  std::string what;  ///< The part that fails, the call, and the error's name.
  /// The fix for this cause. A line that begins with two spaces is a command.
  std::string remedy;
};

/// Returns the problems of the machine's graphics, the deepest cause first. A failing surfaceless
/// platform or default display is no problem unless it is the default candidate. Never empty if
/// nothing draws.
std::vector<Problem> diagnose(const GraphicsCheck& check, const GraphicsFacts& facts);

/// Returns the problem of the candidate that a render with `choice` comes to, if its driver ends
/// the process.
std::optional<Problem> diagnoseCrash(const GraphicsCheck& check, const GraphicsFacts& facts,
                                     const render::DeviceChoice& choice);

}  // namespace rotatebook::diagnose
