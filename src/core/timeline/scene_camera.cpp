#include "timeline/scene_camera.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

#include "base/elementary.h"

namespace rotatebook::timeline {
namespace {

/// Returns the vertical field of view for the scene's angle. [degrees]
double verticalFieldOfView(double angle, bool isPanel, const geometry::Screen& screen) {
  const double height = screen.height - screen.bottomRows;
  if (!isPanel || screen.width >= height) return angle;
  // In panels the scene's angle is that of the shorter side.
  constexpr double kHalf = std::numbers::pi / 360;
  return arcTangent(sine(angle * kHalf) * height, cosine(angle * kHalf) * screen.width) / kHalf;
}

/// Returns an angle less whole turns, from -pi to pi. [rad]
double withoutTurns(double angle) {
  constexpr double kFullTurn = 2 * std::numbers::pi;
  return angle - kFullTurn * std::round(angle / kFullTurn);
}

double mixed(double a, double b, double share) {
  return a + share * (b - a);
}

}  // namespace

geometry::Camera cameraOf(const scene::Scene& scene, const geometry::Screen& screen) {
  return {scene.cameraPosition, scene.camera.target, scene.camera.up,
          verticalFieldOfView(scene.camera.fieldOfViewDeg, scene.hasPanels(), screen)};
}

CameraPath::CameraPath(const scene::Scene& scene, const geometry::Screen& screen)
    : start_(cameraOf(scene, screen)),
      screen_(screen),
      isPanel_(scene.hasPanels()),
      up_(scene.camera.up.stableNormalized()) {
  const Eigen::Vector3d arm = scene.cameraPosition - scene.camera.target;
  ahead_ = (arm - up_.dot(arm) * up_).normalized();
  right_ = up_.cross(ahead_);
  first_ = viewFrom(scene.cameraPosition, scene.camera.target, scene.camera.fieldOfViewDeg);
  View last = first_;
  for (const scene::ShownCue& shown : scene.shownCues) {
    const auto& move = scene.cues[shown.cue].move;
    if (!move) continue;
    const auto begins = static_cast<double>(shown.frame);
    const View from = viewAt(begins);
    last = after(last, *move);
    moves_.push_back({begins, move->over / scene.clip.frameRate.period(), from, last});
  }
}

geometry::Camera CameraPath::at(std::int64_t frame) const {
  if (moves_.empty() || static_cast<double>(frame) <= moves_.front().frame) return start_;
  const View view = viewAt(static_cast<double>(frame));
  return {positionOf(view), view.target, start_.up,
          verticalFieldOfView(view.fieldOfViewDeg, isPanel_, screen_)};
}

CameraPath::View CameraPath::viewFrom(const Eigen::Vector3d& position,
                                      const Eigen::Vector3d& target, double fieldOfViewDeg) const {
  const Eigen::Vector3d arm = position - target;
  const double ahead = arm.dot(ahead_), right = arm.dot(right_);
  return {target, arcTangent(right, ahead),
          arcTangent(arm.dot(up_), roundedHypotenuse(ahead, right)), arm.norm(), fieldOfViewDeg};
}

/// Returns where a move leads from `before`, to a stated position by the shorter way round.
CameraPath::View CameraPath::after(const View& before, const scene::CameraMove& move) const {
  View view = before;
  view.fieldOfViewDeg = move.fieldOfViewDeg.value_or(before.fieldOfViewDeg);
  view.target = move.target.value_or(before.target);
  if (move.position) {
    view = viewFrom(*move.position, view.target, view.fieldOfViewDeg);
    view.azimuth = before.azimuth + withoutTurns(view.azimuth - before.azimuth);
  }
  view.azimuth += move.orbit;
  return view;
}

Eigen::Vector3d CameraPath::positionOf(const View& view) const {
  const Eigen::Vector3d level = cosine(view.azimuth) * ahead_ + sine(view.azimuth) * right_;
  return view.target +
         view.distance * (cosine(view.elevation) * level + sine(view.elevation) * up_);
}

CameraPath::View CameraPath::viewAt(double frame) const {
  const auto later =
      std::ranges::find_if(moves_, [&](const Move& move) { return move.frame > frame; });
  if (later == moves_.begin()) return first_;
  const Move& move = *std::prev(later);
  const double t = std::min((frame - move.frame) / move.frames, 1.0);
  const double share = t * t * (3 - 2 * t);
  const View &a = move.from, &b = move.to;
  return {a.target + share * (b.target - a.target), mixed(a.azimuth, b.azimuth, share),
          mixed(a.elevation, b.elevation, share), mixed(a.distance, b.distance, share),
          mixed(a.fieldOfViewDeg, b.fieldOfViewDeg, share)};
}

}  // namespace rotatebook::timeline
