// A scene whose motion is quickly simulated and whose clip is quickly rendered.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "physics/simulate.h"
#include "scene/scene_text.h"

namespace rotatebook::scene::testing {

inline constexpr std::int64_t kFrames = 12;

/// Twelve frames of 64x36, named "small"; `overrides` as --set takes them.
inline Scene smallScene(const std::vector<std::string>& overrides = {}) {
  return parseScene(
      "title = \"Small · clip\"\n"
      "[initial]\nangular_velocity = [5, 3, 1]\n"
      "[clip]\nsize = [64, 36]\nfps = 24\nduration = 0.5\n",
      "small.toml", overrides);
}

/// A scene whose motion blows up at frame 5 of 12. measured: diverges at 0.2083 s
inline Scene divergingScene() {
  return smallScene({"simulation.model=particles", "simulation.substeps=1",
                     "simulation.time_per_frame=0.041666666666666664", "simulation.normalize=false",
                     "simulation.damping=0"});
}

inline physics::Trajectory motionOf(const Scene& scene) {
  return physics::simulate(scene.motions[0].motion(), scene.clip.frameCount());
}

/// Returns the message with which `action` throws an `Expected`; "no error" if it doesn't throw.
template <typename Expected, typename Action>
std::string messageOf(const Action& action) {
  try {
    action();
    return "no error";
  } catch (const Expected& error) {
    return error.what();
  }
}

}  // namespace rotatebook::scene::testing
