#include "scene/scene.h"

#include <algorithm>
#include <numbers>

#include "base/elementary.h"

namespace rotatebook::scene {

const std::size_t kSceneSize = sizeof(Scene);

std::vector<Panel> motionsOf(const Scene& scene) {
  requireSameLayout();
  if (!scene.panels.empty()) return scene.panels;
  return {{{scene}, ""}};
}

Scene withMotion(Scene scene, const Motion& motion) {
  scene.panels.clear();
  static_cast<Motion&>(scene) = motion;
  return scene;
}

bool isTransparent(const Scene& scene) {
  return scene.look.background == Background::Transparent;
}

Eigen::Vector3d defaultCameraPosition(const physics::Cuboid& body, double fieldOfViewDeg, int width,
                                      int height) {
  constexpr double kMargin = 1.08;
  // From the right and a little above: all three kinds of sides are visible, the cover most.
  const Eigen::Vector3d direction = Eigen::Vector3d(0.42, 0.30, 1).normalized();
  const double halfAngle = fieldOfViewDeg / 2 * std::numbers::pi / 180;
  const double halfHeight = sine(halfAngle) / cosine(halfAngle);
  const double halfWidth = halfHeight * width / height;
  const double narrowerHalfAngle = arcTangent(std::min(halfHeight, halfWidth));
  // The sphere that the corners never leave touches the narrower pair of the view frustum's sides.
  return direction * (kMargin * body.size.norm() / 2 / sine(narrowerHalfAngle));
}

bool shows(const Scene& scene, Overlay overlay) {
  if (scene.textless && !onTheBody(overlay)) return false;
  return std::ranges::count(scene.overlay.show, overlay) > 0;
}

}  // namespace rotatebook::scene
