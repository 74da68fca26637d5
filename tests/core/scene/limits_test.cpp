// The limits of a scene: the length of its texts, and how much is computed for it.
#include <string>

#include <gtest/gtest.h>

#include "scene/parse.h"

namespace rotatebook::scene {
namespace {

/// The message about `key` with texts of that many letters in it.
std::string errorOfLong(const std::string& key, int letters) {
  std::string text;
  for (int i = 0; i < letters; ++i) text += "é";
  return errorOf("", {key + "='" + text + "'"});
}

void expectLongest(const std::string& key, int most) {
  EXPECT_EQ(errorOfLong(key, most), "no error") << key;
  const std::string error = errorOfLong(key, most + 1);
  const std::string found =
      most + 1 > 200 ? "a string of " + std::to_string(most + 1) + " characters" : "";
  const std::string expected =
      key + " must be a string of at most " + std::to_string(most) + " characters, not " + found;
  EXPECT_NE(error.find(expected), std::string::npos) << key;
}

TEST(Texts, AreOfLimitedLength) {
  expectLongest("title", 200);
  expectLongest("caption", 1000);
  expectLongest("overlay.font", 100);
  expectLongest("book.front", 1000);
}

TEST(Texts, OfPanelsAreOfLimitedLength) {
  const std::string label(101, 'x');
  EXPECT_EQ(
      errorOf("[[panel]]\nlabel = '" + label + "'\n[[panel]]\nlabel = 'b'"),
      "a.toml:2:9: panel.label must be a string of at most 100 characters, not \"" + label + '"');
}

TEST(Texts, HaveNoControlCharacters) {
  const std::string must = " must be a string without control characters, not ";
  EXPECT_EQ(errorOf("title = \"a\\u001b]0;x\\u0007\""),
            "a.toml:1:9: title" + must + "\"a\\u001B]0;x\\u0007\"");
  EXPECT_EQ(errorOf("[book]\nfront = \"a.png\\u0000b\""),
            "a.toml:2:9: book.front" + must + "\"a.png\\u0000b\"");
  for (const char* text : {"\\u009B31m", "\\u202Eb", "a\\u2028b"}) {
    const std::string quoted = std::string("\"") + text + '"';
    EXPECT_EQ(errorOf("caption = " + quoted), "a.toml:1:11: caption" + must + quoted);
    EXPECT_EQ(errorOf("[overlay]\nfont = " + quoted), "a.toml:2:8: overlay.font" + must + quoted);
  }
}

TEST(Texts, AreOnOneLineButForTheCaption) {
  const std::string must = " must be a string on one line, without control characters, not ";
  EXPECT_EQ(errorOf("title = \"two\\nlines\""), "a.toml:1:9: title" + must + "\"two\\nlines\"");
  EXPECT_EQ(errorOf("[book]\nfront = \"a\\tb\""), "a.toml:2:9: book.front" + must + "\"a\\tb\"");
  EXPECT_EQ(errorOf("caption = \"two\\nlines\\tand a tab\""), "no error");
}

constexpr const char* kManySteps = "simulation.substeps = 1000000\n";

TEST(Steps, AreLimitedInAll) {
  const std::string lines = kManySteps + std::string("clip.fps = 60\nclip.duration = ");
  EXPECT_EQ(errorOf(lines + "166"), "no error");
  EXPECT_EQ(
      errorOf(lines + "167"),
      "a.toml:1:23: the clip takes 10020000000 integration steps; the limit is 10000000000 in "
      "all: lower simulation.substeps or clip.duration, or state a longer simulation.step");
  EXPECT_EQ(errorOf("clip.duration = 1000", {"simulation.substeps=1000000"}),
            "--set simulation.substeps=1000000: the clip takes 60000000000 integration steps; the "
            "limit is 10000000000 in all: lower simulation.substeps or clip.duration, or state a "
            "longer simulation.step");
}

TEST(Steps, OfTheExactMotionAreNone) {
  EXPECT_EQ(errorOf("simulation.model = 'exact'\nclip.duration = 1000\n" + std::string(kManySteps)),
            "no error");
}

TEST(Steps, OfAllPanelsCount) {
  const std::string panels =
      "clip.fps = 60\nclip.duration = 100\n"
      "[[panel]]\nlabel = 'a'\n[[panel]]\nlabel = 'b'\nsimulation.substeps = ";
  EXPECT_EQ(errorOf(panels + "999936"), "no error");
  EXPECT_EQ(
      errorOf("clip.fps = 60\nclip.duration = 100\n[[panel]]\nlabel = 'a'\n"
              "simulation.substeps = 1000000\n[[panel]]\nlabel = 'b'\n"
              "simulation.substeps = 1000000"),
      "a.toml:5:23: the clip takes 12000000000 integration steps; the limit is 10000000000 in "
      "all: lower simulation.substeps or clip.duration, or state a longer simulation.step");
}

TEST(Steps, OfATimeLapseCount) {
  const std::string lines = kManySteps + std::string("clip.fps = 60\nclip.duration = 10\n");
  EXPECT_EQ(errorOf(lines + "clip.speed = [{ from = 0, to = 1, value = 2 }]"), "no error");
  EXPECT_EQ(errorOf(lines + "clip.speed = 100", {"simulation.step='1 ms'"}), "no error");
  EXPECT_EQ(errorOf("clip.speed = 100000\nclip.duration = 100", {}),
            "a.toml:1:14: the clip takes 38400000000 integration steps; the limit is 10000000000 "
            "in all: lower simulation.substeps or clip.duration, or state a longer "
            "simulation.step");
  EXPECT_EQ(
      errorOf(lines + "clip.speed = [{ from = 0, to = 1, value = 200 }]"),
      "a.toml:1:23: the clip takes 13140000000 integration steps; the limit is 10000000000 in "
      "all: lower simulation.substeps or clip.duration, or state a longer simulation.step");
}

TEST(Steps, OfAStudyCount) {
  EXPECT_EQ(
      errorOf("clip.fps = 60\nclip.duration = 100\n[study]\n"
              "x = { key = 'simulation.substeps', values = [1000000] }\n"
              "curves = { key = 'simulation.integrator', values = ['rk4', 'dmv6'] }"),
      "a.toml:4:5: the study takes 12000000000 integration steps; the limit is 10000000000 in "
      "all: make fewer runs, or shorter ones");
  EXPECT_EQ(
      errorOf("clip.fps = 60\nclip.duration = 100\nsimulation.substeps = 1000000\n"
              "[study]\nx = { key = 'initial.tilt', values = [0.1, 0.01] }\n"
              "measure = ['flip_law']",
              {"initial.angular_velocity=[5, 0, 0]", "initial.tilt=[0.1, 'z']"}),
      "a.toml:5:5: the study takes 12000000000 integration steps; the limit is 10000000000 in "
      "all: make fewer runs, or shorter ones");
  EXPECT_EQ(
      errorOf("[study]\nduration = 200\ninterval = 0.01\nmeasure = ['order']\n"
              "x = { key = 'simulation.substeps', values = [1000000] }"),
      "a.toml:5:5: the study takes 32001000000 integration steps; the limit is 10000000000 in "
      "all: make fewer runs, or shorter ones");
}

TEST(Samples, OfAStudyAreLimited) {
  const std::string study =
      "study.measure = ['half_turns']\nstudy.x = { key = 'simulation.substeps', values = [1] }\n"
      "study.interval = ";
  EXPECT_EQ(errorOf(study + "0.001\nstudy.duration = 999.999"), "no error");
  EXPECT_EQ(errorOf(study + "0.001\nstudy.duration = 1000"),
            "a.toml:4:18: the study takes 1000001 samples of a motion; the limit is 1000000: lower "
            "study.duration, or raise study.interval");
  EXPECT_EQ(errorOf(study + "1e-300"),
            "a.toml:3:18: the study takes 1000000000000001 samples of a motion; the limit is "
            "1000000: lower study.duration, or raise study.interval");
}

}  // namespace
}  // namespace rotatebook::scene
