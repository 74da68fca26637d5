#include "picture/attitudes.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "image/image.h"

namespace rotatebook::picture::testing {
namespace {

bool touchesBorder(const image::Image& picture, const image::Image& background, int margin) {
  for (int y = 0; y < picture.height(); ++y) {
    for (int x = 0; x < picture.width(); ++x) {
      const int fromSide = std::min(x, picture.width() - 1 - x);
      const int fromTop = std::min(y, picture.height() - 1 - y);
      if (std::min(fromSide, fromTop) >= margin) continue;
      if (!std::equal(picture.row(y) + 4 * x, picture.row(y) + 4 * x + 4,
                      background.row(y) + 4 * x)) {
        return true;
      }
    }
  }
  return false;
}

}  // namespace

bool anyAttitudeTouchesBorder(const scene::Scene& scene, const geometry::Screen& screen,
                              int margin) {
  const body::Cuboid body = scene.motions.front().body;
  render::Renderer renderer = makeRenderer(scene, screen, loadLooks(scene).looks);
  image::Image background = renderer.makePicture(), picture = renderer.makePicture();
  renderer.draw(body.corners().colwise() + Eigen::Vector3d(0, 1000, 0), background);
  const Eigen::Vector3d corner = body.corners().col(7);
  bool touches = false;
  for (int i = 0; i < 60; ++i) {
    const double height = std::sin(0.9 * i), angle = 2.4 * i;
    const double radius = std::sqrt(1 - height * height);
    const Eigen::Vector3d toward(radius * std::cos(angle), height, radius * std::sin(angle));
    const auto turn = Eigen::Quaterniond::FromTwoVectors(corner, toward);
    renderer.draw(turn.toRotationMatrix() * body.corners(), picture);
    touches = touches || touchesBorder(picture, background, margin);
  }
  return touches;
}

}  // namespace rotatebook::picture::testing
