// Reports on the numbers of a scene's spin, as text and as JSON. Inside the room only.
#pragma once

#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "base/json.h"
#include "scene/scene.h"
#include "timeline/euler_steps.h"
#include "timeline/spin.h"

namespace rotatebook::cli {

/// The numbers of one motion's spin.
struct SpinNumbers {
  scene::Panel motion;  ///< The settings; without a label if the scene has no panels.
  timeline::Spin spin;
  std::optional<timeline::EulerSteps> euler{};
  double duration = 0;  ///< Simulated time for which Euler was tried. [s]
};

/// Returns the numbers of each motion of `scene`, in the order of Scene::motions.
std::vector<SpinNumbers> spinNumbersOf(const scene::Scene& scene);

/// Returns a sentence for each number that this spin hasn't, or whose meaning differs: of a steady
/// spin, of equal moments, on the separatrix, with nudges, of particles.
std::vector<std::string> remarksOn(const SpinNumbers& numbers);

/// Prints the numbers and the remarks.
void reportSpin(const SpinNumbers& numbers, std::ostream& out);

/// Returns the same as a JSON object. Unknown values are null.
Json spinJson(const SpinNumbers& numbers);

}  // namespace rotatebook::cli
