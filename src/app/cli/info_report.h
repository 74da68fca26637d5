// The numbers of a body and its spin, as a command's result. Inside the room only.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/result_rows.h"
#include "scene/body_numbers.h"
#include "scene/scene.h"
#include "timeline/euler_steps.h"
#include "timeline/spin.h"

namespace rotatebook::cli {

/// Returns size, mass, centre, inertia about it, the principal moments, smallest first, with a unit
/// vector for each, right-handed, the stability of a spin about the middle axis, and what is known
/// of the surface: of the book's there are nulls. Triangles count from 1.
ResultRows rowsOn(const scene::BodyNumbers& numbers);

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

/// Returns the numbers, null where this spin has none, and the remarks.
ResultRows rowsOn(const SpinNumbers& numbers);

}  // namespace rotatebook::cli
