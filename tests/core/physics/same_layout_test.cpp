// Calls into the core from a program that is built with another layout.
#include <cstdlib>
#include <iostream>
#include <string>

#include <gtest/gtest.h>

#include "base/error.h"
#include "base/layout.h"
#include "physics/make_simulator.h"
#include "physics/measure/measurement.h"
#include "physics/simulate.h"
#include "rigid/exact_rotation.h"

namespace rotatebook::physics {
namespace {

/// Makes `call` in a process of its own that was loaded with another layout.
template <typename Call>
[[noreturn]] void callWithOtherLayout(const Call& call) {
  static Layout other = layoutHere();
  other.eigenIsRowMajor = true;
  if (noteLayout(other)) std::exit(2);
  try {
    call();
  } catch (const InputError& error) {
    std::cerr << error.what();
    std::exit(1);
  }
  std::exit(0);
}

const auto kExits = testing::ExitedWithCode(1);
constexpr const char* kRowMajor = "without -DEIGEN_DEFAULT_TO_ROW_MAJOR, this program with it";

TEST(SameLayoutDeathTest, IsCheckedByWhicheverCallComesFirst) {
  MotionSettings settings;
  settings.initial.value = {5, 0.01, 0};
  const rigid::PrincipalAxes axes;
  EXPECT_EXIT(callWithOtherLayout([&] { makeSimulator(settings); }), kExits, kRowMajor);
  EXPECT_EXIT(callWithOtherLayout([&] { simulate(settings, 1); }), kExits, kRowMajor);
  EXPECT_EXIT(callWithOtherLayout([&] { Measurement{settings}; }), kExits, kRowMajor);
  EXPECT_EXIT(callWithOtherLayout([&] {
                rigid::ExactMotion({1, 2, 3}, {0, 5, 0});
              }),
              kExits, kRowMajor);
  EXPECT_EXIT(callWithOtherLayout([&] { rigid::ExactRotation(axes, Eigen::Vector3d(0, 5, 0)); }),
              kExits, kRowMajor);
}

/// Notes that T has 16 bytes more in the program than `here` in the library, and exits with the
/// message of the next call.
template <typename T>
[[noreturn]] void callWithOtherSize(const char* name, std::size_t here) {
  if (!noteSize(name, here, sizeof(T)) || noteSize(name, here, sizeof(T) + 16)) std::exit(2);
  try {
    makeSimulator({});
  } catch (const InputError& error) {
    std::cerr << error.what();
    std::exit(1);
  }
  std::exit(0);
}

/// Returns what is to be said of a T that is 16 bytes larger in the program.
template <typename T>
std::string aboutSize(const std::string& name) {
  return "rotatebook was built with a " + name + " of " + std::to_string(sizeof(T)) +
         " bytes, this program with one of " + std::to_string(sizeof(T) + 16) +
         "; build both with the same headers and flags";
}

TEST(SameLayoutDeathTest, TypesOfAnotherSizeAreRefused) {
  EXPECT_EXIT(callWithOtherSize<Sample>("physics::Sample", kSampleSize), kExits,
              aboutSize<Sample>("physics::Sample"));
  EXPECT_EXIT(callWithOtherSize<Trajectory>("physics::Trajectory", kTrajectorySize), kExits,
              aboutSize<Trajectory>("physics::Trajectory"));
  EXPECT_EXIT(callWithOtherSize<BodyState>("physics::BodyState", kBodyStateSize), kExits,
              aboutSize<BodyState>("physics::BodyState"));
  EXPECT_EXIT(callWithOtherSize<MotionSettings>("physics::MotionSettings", kMotionSettingsSize),
              kExits, aboutSize<MotionSettings>("physics::MotionSettings"));
}

}  // namespace
}  // namespace rotatebook::physics
