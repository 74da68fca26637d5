#include "physics/layout.h"

#include <cstdlib>
#include <iostream>
#include <string>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "physics/exact/exact_rotation.h"
#include "physics/make_simulator.h"
#include "physics/measure/measurement.h"
#include "physics/simulate.h"

namespace rotatebook::physics {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

/// Returns the message about a program that was built with `layout`; "" if there is none.
std::string refusal(const Layout& layout) {
  try {
    requireSameLayout(layout);
    return "";
  } catch (const InputError& error) {
    return error.what();
  }
}

TEST(Layout, IsTheSameHere) {
  EXPECT_EQ(refusal(layoutHere()), "");
  EXPECT_TRUE(noteLayout(kLayoutHere));
  EXPECT_NO_THROW(requireSameLayout());
}

TEST(Layout, OfAnotherVersionIsRefused) {
  Layout other = layoutHere();
  other.version = "9.8.7";
  other.fastMath = !other.fastMath;  // Not read: another version may have other members.
  EXPECT_EQ(refusal(other), "this is rotatebook " + std::string(kVersion) +
                                ", but this program was built with the headers of 9.8.7; build it "
                                "with the headers of the library that it links");
}

TEST(Layout, WithAnotherFlagIsRefusedByItsName) {
  for (const auto& [flag, name] :
       {std::pair{&Layout::eigenDoesNotVectorize, "-DEIGEN_DONT_VECTORIZE"},
        std::pair{&Layout::eigenIsRowMajor, "-DEIGEN_DEFAULT_TO_ROW_MAJOR"},
        std::pair{&Layout::contractionIsOff, "-ffp-contract=off"},
        std::pair{&Layout::fastMath, "-ffast-math"},
        std::pair{&Layout::associativeMath, "-fassociative-math"},
        std::pair{&Layout::reciprocalMath, "-freciprocal-math"},
        std::pair{&Layout::noSignedZeros, "-fno-signed-zeros"},
        std::pair{&Layout::finiteMathOnly, "-ffinite-math-only"}}) {
    Layout other = layoutHere();
    const std::string here = other.*flag ? "with " : "without ";
    const std::string there = other.*flag ? "without" : "with";
    other.*flag = !(other.*flag);
    EXPECT_THAT(refusal(other), AllOf(HasSubstr("rotatebook was built " + here + name +
                                                ", this program " + there + " it; "),
                                      testing::ContainsRegex("; (link|build)")));
  }
}

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

TEST(LayoutDeathTest, IsCheckedByWhicheverCallComesFirst) {
  MotionSettings settings;
  settings.initial.value = {5, 0.01, 0};
  const PrincipalAxes axes;
  EXPECT_EXIT(callWithOtherLayout([&] { makeSimulator(settings); }), kExits, kRowMajor);
  EXPECT_EXIT(callWithOtherLayout([&] { simulate(settings, 1); }), kExits, kRowMajor);
  EXPECT_EXIT(callWithOtherLayout([&] { Measurement{settings}; }), kExits, kRowMajor);
  EXPECT_EXIT(callWithOtherLayout([&] { ExactMotion({1, 2, 3}, {0, 5, 0}); }), kExits, kRowMajor);
  EXPECT_EXIT(callWithOtherLayout([&] { ExactRotation(axes, Eigen::Vector3d(0, 5, 0)); }), kExits,
              kRowMajor);
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

TEST(LayoutDeathTest, TypesOfAnotherSizeAreRefused) {
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
