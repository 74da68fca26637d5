#include "recording/recorded_motion.h"

#include <algorithm>
#include <utility>

namespace rotatebook::recording {

const std::size_t kRecordedMomentSize = sizeof(RecordedMoment);

namespace {

constexpr std::size_t kAround = 4;

/// Returns the change of the attitude with time. [1/s]
Eigen::Vector4d changeOf(const RecordedMoment& moment) {
  const Eigen::Vector3d half = moment.angularVelocity / 2;
  const Eigen::Quaterniond rate(0, half.x(), half.y(), half.z());
  return (moment.attitude * rate).coeffs();
}

/// Returns the attitude between two moments, at the fraction `u` of the time.
Eigen::Quaterniond attitudeBetween(const RecordedMoment& a, const RecordedMoment& b, double u) {
  const double h = b.time - a.time;
  const double v = 1 - u;
  const Eigen::Vector4d ends =
      (1 + 2 * u) * v * v * a.attitude.coeffs() + u * u * (1 + 2 * v) * b.attitude.coeffs();
  const Eigen::Vector4d slopes = u * v * v * h * changeOf(a) - u * u * v * h * changeOf(b);
  Eigen::Quaterniond attitude;
  attitude.coeffs() = ends + slopes;
  attitude.normalize();
  return attitude;
}

}  // namespace

std::size_t firstAround(std::size_t index, std::size_t count) {
  const std::size_t most = count > kAround ? count - kAround : 0;
  return std::min(index > 0 ? index - 1 : 0, most);
}

RecordedMotion::RecordedMotion(std::vector<RecordedMoment> moments) : moments_(std::move(moments)) {
  const Eigen::Quaterniond startFromWorld = moments_.front().attitude.conjugate();
  const double start = moments_.front().time;
  const RecordedMoment* before = nullptr;
  for (RecordedMoment& moment : moments_) {
    moment.time -= start;
    moment.attitude = startFromWorld * moment.attitude;
    moment.attitude.normalize();
    // Both signs are the same attitude; those of neighbours must be close.
    if (before != nullptr && moment.attitude.dot(before->attitude) < 0) {
      moment.attitude.coeffs() = -moment.attitude.coeffs();
    }
    before = &moment;
  }
  moments_.front().attitude = Eigen::Quaterniond::Identity();
}

RecordedMoment RecordedMotion::at(double time) const {
  const auto isBefore = [](double t, const RecordedMoment& moment) { return t < moment.time; };
  const auto next = std::upper_bound(moments_.begin(), moments_.end(), time, isBefore);
  if (next == moments_.begin()) return moments_.front();
  if (next == moments_.end()) return moments_.back();
  const auto index = static_cast<std::size_t>(next - moments_.begin()) - 1;
  const RecordedMoment& a = moments_[index];
  if (time == a.time) return a;
  RecordedMoment moment;
  moment.time = time;
  moment.attitude = attitudeBetween(a, *next, (time - a.time) / (next->time - a.time));
  moment.angularVelocity = polynomialAt(
      time, firstAround(index, moments_.size()), std::min(kAround, moments_.size()),
      [this](std::size_t i) { return moments_[i].time; },
      [this](std::size_t i) { return moments_[i].angularVelocity; });
  return moment;
}

RecordedMotion RecordedMotion::part(double from, double to) const {
  std::vector<RecordedMoment> within{at(from)};
  within.front().time = from;
  for (const RecordedMoment& moment : moments_) {
    if (moment.time > from && moment.time < to) within.push_back(moment);
  }
  within.push_back(at(to));
  within.back().time = to;
  return RecordedMotion(std::move(within));
}

}  // namespace rotatebook::recording
