// A book thrown about its middle axis: how often it turns over, and the checksum of its motion.
#include <iostream>

#include "scene/scene_text.h"
#include "timeline/motion_checksum.h"
#include "timeline/simulate_scene.h"

int main() {
  using namespace rotatebook;
  const scene::Scene scene =
      scene::parseScene("[initial]\nangular_velocity = [5, 0.01, 0]\n", "throw.toml");
  const timeline::ClipMotion motion = timeline::simulateScene(scene);
  std::cout << motion.trajectories()[0].samples.back().halfTurns << " flips, motion "
            << timeline::motionChecksum(motion) << '\n';
}
