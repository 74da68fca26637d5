// Units by the names that programs write. Inside the room only.
#pragma once

#include <algorithm>
#include <iterator>
#include <numbers>
#include <optional>
#include <string_view>

#include "recording/words.h"

namespace rotatebook::recording {

/// A unit, and names of it in small letters and without blanks, separated by blanks.
struct Unit {
  double value;
  std::string_view names;
};

/// [s]
inline constexpr Unit kUnitsOfTimes[]{
    {1, "s sec secs second seconds"},
    {1e-3, "ms msec msecs milli millis millisecond milliseconds"},
    {1e-6, "us usec usecs micro micros \xC2\xB5s \xCE\xBCs microsecond microseconds"},
    {1e-9, "ns nsec nsecs nano nanos nanosec nanosecs nanosecond nanoseconds"},
    {60, "min mins minute minutes"}};

/// [rad/s] The last names of the first two are those with a dot and superscripts.
inline constexpr Unit kUnitsOfRates[]{
    {1,
     "rad/s rads rad/sec radians/s radians/sec radian/s radian/sec rads/s rads^-1 rads-1 rad*s^-1 "
     "rad.s^-1 rad.s-1 radps radpersec radpers radianspersecond rad rads\xE2\x81\xBB\xC2\xB9 "
     "rad\xC2\xB7s\xE2\x81\xBB\xC2\xB9 rad\xC2\xB7s^-1"},
    {std::numbers::pi / 180,
     "deg/s dps deg/sec degrees/s degrees/sec degree/s degree/sec degs/s degs degs^-1 degs-1 "
     "deg*s^-1 deg.s^-1 d/s degps degpersec degpers degreespersecond \xC2\xB0/s \xC2\xB0/sec deg "
     "\xC2\xB0s\xE2\x81\xBB\xC2\xB9 \xC2\xB0s-1"},
    {std::numbers::pi / 180'000,
     "mdps mdeg/s millideg/s millidegs millidegrees/s mdegps mdegs milli-deg/s m\xC2\xB0/s"},
    {1e-3, "mrad/s mrads mradps millirad/s"},
    {2 * std::numbers::pi, "turns/s turn/s rev/s revs/s rps"},
    {std::numbers::pi / 30, "rpm rev/min turns/min"}};

inline constexpr double kGravity = 9.80665;  ///< [m/s^2]

/// [m/s^2]
inline constexpr Unit kUnitsOfAccelerations[]{
    {1,
     "m/s^2 m/s2 m/s/s m/s**2 m/sec^2 m/sec2 m/(s^2) m/(sec^2) ms^-2 ms-2 ms^2 m*s^-2 m.s^-2 mps2 "
     "ms2 "
     "mss m/s\xC2\xB2 ms\xE2\x81\xBB\xC2\xB2 m\xC2\xB7s\xE2\x81\xBB\xC2\xB2"},
    {0.01, "cm/s^2 cm/s2 cm/s\xC2\xB2"},
    {kGravity, "g gs g's gn gee"},
    {kGravity / 1000, "mg mgs milli-g millig"}};

/// Returns the unit of that name; nothing if it isn't one.
template <typename Units>
std::optional<double> unitNamed(const Units& units, std::string_view name) {
  const auto found =
      std::ranges::find_if(units, [&](const Unit& unit) { return isAmong(unit.names, name); });
  return found != std::end(units) ? std::optional(found->value) : std::nullopt;
}

}  // namespace rotatebook::recording
