#include "timeline/scene_camera.h"

#include <numbers>

#include "base/elementary.h"

namespace rotatebook::timeline {
namespace {

/// Returns the vertical field of view. [degrees]
double verticalFieldOfView(const scene::Scene& scene, const geometry::Screen& screen) {
  const double angle = scene.camera.fieldOfViewDeg;
  const double height = screen.height - screen.bottomRows;
  if (!scene.hasPanels() || screen.width >= height) return angle;
  // In panels the scene's angle is that of the shorter side.
  constexpr double kHalf = std::numbers::pi / 360;
  return arcTangent(sine(angle * kHalf) * height, cosine(angle * kHalf) * screen.width) / kHalf;
}

}  // namespace

geometry::Camera cameraOf(const scene::Scene& scene, const geometry::Screen& screen) {
  return {scene.cameraPosition, scene.camera.target, scene.camera.up,
          verticalFieldOfView(scene, screen)};
}

}  // namespace rotatebook::timeline
