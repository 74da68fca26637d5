#include "timeline/camera_distances.h"

#include <algorithm>

#include "base/elementary.h"

namespace rotatebook::timeline {
namespace {

constexpr double kEase = 0.4;   // frames this near are averaged [s of the clip]
constexpr double kHalving = 3;  // in which the camera comes back by half [s of the clip]

/// Returns the distance from the origin of the farthest corner. [m]
double reachOf(const body::Cage& cage) {
  return cage.colwise().norm().maxCoeff();
}

/// Returns how large a body may become before the camera draws back: up to the edge of the picture,
/// and at least as the default camera leaves room. [m] `share`: of the camera's distance.
double roomFor(const scene::Scene& scene, const body::Cuboid& body, double targetDistance,
               double share) {
  // In panels the angle of view is over the shorter side.
  const bool panels = scene.hasPanels();
  const double inView =
      radiusInView(scene, panels ? 1 : scene.clip.width, panels ? 1 : scene.clip.height);
  return std::max(share * inView, scene::kRoomAround * (targetDistance + reachOf(body.corners())));
}

/// Returns, for each frame, the logarithm of the multiple that keeps the body in view, which comes
/// back slowly after a body that shrinks; 0 as long as it has room.
std::vector<double> neededLogarithms(const scene::Scene& scene, const scene::Panel& panel,
                                     const ClipMotion& motion, std::size_t index, double share) {
  const auto& samples = motion.trajectories()[index].samples;
  const double targetDistance = scene.camera.target.norm();
  const double room = roomFor(scene, panel.body, targetDistance, share);
  const double comesBack = logarithm(2) * scene.clip.frameRate.period() / kHalving;
  std::vector<double> needed;
  double before = 0;
  for (std::int64_t frame = 0; frame < motion.frameCount(); ++frame) {
    const body::Cage& cage = samples[motion.sampleAt(index, frame)].cage;
    const double growth = (targetDistance + reachOf(cage)) / room;
    before = std::max({0.0, before - comesBack, growth > 1 ? logarithm(growth) : 0});
    needed.push_back(before);
  }
  return needed;
}

/// Returns the exponentials of the weighted means of `logarithms` up to `reach` frames before and
/// after, which follow an exponential growth without delay. The weights are whole numbers, so that
/// the mean of zeros is zero.
std::vector<double> eased(const std::vector<double>& logarithms, std::int64_t reach) {
  const auto last = static_cast<std::int64_t>(logarithms.size()) - 1;
  std::vector<double> multiples;
  for (std::int64_t frame = 0; frame <= last; ++frame) {
    double sum = 0, weights = 0;
    for (std::int64_t off = -reach; off <= reach; ++off) {
      const auto weight = static_cast<double>(reach + 1 - std::max(off, -off));
      const auto near = std::clamp<std::int64_t>(frame + off, 0, last);
      sum += weight * logarithms[static_cast<std::size_t>(near)];
      weights += weight;
    }
    multiples.push_back(exponential(sum / weights));
  }
  return multiples;
}

/// Returns each body's size as a share of the largest one's.
std::vector<double> sharesOf(const std::vector<scene::Panel>& panels) {
  std::vector<double> shares;
  for (const scene::Panel& panel : panels) shares.push_back(panel.body.size.norm());
  const double largest = *std::ranges::max_element(shares);
  for (double& share : shares) share /= largest;
  return shares;
}

}  // namespace

double distanceAtRest(const scene::Scene& scene, std::size_t motion) {
  return scene.camera.fit == scene::Fit::Each ? sharesOf(scene.motions)[motion] : 1;
}

CameraDistances::CameraDistances(const scene::Scene& scene, const ClipMotion& motion) {
  const std::vector<scene::Panel>& panels = scene.motions;
  if (scene.camera.fit == scene::Fit::Each) shares_ = sharesOf(panels);
  if (scene.camera.follow == scene::Follow::None) return;
  for (std::size_t i = 0; i < panels.size(); ++i) {
    const double share = shares_.empty() ? 1 : shares_[i];
    multiples_.push_back(eased(neededLogarithms(scene, panels[i], motion, i, share),
                               scene.clip.frameRate.framesIn(kEase)));
  }
}

}  // namespace rotatebook::timeline
