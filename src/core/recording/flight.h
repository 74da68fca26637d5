// Finds the flight of a toss, and the rest before it. Inside the room only.
#pragma once

#include <cstddef>
#include <string>
#include <utility>

#include "recording/free_spin_fit.h"
#include "recording/inertial_recording.h"

namespace rotatebook::recording {

inline constexpr std::size_t kMinReadings = 10;      ///< Of a flight.
inline constexpr std::size_t kMaxReadings = 20'000;  ///< Of a flight.

/// The first reading of a flight, and the one after its last.
using Range = std::pair<std::size_t, std::size_t>;

/// Returns the range without the 2 % at each end that may be the hand's; empty if nothing remains.
Range withoutEnds(Range range);

/// Returns the longest run of readings in free flight by the specific force, without its ends;
/// `lever`: TossOptions::lever.
Range longestFlight(const InertialRecording& recording, double lever);

/// Throws InputError, beginning with `name`, for a flight of more than kMaxReadings.
void requireFew(Range flight, const std::string& name);

/// Returns the readings of the stated flight, or else of the longest one by the specific force.
/// Throws InputError, beginning with `name`, for fewer than kMinReadings or more than kMaxReadings.
Range flightIn(const InertialRecording& recording, const std::string& name,
               const TossOptions& options);

/// A rest, and what a gyroscope shows in it.
struct Rest {
  std::size_t readings = 0;           ///< 0 if there is none.
  double duration = 0;                ///< [s]
  Eigen::Vector3d bias{0, 0, 0};      ///< [rad/s]
  double end = 0;                     ///< Time of its last reading. [s]
  Eigen::Vector3d variance{0, 0, 0};  ///< Of the bias, by the scatter of the rates. [rad^2/s^2]
  /// Growth of that variance with time, of a bias that walks at random, by the difference between
  /// the halves of the rest. [rad^2/s^3]
  double drift = 0;
  /// Root mean square of the noise of a rate, by the differences between neighbours; 0 if none
  /// shows. [rad/s]
  double noise = 0;
};

/// Returns the variance of the bias in the middle of a flight after the rest. [rad^2/s^2]
Eigen::Vector3d biasVariance(const Rest& rest, double middle);

/// Returns the longest rest in `before`.
Rest restBefore(Readings before);

}  // namespace rotatebook::recording
