#include "timeline/motion_checksum.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "base/checksum.h"
#include "scene/small_scene.h"

namespace rotatebook::timeline {
namespace {

using physics::Sample;
using physics::Trajectory;

Trajectory twoSamples() {
  Trajectory trajectory{.interval = 0.25, .samples = {Sample{}, Sample{}}};
  trajectory.samples[1].time = 0.25;
  return trajectory;
}

std::string sumOf(const Trajectory& trajectory) {
  return motionChecksum(ClipMotion({trajectory}, {}));
}

std::string sumAfter(const std::function<void(Sample&)>& change) {
  Trajectory trajectory = twoSamples();
  change(trajectory.samples[1]);
  return sumOf(trajectory);
}

// As the header documents it: built anew, by hand.
TEST(MotionChecksum, IsOfTheDocumentedBytes) {
  std::string bytes;
  const auto add = [&bytes](double number) {
    const auto bits = std::bit_cast<std::uint64_t>(number);
    for (int i = 0; i < 8; ++i) bytes += static_cast<char>(bits >> 8 * i);
  };
  bytes += std::string("\x01\0\0\0\0\0\0\0", 8);
  add(0.5);
  add(-1);
  add(2);  // time
  for (const double part : {0.1, 0.2, 0.3, 0.4}) add(part);
  for (int i = 0; i < 6; ++i) add(i);  // angular velocity and momentum
  add(7);
  add(8);
  bytes += std::string("\x03\0\0\0\0\0\0\0", 8);  // half-turns
  for (int i = 0; i < 24; ++i) add(100 + i);
  Sample sample;
  sample.time = 2;
  sample.attitude = Eigen::Quaterniond(0.1, 0.2, 0.3, 0.4);
  sample.angularVelocity = {0, 1, 2};
  sample.angularMomentum = {3, 4, 5};
  sample.kinetic = 7;
  sample.potential = 8;
  sample.halfTurns = 3;
  for (int i = 0; i < 24; ++i) sample.cage.data()[i] = 100 + i;
  EXPECT_EQ(sumOf({.interval = 0.5, .samples = {sample}}), checksumOf(bytes));
}

TEST(MotionChecksum, ChangesWithTheLastBitOfAllThatPicturesDependOn) {
  const std::string sum = sumOf(twoSamples());
  const auto next = [](double& number) { number = std::nextafter(number, 1e9); };
  const std::vector<std::function<void(Sample&)>> changes{
      [&](Sample& s) { next(s.time); },
      [&](Sample& s) { next(s.attitude.w()); },
      [&](Sample& s) { next(s.attitude.z()); },
      [&](Sample& s) { next(s.angularVelocity[2]); },
      [&](Sample& s) { next(s.angularMomentum[0]); },
      [&](Sample& s) { next(s.kinetic); },
      [&](Sample& s) { next(s.potential); },
      [&](Sample& s) { ++s.halfTurns; },
      [&](Sample& s) { next(s.cage(0, 0)); },
      [&](Sample& s) { next(s.cage(2, 7)); },
      [&](Sample& s) { s.kinetic = -0.0; }};
  for (std::size_t i = 0; i < changes.size(); ++i) EXPECT_NE(sumAfter(changes[i]), sum) << i;
  EXPECT_EQ(sumAfter([](Sample& s) { s.errorDeg = 1; }), sum);
}

TEST(MotionChecksum, ChangesWithTheMotionsShape) {
  const std::string sum = sumOf(twoSamples());
  Trajectory other = twoSamples();
  other.divergedAt = 0.5;
  EXPECT_NE(sumOf(other), sum);
  other = twoSamples();
  other.samples.pop_back();
  EXPECT_NE(sumOf(other), sum);
  EXPECT_NE(motionChecksum(ClipMotion({twoSamples(), twoSamples()}, {})), sum);
}

TEST(MotionChecksum, IsTheSameEachTime) {
  const scene::Scene scene = scene::testing::smallScene();
  EXPECT_EQ(motionChecksum(simulateScene(scene)), motionChecksum(simulateScene(scene)));
  EXPECT_NE(motionChecksum(simulateScene(scene)),
            motionChecksum(simulateScene(scene::testing::smallScene({"simulation.substeps=65"}))));
}

}  // namespace
}  // namespace rotatebook::timeline
