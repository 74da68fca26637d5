#include "interchange/turning.h"

#include <algorithm>
#include <cstdint>
#include <numbers>
#include <vector>

#include "physics/simulate.h"

namespace rotatebook::interchange {
namespace {

using Eigen::Quaterniond;

/// Returns how fast the motion's clock goes by the video's, also where its speed passes to another.
double clockSpeed(const scene::Scene& scene, double frame) {
  constexpr double kApart = 1e-3;  // frames
  const double before = std::max(frame - kApart, 0.0), after = frame + kApart;
  return (timeAt(scene, after) - timeAt(scene, before)) /
         ((after - before) * scene.clip.frameRate.period());
}

/// Returns q' = w q / 2 for the angular velocity w [rad/s], at that speed.
Quaterniond derivative(const Quaterniond& q, const Eigen::Vector3d& w, double speed) {
  Quaterniond result = Quaterniond(0, w.x(), w.y(), w.z()) * q;
  result.coeffs() *= speed / 2;
  return result;
}

/// Returns the attitude halfway between two keys, by glTF's LINEAR or CUBICSPLINE.
Quaterniond halfway(const Key& a, const Key& b, bool tangents) {
  if (!tangents) return a.attitude.slerp(0.5, b.attitude);
  const double eighth = (b.time - a.time) / 8;
  return Quaterniond((a.attitude.coeffs() + b.attitude.coeffs()) / 2 +
                     eighth * (a.tangent.coeffs() - b.tangent.coeffs()))
      .normalized();
}

Turning turningWith(int keysPerSecond, const scene::Scene& scene, std::int64_t frames,
                    bool tangents) {
  const FrameRate& rate = scene.clip.frameRate;
  const std::int64_t last = (frames - 1) * keysPerSecond * rate.denominator / rate.numerator;
  const auto frameOf = [&](double key) {
    return key * rate.numerator / (keysPerSecond * rate.denominator);
  };
  std::vector<double> times;  // of the keys and halfway between them
  for (std::int64_t i = 0; i <= 2 * last; ++i)
    times.push_back(timeAt(scene, frameOf(static_cast<double>(i) / 2)));
  const std::vector<physics::Sample> samples =
      physics::simulate(scene.motions.front().motion(), times).samples;
  Turning turning;
  for (std::size_t i = 0; i < samples.size(); i += 2) {
    const auto key = static_cast<double>(i / 2);
    const physics::Sample& sample = samples[i];
    turning.keys.push_back(
        {key / keysPerSecond, sample.attitude,
         derivative(sample.attitude, sample.angularVelocity, clockSpeed(scene, frameOf(key)))});
    if (i == 0) continue;
    const Quaterniond between = halfway(turning.keys[i / 2 - 1], turning.keys[i / 2], tangents);
    const double error = between.angularDistance(samples[i - 1].attitude);
    turning.errorDeg = std::max(turning.errorDeg, error * 180 / std::numbers::pi);
  }
  return turning;
}

}  // namespace

Turning turningOf(const scene::Scene& scene, std::int64_t frames, const GlbOptions& options) {
  constexpr int kFewest = 60, kMost = 960;
  int keys = options.keysPerSecond.value_or(kFewest);
  Turning turning = turningWith(keys, scene, frames, options.tangents);
  while (!options.keysPerSecond && turning.errorDeg > kCloseDeg && keys < kMost) {
    keys *= 2;
    turning = turningWith(keys, scene, frames, options.tangents);
  }
  return turning;
}

}  // namespace rotatebook::interchange
