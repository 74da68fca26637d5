#include "pipeline/scenes_at_a_time.h"

#include <algorithm>

#include "system/machine.h"

namespace rotatebook::pipeline {
namespace {

/// Estimates the memory that one more render takes. [bytes] Measured at 1280x720, 1920x1080 and
/// 3840x2160: 155, 326 and 878 MB.
double memoryOf(const scene::Scene& scene) {
  constexpr double kBase = 60e6, kPixel = 110;
  const double supersample = scene.look.supersample;
  return kBase + kPixel * supersample * supersample * scene.clip.width * scene.clip.height;
}

}  // namespace

int scenesAtATime(const std::vector<scene::Scene>& scenes, int cores, double memory) {
  double largest = 0;
  for (const scene::Scene& scene : scenes) largest = std::max(largest, memoryOf(scene));
  const double held = memory / 4 / largest;
  return std::max(1, static_cast<int>(std::min(1.0 * system::rendersFor(cores), held)));
}

}  // namespace rotatebook::pipeline
