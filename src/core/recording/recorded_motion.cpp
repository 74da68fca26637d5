#include "recording/recorded_motion.h"

#include <algorithm>
#include <utility>

namespace rotatebook::recording {

const std::size_t kRecordedMomentSize = sizeof(RecordedMoment);

namespace {

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
  // Turns of many rounds between two moments may cancel all of it.
  constexpr double kNothing = 1e-9;
  if (!(attitude.norm() > kNothing)) return a.attitude;
  attitude.normalize();
  return attitude;
}

}  // namespace

RecordedMotion::RecordedMotion(std::vector<RecordedMoment> moments, const SpinFacts& spins)
    : moments_(std::move(moments)), spins_(spins) {
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
  const auto timeOf = [this](std::size_t i) { return moments_[i].time; };
  moment.angularVelocity =
      polynomialAt(time, stencilAround(index, moments_.size(), timeOf), timeOf,
                   [this](std::size_t i) { return moments_[i].angularVelocity; });
  return moment;
}

void RecordedMotion::setFlaws(const std::vector<std::string>& texts, double largestStray,
                              RecordedMotion sound) {
  largestStray_ = largestStray;
  flaws_ = texts;
  notes_.insert(notes_.end(), texts.begin(), texts.end());
  sound_ = std::make_shared<const RecordedMotion>(std::move(sound));
}

RecordedMotion RecordedMotion::part(double from, double to) const {
  std::vector<RecordedMoment> within{at(from)};
  within.front().time = from;
  for (const RecordedMoment& moment : moments_) {
    if (moment.time > from && moment.time < to) within.push_back(moment);
  }
  within.push_back(at(to));
  within.back().time = to;
  return RecordedMotion(std::move(within), spins_);
}

}  // namespace rotatebook::recording
