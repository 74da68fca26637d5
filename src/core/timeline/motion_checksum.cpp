#include "timeline/motion_checksum.h"

#include <bit>
#include <cstdint>
#include <limits>

#include "base/checksum.h"

namespace rotatebook::timeline {
namespace {

static_assert(std::numeric_limits<double>::is_iec559 && sizeof(double) == sizeof(std::uint64_t));

void append(std::uint64_t bits, std::string& bytes) {
  for (int shift = 0; shift < 64; shift += 8) bytes += static_cast<char>(bits >> shift & 0xff);
}

void append(double number, std::string& bytes) {
  append(std::bit_cast<std::uint64_t>(number), bytes);
}

template <typename Values>
void appendAll(const Values& values, std::string& bytes) {
  for (Eigen::Index i = 0; i < values.size(); ++i) append(values.data()[i], bytes);
}

std::string bytesOf(const physics::Sample& sample) {
  std::string bytes;
  append(sample.time, bytes);
  append(sample.attitude.w(), bytes);
  appendAll(sample.attitude.vec(), bytes);
  appendAll(sample.angularVelocity, bytes);
  appendAll(sample.angularMomentum, bytes);
  append(sample.kinetic, bytes);
  append(sample.potential, bytes);
  append(static_cast<std::uint64_t>(sample.halfTurns), bytes);
  appendAll(sample.cage, bytes);  // Column by column: corner by corner.
  return bytes;
}

std::string headOf(const physics::Trajectory& trajectory) {
  std::string bytes;
  append(static_cast<std::uint64_t>(trajectory.samples.size()), bytes);
  append(trajectory.interval, bytes);
  append(trajectory.divergedAt.value_or(-1), bytes);
  return bytes;
}

}  // namespace

std::string motionChecksum(const ClipMotion& motion) {
  requireSameLayout();
  Checksum sum;
  for (const physics::Trajectory& trajectory : motion.trajectories()) {
    sum.add(headOf(trajectory));
    for (const physics::Sample& sample : trajectory.samples) sum.add(bytesOf(sample));
  }
  return sum.text();
}

}  // namespace rotatebook::timeline
