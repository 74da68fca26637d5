// A motion that was recorded, at any time within it.
#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "base/layout.h"

namespace rotatebook::recording {

/// A body's attitude and spin at one moment of a recording.
struct RecordedMoment {
  double time = 0;  ///< [s]
  /// World from body, of unit norm.
  Eigen::Quaterniond attitude = Eigen::Quaterniond::Identity();
  Eigen::Vector3d angularVelocity{0, 0, 0};  ///< In body axes. [rad/s]
};

/// Sources of the spins of a recording.
enum class SpinSource {
  Given,      ///< Rates beside attitudes.
  Slopes,     ///< Of attitudes alone.
  Gyroscope,  ///< Rates alone.
};

/// Rates as a multiple of the slopes of the attitudes beside them, with a bias or turned, or either
/// where a spin that hardly leaves its axis doesn't tell. What
/// isn't significant beside what they leave, is 1 and 0.
struct RateFit {
  double factor = 1;              ///< Of the slopes. [-]
  Eigen::Vector3d bias{0, 0, 0};  ///< [rad/s]
  Eigen::Vector3d turn{0, 0, 0};  ///< Rotation vector. [rad]
  bool isAlongBody = false;       ///< Bias and turn; else along the axes of the file's world.

  bool isOff() const { return factor != 1 || !bias.isZero(0) || !turn.isZero(0); }
};

/// The source of the spins of a recording, and their quality.
struct SpinFacts {
  SpinSource source = SpinSource::Given;
  /// Of slopes: root mean square of those of order 4 minus those of order 2, relative to the
  /// former, which the error of those of order 4 is below. [-]
  double uncertainty = 0;
  /// Of rates beside attitudes: RateComparison::difference [-]
  double difference = 0;
  RateFit fit{};  ///< RateComparison::fit
  /// Of rates alone: by how much the attitude may be off where readings are far apart. [rad]
  double unknownTurn = 0;
};

/// Moments in the order of their times, and the motion between them. It begins at time 0, when body
/// and world axes agree: the recording's own world is turned so.
class RecordedMotion {
 public:
  /// Takes at least two moments, at ascending times; the first is to be time 0.
  explicit RecordedMotion(std::vector<RecordedMoment> moments, const SpinFacts& spins = {});

  const std::vector<RecordedMoment>& moments() const { return moments_; }
  const SpinFacts& spins() const { return spins_; }
  /// Returns the time of the last moment, > 0. [s]
  double duration() const { return moments_.back().time; }
  /// Returns the body at a time within the recording, or at its nearer end: between two moments the
  /// attitude is the cubic that has their attitudes and spins, of unit norm; the spin is the cubic
  /// through two moments on each side. [s]
  RecordedMoment at(double time) const;
  /// Returns the part from `from` to `to`, which are within the recording. [s]
  RecordedMotion part(double from, double to) const;
  /// Returns what its reader left out or doubts, a sentence each without a full stop.
  const std::vector<std::string>& notes() const { return notes_; }
  void note(const std::string& text) { notes_.push_back(text); }
  /// Returns the flaws of single rows, which are among the notes, too; see flawsIn().
  const std::vector<std::string>& flaws() const { return flaws_; }
  /// Returns the motion without its flaws; null without any.
  const RecordedMotion* sound() const { return sound_.get(); }
  /// Returns by how much the attitude of a row that is left out there is off, at most. [rad]
  double largestStray() const { return largestStray_; }
  void setFlaws(const std::vector<std::string>& texts, double largestStray, RecordedMotion sound);

 private:
  std::vector<RecordedMoment> moments_;
  std::vector<std::string> notes_, flaws_;
  std::shared_ptr<const RecordedMotion> sound_;
  double largestStray_ = 0;
  SpinFacts spins_;
};

/// Neighbouring moments.
struct Stencil {
  std::size_t first = 0, count = 0;
};

/// Returns up to four moments, at ascending times, around the gap after moment `index` of `count`:
/// its ends, and one before and one after it or, at an end, two on the other side. Left out are
/// those at gaps of less than a tenth of this one, and what lies beyond: a cubic through times that
/// close together would swing.
template <typename TimeOf>
Stencil stencilAround(std::size_t index, std::size_t count, const TimeOf& timeOf) {
  constexpr double kEven = 0.1;
  constexpr std::size_t kMaxMoments = 4;
  const double enough = kEven * (timeOf(index + 1) - timeOf(index));
  const std::size_t lowest = std::min(index > 0 ? index - 1 : 0,
                                      count > kMaxMoments ? count - kMaxMoments : std::size_t{0});
  const std::size_t highest = std::min(lowest + kMaxMoments, count) - 1;
  std::size_t first = index, last = index + 1;
  while (first > lowest && timeOf(first) - timeOf(first - 1) >= enough) --first;
  while (last < highest && timeOf(last + 1) - timeOf(last) >= enough) ++last;
  return {first, last - first + 1};
}

/// Returns the value at `time` of the polynomial through the stencil's values at their times.
template <typename ValueOf, typename TimeOf>
Eigen::Vector3d polynomialAt(double time, Stencil stencil, const TimeOf& timeOf,
                             const ValueOf& valueOf) {
  const std::size_t first = stencil.first, count = stencil.count;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (std::size_t i = first; i < first + count; ++i) {
    double weight = 1;
    for (std::size_t k = first; k < first + count; ++k) {
      if (k != i) weight *= (time - timeOf(k)) / (timeOf(i) - timeOf(k));
    }
    sum += weight * valueOf(i);
  }
  return sum;
}

extern const std::size_t kRecordedMomentSize;  // in the library
namespace {
[[maybe_unused]] const bool kRecordedMomentIsSame =
    noteSize("recording::RecordedMoment", kRecordedMomentSize, sizeof(RecordedMoment));
}  // namespace

}  // namespace rotatebook::recording
