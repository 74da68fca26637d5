// The inertia of a body from the gyroscope that flew with it.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "recording/inertial_recording.h"

namespace rotatebook::recording {

/// A ratio of moments, and the part of its interval that a body can have.
struct Estimate {
  double value = 0, low = 0, high = 0;
};

/// Results of a toss.
struct TossFit {
  double from = 0, to = 0;        ///< The flight, of the recording's times. [s]
  std::size_t readings = 0;       ///< In the flight.
  Eigen::Vector3d bias{0, 0, 0};  ///< Of the gyroscope, from the rest before; 0 without. [rad/s]
  double rest = 0;                ///< Duration of that rest; 0 if there is none. [s]
  /// The inertia tensor in the gyroscope's axes, as a multiple of the largest principal moment. One
  /// that no body has, by its error, is replaced by the nearest flat body's.
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Identity();
  std::array<Estimate, 2> ratios{};  ///< I1/I3 and I2/I3, for I1 <= I2 <= I3.
  Eigen::Vector3d start{0, 0, 0};    ///< Angular velocity at the flight's start. [rad/s]
  double spin = 0;                   ///< Root mean square of its size in the flight. [rad/s]
  double residual = 0;  ///< Root mean square of a rate minus that of the fitted motion. [rad/s]
  double noise = 0;     ///< Root mean square of a rate's noise at rest; 0 if not known. [rad/s]
  /// Of the intervals that hold by noise alone: over 1 where the residual is larger than that, as
  /// errors of scale, alignment and stamps make it.
  double widening = 1;
  /// Smallest but one by smallest singular value: how far the motion tells one inertia from all
  /// others.
  double gap = 0;
  bool isMeasured = true;            ///< InertialRecording::isMeasured
  std::vector<std::string> notes{};  ///< As RecordedMotion::notes().
};

/// Gap below which a motion doesn't tell its inertia. [-] Steady spins have 1 to 2, tosses that
/// tumble have hundreds.
inline constexpr double kSmallestGap = 5;
/// Residual, as a part of the spin, above which a motion is no free flight. Tosses of good phones
/// have 0.001 to 0.02, windows that hold a catch 0.2 to 0.6.
inline constexpr double kLargestResidual = 0.05;

/// The flight of a toss.
struct Flight {
  double from = 0, to = 0;         ///< Of the recording's times. [s]
  Eigen::Vector3d start{0, 0, 0};  ///< The rate as it is read at the flight's start. [rad/s]
};

/// Returns the flight that fitToss() takes by the specific force, unfitted; nothing for fewer than
/// 10 readings.
std::optional<Flight> findFlight(const InertialRecording& recording);

/// Fits the inertia, up to its scale, and the motion to the rates of a flight. Start values: with
/// the attitudes R from the rates, R I w - L = 0 is linear in the entries of I and L, and one
/// eigenvalue problem gives them. From there the rates of the free motion are fitted to
/// those measured by Gauss and Newton's method, whose covariance gives intervals that hold in 95 of
/// 100 tosses by noise alone, with that of the bias by the scatter of the rest's rates; they are
/// widened where the residual is larger than the noise at rest, as though what isn't noise were
/// alike for a quarter of the flight, and cut to what bodies can have. The flight is the stated
/// one; else where the specific force stays below 2 m/s^2 and the centripetal part, without its
/// first and last 2 %; without an accelerometer the only one of findThrows() that is accepted.
/// Throws InputError, beginning with `name`, if no flight of 10 readings is found, if the motion
/// doesn't tell the inertia, if its residual is above kLargestResidual, if the gyroscope clips, and
/// if a ratio's interval is wider than 0.5.
TossFit fitToss(const InertialRecording& recording, const std::string& name,
                const TossOptions& options);

/// A flight in a recording, or a fast stretch without one.
struct Throw {
  double from = 0, to = 0;  ///< Of the recording's times. [s]
  bool isFlight = true;
  double spin = 0;             ///< Root mean square of its size. [rad/s]
  std::optional<TossFit> fit;  ///< Nothing if it is refused.
  std::string refusal{};       ///< Why, beginning with the recording's name.
};

/// Returns the flights that the rates alone show, and the fast stretches that have none, within the
/// options' part; see fastStretches().
std::vector<Throw> findThrows(const InertialRecording& recording, const std::string& name,
                              const TossOptions& options);

}  // namespace rotatebook::recording
