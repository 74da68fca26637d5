#include "picture/interchange/turning.h"

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

/// The motion at an animation's keys and halfway between them.
struct SampledKeys {
  int perSecond = 0;  // of the video
  std::vector<physics::Sample> samples;
};

double frameOf(const scene::Scene& scene, double key, int perSecond) {
  const FrameRate& rate = scene.clip.frameRate;
  return key * rate.numerator / (perSecond * rate.denominator);
}

/// Returns the number of keys after the first.
std::int64_t keysIn(const scene::Scene& scene, std::int64_t frames, int perSecond) {
  const FrameRate& rate = scene.clip.frameRate;
  return (frames - 1) * perSecond * rate.denominator / rate.numerator;
}

SampledKeys sampled(const scene::Scene& scene, std::int64_t frames, int perSecond) {
  std::vector<double> times;
  for (std::int64_t i = 0; i <= 2 * keysIn(scene, frames, perSecond); ++i)
    times.push_back(timeAt(scene, frameOf(scene, static_cast<double>(i) / 2, perSecond)));
  return {perSecond, physics::simulate(scene.motions.front().motion(), times).samples};
}

/// Returns every `stride`-th of the samples: of fewer keys, which are at the same times.
std::vector<physics::Sample> everyOf(const SampledKeys& fine, int stride, std::int64_t keys) {
  std::vector<physics::Sample> samples;
  const auto step = static_cast<std::size_t>(stride);
  const auto end = std::min(fine.samples.size(), 2 * static_cast<std::size_t>(keys) * step + 1);
  for (std::size_t i = 0; i < end; i += step) samples.push_back(fine.samples[i]);
  return samples;
}

double radiusOf(const body::Cuboid& body) {
  return body.corners().colwise().norm().maxCoeff();
}

body::Cage displacementsOf(const physics::Sample& sample, const body::Cuboid& body) {
  return sample.attitude.conjugate().toRotationMatrix() * sample.cage - body.corners();
}

/// Measures how far the animation is off samples at its keys and halfway between them.
void measure(const std::vector<physics::Sample>& samples, const body::Cuboid& body, bool tangents,
             Turning& turning) {
  constexpr double kDegrees = 180 / std::numbers::pi;
  for (std::size_t i = 1; i < turning.keys.size(); ++i) {
    const Key &a = turning.keys[i - 1], &b = turning.keys[i];
    const physics::Sample& between = samples[2 * i - 1];
    const Quaterniond attitude = halfway(a, b, tangents);
    body::Cage corners = body.corners();
    if (turning.reach) corners += (a.displacements + b.displacements) / 2;
    const body::Cage off = attitude.toRotationMatrix() * corners - between.cage;
    turning.errorM = std::max(turning.errorM, off.colwise().norm().maxCoeff());
    if (!turning.reach)
      turning.errorDeg =
          std::max(turning.errorDeg, attitude.angularDistance(between.attitude) * kDegrees);
  }
  if (turning.reach) turning.errorDeg = turning.errorM / radiusOf(body) * kDegrees;
}

Turning turningWith(int keysPerSecond, const SampledKeys& fine, const scene::Scene& scene,
                    std::int64_t frames, bool tangents) {
  const body::Cuboid& body = scene.motions.front().body;
  const std::vector<physics::Sample> samples =
      everyOf(fine, fine.perSecond / keysPerSecond, keysIn(scene, frames, keysPerSecond));
  Turning turning;
  turning.keysPerSecond = keysPerSecond;
  double reach = 0, farthest = 0;  // [m]
  for (std::size_t i = 0; i < samples.size(); i += 2) {
    const auto key = static_cast<double>(i / 2);
    const physics::Sample& sample = samples[i];
    turning.keys.push_back({key / keysPerSecond, sample.attitude,
                            derivative(sample.attitude, sample.angularVelocity,
                                       clockSpeed(scene, frameOf(scene, key, keysPerSecond))),
                            displacementsOf(sample, body)});
    const body::Cage& moved = turning.keys.back().displacements;
    reach = std::max(reach, moved.cwiseAbs().maxCoeff());
    farthest = std::max(farthest, moved.colwise().norm().maxCoeff());
  }
  if (farthest > kCloseDeg * std::numbers::pi / 180 * radiusOf(body)) turning.reach = reach;
  measure(samples, body, tangents, turning);
  return turning;
}

/// Returns how many times as many keys are close enough, by how the error falls with their
/// distance: with its square, or with the fourth power.
int timesFor(double errorDeg, bool tangents) {
  int times = 1;
  for (double error = errorDeg; error > kCloseDeg; error /= tangents ? 16 : 4) times *= 2;
  return times;
}

}  // namespace

Turning turningOf(const scene::Scene& scene, std::int64_t frames, const KeyOptions& options) {
  constexpr int kFewest = 60;
  int keys = options.keysPerSecond.value_or(kFewest);
  SampledKeys samples = sampled(scene, frames, keys);
  for (;;) {
    Turning turning = turningWith(keys, samples, scene, frames, options.tangents);
    if (options.keysPerSecond || turning.errorDeg <= kCloseDeg || keys >= kMostKeys) return turning;
    if (keys == samples.perSecond) {
      const int wanted = std::min(kMostKeys, keys * timesFor(turning.errorDeg, options.tangents));
      samples = sampled(scene, frames, wanted);
    }
    keys *= 2;
  }
}

}  // namespace rotatebook::interchange
