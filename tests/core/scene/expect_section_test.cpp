#include <limits>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scene/names.h"
#include "scene/parse.h"

namespace rotatebook::scene {
namespace {

TEST(ExpectSection, ReadsEveryBound) {
  const Scene scene = sceneFrom(
      "[expect]\ntilt_deg = { min = -1, max = 2, rises_to = 1.5, falls_to = 0, from = 3, to = 4 }");
  ASSERT_EQ(scene.motions[0].expectations.size(), 1u);
  EXPECT_EQ(scene.motions[0].expectations[0], (Expectation{Measure::TiltDeg, -1, 2, 1.5, 0, 3, 4}));
}

TEST(ExpectSection, ReadsArraysAndKeepsTheOrder) {
  const Scene scene = sceneFrom(
      "[expect]\nstretch = [{ max = 1.01, to = 2 }, { rises_to = 2, from = 2 }]\n"
      "half_turns.min = 3\n[[expect.energy_ratio]]\nmax = 9");
  constexpr double kNoEnd = std::numeric_limits<double>::infinity();
  const std::vector<Expectation> expected{
      {Measure::Stretch, {}, 1.01, {}, {}, 0, 2},
      {Measure::Stretch, {}, {}, 2, {}, 2, kNoEnd},
      {Measure::HalfTurns, 3, {}, {}, {}, 0, kNoEnd},
      {Measure::EnergyRatio, {}, 9, {}, {}, 0, kNoEnd},
  };
  EXPECT_EQ(scene.motions[0].expectations, expected);
}

TEST(ExpectSection, KnowsEveryQuantity) {
  for (const Measure measure : kMeasuresOfMotions) {
    const std::string name(nameOf(measure));
    const Scene scene = sceneFrom("expect." + name + ".min = 1");
    ASSERT_EQ(scene.motions[0].expectations.size(), 1u) << name;
    EXPECT_EQ(scene.motions[0].expectations[0].measure, measure) << name;
  }
}

TEST(ExpectSection, RefusesUnknownKeys) {
  EXPECT_EQ(errorOf("[expect]\nhalf_turn = { min = 3 }"),
            "a.toml:2:1: unknown key \"half_turn\" in [expect]; did you mean \"half_turns\"?");
  EXPECT_EQ(errorOf("[expect]\nhalf_turns = { mni = 3 }"),
            "a.toml:2:16: unknown key \"mni\" in [expect.half_turns]; did you mean \"min\"?");
  EXPECT_EQ(errorOf("[expect]\nhalf_turns = { least = 3 }"),
            "a.toml:2:16: unknown key \"least\" in [expect.half_turns]; valid are \"min\", "
            "\"max\", \"rises_to\", \"falls_to\", \"from\" and \"to\"");
}

TEST(ExpectSection, RefusesBoundsThatBoundNothing) {
  const std::string needs =
      ": expect.half_turns needs at least one of min, max, rises_to and falls_to";
  EXPECT_EQ(errorOf("[expect]\nhalf_turns = {}"), "a.toml:2:14" + needs);
  EXPECT_EQ(errorOf("[expect]\nhalf_turns = [{ max = 1 }, { from = 1, to = 2 }]"),
            "a.toml:2:28" + needs);
  const std::string must =
      "expect.half_turns must be a table such as { min = 1.0 } or an array of them, not ";
  EXPECT_EQ(errorOf("[expect]\nhalf_turns = 3"), "a.toml:2:14: " + must + "3");
  EXPECT_EQ(errorOf("[expect]\nhalf_turns = []"), "a.toml:2:14: " + must + "[]");
  EXPECT_EQ(errorOf("[expect]\nhalf_turns = [{ min = 1 }, 3]"), "a.toml:2:28: " + must + "3");
}

TEST(ExpectSection, RefusesBoundsThatCannotBeMet) {
  EXPECT_EQ(errorOf("[expect]\nstretch = { max = 1, min = 1.5 }"),
            "a.toml:2:28: expect.stretch.min must be at most max, 1.0, not 1.5");
  EXPECT_EQ(errorOf("[expect]\nstretch = { max = 1, from = 3, to = 2 }"),
            "a.toml:2:29: expect.stretch.from must be at most to, 2.0, not 3");
  EXPECT_EQ(errorOf("[expect]\nstretch = { max = 1, from = -3 }"),
            "a.toml:2:29: expect.stretch.from must be zero or a positive number, not -3");
  EXPECT_EQ(errorOf("[expect]\nstretch = { max = 1, to = inf }"),
            "a.toml:2:27: expect.stretch.to must be zero or a positive number, not inf");
}

TEST(ExpectSection, RefusesBoundsThatAreNoNumbers) {
  for (const std::string bound : {"min", "max", "rises_to", "falls_to"}) {
    const std::string key = "expect.stretch." + bound;
    const std::string place = "a.toml:1:" + std::to_string(key.size() + 2) + ": ";
    EXPECT_EQ(errorOf(key + "=nan"), place + key + " must be a number, not nan");
    EXPECT_EQ(errorOf(key + "=true"), place + key + " must be a number, not true");
  }
}

TEST(ExpectSection, TakesBoundsThatMeet) {
  EXPECT_EQ(errorOf("[expect]\nhalf_turns = { min = 3, max = 3, from = 2, to = 2 }"), "no error");
}

}  // namespace
}  // namespace rotatebook::scene
