#include "bridge/bridge.h"

#include <cmath>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/document/toml_json.h"
#include "browser/bridge/bridge_slots.h"
#include "scene/scene_text.h"
#include "timeline/motion_checksum.h"
#include "timeline/simulate_scene.h"

namespace rotatebook::bridge {
namespace {

using testing::context;
using testing::giveFile;
using ::testing::HasSubstr;
using testing::kAll;
using testing::kFrames;
using testing::kScene;
using testing::put;
using testing::read;
using testing::readAnew;
using testing::taken;
using testing::with;

std::string wholeChecksum(std::string_view text) {
  return timeline::motionChecksum(timeline::simulateScene(scene::parseScene(text, "scene.toml")));
}

TEST(Bridge, HasTheMotionOfTheProgramInSlices) {
  readAnew(0, kScene);
  for (int frame = 0; rb_advance(context(), 0, frame, kAll) < kFrames; frame += 7) {
    EXPECT_LT(rb_checksum(context(), 0), 0) << "before the end";
  }
  EXPECT_EQ(taken(rb_checksum(context(), 0)), wholeChecksum(kScene));
  // Another nudge is another motion.
  EXPECT_NE(taken(rb_checksum(context(), 0)), wholeChecksum(with(kScene, "0.2", "0.3")));
}

TEST(Bridge, TellsTheCaptionsInTimeWithTheirFrames) {
  const std::string text =
      std::string(kScene) +
      "[[cue]]\nat = 0.25\ntext = \"Once \\\"more\\\"\"\n[[cue]]\nat = 0.5\nhold = 0.1\n"
      "[[cue]]\nat = \"flip 1\"\ntext = \"Over\"\n";
  const std::string json = taken(rb_read(context(), 0, put(text)));
  EXPECT_THAT(json, HasSubstr("\"captions\":[[15,\"Once \\\"more\\\"\"],["));
  EXPECT_THAT(json, HasSubstr(",\"Over\"]]"));
  EXPECT_THAT(taken(rb_read(context(), 0, put(kScene))), HasSubstr("\"captions\":[]"));
}

TEST(Bridge, FindsTheFlightInReadings) {
  std::vector<double> readings;
  for (int i = 0; i < 60; ++i) {
    const bool flies = i >= 20 && i < 40;
    for (const double number : {0.02 * i, 0.0, flies ? 7.0 : 0.0, 0.5, 0.0, 0.0, flies ? 0.0 : 9.8})
      readings.push_back(number);
  }
  std::int32_t count = 0;
  const double* const flight = rb_flight(context(), readings.data(), 60, &count);
  EXPECT_THAT(std::vector(flight, flight + count),
              ::testing::ElementsAre(0.02 * 21, 0.02 * 38, 0, 7, 0.5));
  rb_flight(context(), readings.data(), 25, &count);
  EXPECT_EQ(count, 0) << "too few readings fly";
}

TEST(Bridge, ReadsRecordingsThatItWasGiven) {
  constexpr std::string_view kName = "a.csv";
  constexpr std::string_view kTable =
      "t,wx (rad/s),wy (rad/s),wz (rad/s)\n0,0,0,2\n0.5,0,0,2\n1,0,0,2\n";
  constexpr std::string_view kRecorded =
      "[simulation]\nmodel = \"recorded\"\nfile = \"a.csv\"\n[clip]\nduration = 0.5\n";
  EXPECT_EQ(taken(rb_read(context(), 0, put(kRecorded))),
            "scene.toml: the model \"recorded\" has no recording: the file \"a.csv\" hasn't been "
            "read");
  giveFile(kName, kTable);
  read(0, kRecorded);
  EXPECT_GT(rb_advance(context(), 0, kAll, kAll), 20);
  EXPECT_EQ(rb_sample(context(), 0, 0, 0)[kAngularVelocity + 2], 2);
  EXPECT_EQ(taken(rb_read(context(), 0, put(with(kRecorded, "a.csv", "b.csv")))),
            "scene.toml:3:8: can't read b.csv: it isn't here");
  EXPECT_LT(rb_file(context(), 1 << 20, 1), 0);
  EXPECT_LT(rb_file(context(), 1, -1), 0);
  ASSERT_EQ(rb_file(context(), 0, 0), 0);
  EXPECT_LT(rb_read(context(), 0, put(kRecorded)), 0) << "forgotten";
}

TEST(Bridge, FindsTheStretchOfARecordingInWhichItTurns) {
  // At rest, then thrown, then caught with a knock and held.
  constexpr std::string_view kTable =
      "t,wx (rad/s),wy (rad/s),wz (rad/s)\n"
      "10,0,0,0.1\n10.5,0,0,0.2\n11,0,9,0\n11.1,0,9,1\n11.2,0,9,0\n11.3,1,9,0\n11.4,0,40,0\n"
      "11.5,0,3,0\n12,0,3,1\n";
  giveFile("toss.csv", kTable);
  EXPECT_EQ(taken(rb_recording(context(), put("toss.csv"))),
            R"({"duration":2.0,"turning":[11.0,11.4]})");
  giveFile("rest.csv", "t,wx (rad/s),wy (rad/s),wz (rad/s)\n0,0,0,1\n0.5,0,0,1\n1,0,0,1\n");
  EXPECT_EQ(taken(rb_recording(context(), put("rest.csv"))), R"({"duration":1.0,"turning":null})");
  const std::int32_t refused = rb_recording(context(), put("b.csv"));
  EXPECT_LT(refused, 0);
  EXPECT_EQ(taken(refused), "can't read b.csv: it isn't here");
  ASSERT_EQ(rb_file(context(), 0, 0), 0);
}

TEST(Bridge, StopsAfterSoManySteps) {
  readAnew(0, kScene);
  EXPECT_EQ(rb_advance(context(), 0, kFrames, 1), 2) << "at least a frame";
  EXPECT_EQ(rb_advance(context(), 0, kFrames, 640), 12) << "64 steps a frame";
  EXPECT_EQ(rb_advance(context(), 0, 3, kAll), 12) << "that is simulated already";
}

TEST(Bridge, SharesNothingBetweenContexts) {
  readAnew(0, kScene);
  rb_context* const other = rb_new(kFrames, 1 << 16);
  EXPECT_EQ(rb_buffer_size(other), 1 << 16);
  std::memcpy(rb_buffer(other), kScene.data(), kScene.size());
  ASSERT_GT(rb_read(other, 0, static_cast<std::int32_t>(kScene.size())), 0);
  EXPECT_EQ(rb_advance(other, 0, kAll, kAll), kFrames);
  EXPECT_LT(rb_advance(context(), 0, 7, kAll), kFrames) << "has its own motion";
  std::int32_t count = 0;
  EXPECT_EQ(rb_samples(context(), 0, 0, &count), nullptr) << "isn't simulated to its end";
  EXPECT_NE(rb_samples(other, 0, 0, &count), nullptr);
  EXPECT_EQ(count, kFrames);
  EXPECT_EQ(rb_samples(other, 0, 1, &count), nullptr) << "there is one motion";
  EXPECT_EQ(count, 0);
  const std::string longer = with(kScene, "2.0", "2.1");
  std::memcpy(rb_buffer(other), longer.data(), longer.size());
  EXPECT_LT(rb_read(other, 0, static_cast<std::int32_t>(longer.size())), 0) << "too many frames";
  rb_delete(other);
}

TEST(Bridge, TellsWhereTheNumbersOfASampleAre) {
  EXPECT_THAT(taken(rb_sample_layout(context())),
              AllOf(HasSubstr("\"time\":{\"offset\":0,"),
                    HasSubstr("\"size\":" + std::to_string(sizeof(physics::Sample)))));
}

TEST(Bridge, KeepsAScenePastOneThatIsRefused) {
  read(0, kScene);
  rb_advance(context(), 0, kAll, kAll);
  const std::string before = taken(rb_checksum(context(), 0));
  const std::int32_t length = rb_read(context(), 0, put("[body]\nmaas = 1\n"));
  ASSERT_LT(length, 0);
  EXPECT_EQ(taken(length).substr(0, 40), "scene.toml:2:1: unknown key \"maas\" in [b");
  EXPECT_EQ(taken(rb_checksum(context(), 0)), before);
}

TEST(Bridge, KeepsTheSamplesOfTheSameMotions) {
  const std::string lookOfIt =
      "[look]\nbackground = \"stars\"\n[overlay]\nshow = [\"axes\"]\n[book]\ncolor = \"#102030\"\n"
      "[camera]\nframe = \"body\"\nfollow = \"size\"\n[expect]\nhalf_turns = { min = 3 }\n"
      "[video]\ncrf = 30\n";
  const std::string longer = with(kScene, "A throw", "Another");
  const std::string larger = with(longer, "duration", "size = [64, 36]\nposter = 1.0\nduration");
  for (const int frames : {30, kFrames}) {
    readAnew(0, kScene);
    ASSERT_EQ(rb_advance(context(), 0, frames - 1, kAll), frames);
    for (const std::string& text : {longer, larger, std::string(kScene) + lookOfIt}) {
      read(0, text);
      EXPECT_EQ(rb_advance(context(), 0, 0, kAll), frames) << text;
      // The camera's axes are the new scene's.
      const bool isTurned = std::abs(rb_sample(context(), 0, 0, 20)[kAttitude]) < 0.9;
      EXPECT_EQ(isTurned, text.find("[camera]") == text.npos);
    }
    EXPECT_EQ(rb_advance(context(), 0, kAll, kAll), kFrames);
    EXPECT_EQ(taken(rb_checksum(context(), 0)), wholeChecksum(kScene));
    EXPECT_THAT(taken(rb_scene_text(context(), 0)), HasSubstr("background = \"stars\""));
  }
}

TEST(Bridge, KeepsNoSampleOfOtherMotions) {
  for (const auto& [part, other] : std::vector<std::pair<std::string_view, std::string_view>>{
           {"[5.0, 0.0", "[5.1, 0.0"},
           {"1 deg", "2 deg"},
           {"0.2", "0.3"},
           {"at = 0.5", "at = 1.9"},
           {"2.0", "2.5"},
           {"[clip]", "[clip]\nspeed = 0.5"},
           {"[clip]", "[clip]\nspeed = [{ from = 0.5, to = 1.5, value = 0.5 }]"},
           {"[clip]", "[clip]\nfps = 50"},
           {"[clip]", "[simulation]\nsubsteps = 32\n[clip]"},
           {"[clip]", "[simulation]\nmodel = \"exact\"\n[clip]"},
           {"[clip]", "[body]\nsize = [0.1, 0.2, 0.03]\n[clip]"},
           {"[clip]", "[body]\nmass = 2.0\n[clip]"},
           {"[clip]", "[[panel]]\nlabel = \"a\"\n[[panel]]\nlabel = \"b\"\n[clip]"},
       }) {
    const std::string text = with(kScene, part, other);
    readAnew(0, kScene);
    rb_advance(context(), 0, kAll, kAll);
    read(0, text);
    EXPECT_EQ(rb_advance(context(), 0, 0, kAll), 1) << text;
    while (rb_advance(context(), 0, kAll, kAll) < rb_frames(context(), 0)) {
    }
    EXPECT_EQ(taken(rb_checksum(context(), 0)), wholeChecksum(text)) << text;
  }
}

// A label is no part of a motion.
TEST(Bridge, KeepsThePanelsThatAreTheSame) {
  const std::string panels = std::string(kScene) +
                             "[[panel]]\nlabel = \"a\"\n[[panel]]\nlabel = \"b\"\n"
                             "[panel.simulation]\nmodel = \"exact\"\n";
  readAnew(0, panels);
  EXPECT_EQ(rb_advance(context(), 0, 40, kAll), 41);
  read(0, with(panels, "\"b\"", "\"c\""));
  EXPECT_EQ(rb_advance(context(), 0, 0, kAll), 41);
  read(0, with(panels, "\"exact\"", "\"matrix\""));
  EXPECT_EQ(rb_advance(context(), 0, 0, kAll), 1);
}

TEST(Bridge, RefusesMotionsWithoutRoom) {
  const auto message = [](int frames, int books) {
    std::string text =
        "[initial]\nangular_velocity = [5.0, 0.0, 0.1]\n[simulation]\nmodel = "
        "\"exact\"\n[clip]\nsize = [64, 36]\nfps = 100\nduration = " +
        std::to_string(frames / 100.0) + "\n";
    for (int book = 0; books > 1 && book < books; ++book) {
      text += "[[panel]]\nlabel = \"" + std::to_string(book) + "\"\n";
    }
    const std::int32_t length = rb_read(context(), 2, put(text));
    return length > 0 ? "" : taken(length);
  };
  EXPECT_EQ(message(kMaxFrames, 1), "");
  EXPECT_EQ(rb_frames(context(), 2), kMaxFrames);
  EXPECT_EQ(message(kMaxFrames + 1, 1),
            "scene.toml: the motion is too long to be played here: 72001 frames, at most 72000; "
            "rotatebook render makes its clip");
  EXPECT_EQ(rb_frames(context(), 2), kMaxFrames) << "which the slot keeps";
  EXPECT_EQ(message(kMaxFrames / 6, 6), "");
  EXPECT_EQ(message(36'000, 6),
            "scene.toml: the motion is too long to be played here: 36000 frames of each of 6 "
            "books, at most 72000 together; rotatebook render makes its clip");
}

TEST(Bridge, HasAllOfTenMinutesInEverySlot) {
  for (std::int32_t slot = 0; slot < kSlots; ++slot) {
    readAnew(slot,
             "[initial]\nangular_velocity = [5.0, 0.0, 0.1]\n[simulation]\nmodel = \"exact\"\n"
             "[clip]\nduration = 600\n");
  }
  for (std::int32_t slot = 0; slot < kSlots; ++slot)
    EXPECT_EQ(rb_advance(context(), slot, kAll, kAll), 36'000);
  for (std::int32_t slot = 0; slot < kSlots; ++slot) {
    EXPECT_EQ(rb_sample(context(), slot, 0, 35'999)[kTime], 35'999 / 60.0);
  }
}

TEST(Bridge, AnswersWhatIsntThere) {
  read(0, kScene);
  for (const std::int32_t slot : {-1, static_cast<std::int32_t>(kSlots), 1'000'000}) {
    const std::string message = "there is no slot " + std::to_string(slot);
    EXPECT_EQ(taken(rb_read(context(), slot, put(kScene))), message);
    EXPECT_EQ(taken(rb_scene_text(context(), slot)), message);
    EXPECT_LT(rb_checksum(context(), slot), 0);
    EXPECT_LT(rb_table_checksum(context(), slot), 0);
    EXPECT_EQ(rb_advance(context(), slot, 0, 1), -1);
    EXPECT_EQ(taken(rb_message(context())), message);
    EXPECT_EQ(rb_frames(context(), slot), 0);
    EXPECT_EQ(rb_sample(context(), slot, 0, 0), nullptr);
  }
  EXPECT_EQ(rb_sample(context(), 0, 1, 0), nullptr);
  EXPECT_EQ(rb_sample(context(), 0, -1, 0), nullptr);
  EXPECT_EQ(rb_sample(context(), 0, 0, -7)[kTime], 0);
  rb_advance(context(), 0, 9, kAll);
  EXPECT_EQ(rb_sample(context(), 0, 0, kAll)[kTime],
            rb_sample(context(), 0, 0, rb_advance(context(), 0, 0, 1) - 1)[kTime]);
  std::int32_t count = 7;
  EXPECT_EQ(rb_mesh_indices(context(), 5, &count), nullptr);
  EXPECT_EQ(count, 0);
  EXPECT_EQ(rb_mesh_indices(context(), -1, &count), nullptr);
}

TEST(Bridge, KeepsItsSlotsApart) {
  read(0, kScene);
  rb_advance(context(), 0, kAll, kAll);
  read(1, "[initial]\nangular_velocity = [0.0, 5.0, 0.1]\n");
  EXPECT_EQ(rb_advance(context(), 1, 3, kAll), 4);
  EXPECT_EQ(taken(rb_checksum(context(), 0)), wholeChecksum(kScene));
}

TEST(Bridge, WritesASceneThatReadsBack) {
  read(0, kScene);
  const std::string text = taken(rb_scene_text(context(), 0));
  EXPECT_EQ(wholeChecksum(text), wholeChecksum(kScene));
  EXPECT_THAT(text, HasSubstr("[[nudge]]"));
}

TEST(Bridge, GivesATextAsJson) {
  const std::int32_t length =
      rb_toml_to_json(context(), put("a = [1, 2.5, \"</script>\"]\n[b]\nc = true\n"));
  EXPECT_EQ(taken(length), R"({"a":[1,2.5,"</script>"],"b":{"c":true}})");
  EXPECT_LT(rb_toml_to_json(context(), put("a = ")), 0);
}

TEST(Bridge, WritesJsonAsASceneOfTheSameValues) {
  const std::string json =
      R"({"title":"a \"b\"\n\u0007","initial":{"angular_velocity":{"about":"middle",)"
      R"("value":1e-300},"tilt":["1 deg","z"]},"overlay":{"words":{"a b":"c"},"show":[]},)"
      R"("nudge":[{"at":1}],"panel":[{"label":"a"},{"label":"b","simulation":)"
      R"({"normalize":true}}],"clip":{"speed":[{"from":1}]}})";
  const std::string text = taken(rb_json_to_toml(context(), put(json)));
  EXPECT_EQ(text, R"(title = "a \"b\"\n\u0007"

[initial]
angular_velocity.about = "middle"
angular_velocity.value = 1e-300
tilt = ["1 deg", "z"]

[overlay]
words."a b" = "c"
show = []

[[nudge]]
at = 1

[[panel]]
label = "a"

[[panel]]
label = "b"
simulation.normalize = true

[clip]
speed = [{ "from" = 1 }]
)");
  EXPECT_EQ(taken(rb_toml_to_json(context(), put(text))), json);
  EXPECT_LT(rb_json_to_toml(context(), put("{\"a\":null}")), 0);
  EXPECT_LT(rb_json_to_toml(context(), put("{")), 0);
}

TEST(Bridge, SaysWhatKeysTakeAndWhoseMotionsTheyChange) {
  const std::string words = taken(rb_words(context()));
  EXPECT_THAT(words,
              HasSubstr(R"("simulation.substeps":{"type":"integer","unit":"","models":)"
                        R"(["particles","matrix","quaternion"],"min":1.0,"max":1000000.0})"));
  EXPECT_THAT(words, HasSubstr(R"("simulation.stiffness":{"type":"number","unit":"N/m",)"
                               R"("models":["particles"],)"));
  EXPECT_THAT(words, HasSubstr(R"("choices":["none","size"])"));
  EXPECT_THAT(words, HasSubstr(R"("springs":["particles"],)"));
  EXPECT_THAT(words, HasSubstr(R"("longestScene":32768,"maxNudges":100})"));
}

TEST(Bridge, NamesModelsWithTheirIntegrators) {
  const std::string words = taken(rb_words(context()));
  EXPECT_THAT(words, HasSubstr(R"({"name":"exact","integrators":[],"integrator":null})"));
  EXPECT_THAT(words, HasSubstr(R"("integrator":"rk4"})"));
  EXPECT_THAT(words, HasSubstr("\"splitting\""));
}

TEST(Bridge, GivesTheNumbersOfASample) {
  read(0, kScene);
  rb_advance(context(), 0, kAll, kAll);
  const auto motion = timeline::simulateScene(scene::parseScene(kScene, "scene.toml"));
  const physics::Sample& sample = motion.trajectories()[0].samples[100];
  const double* numbers = rb_sample(context(), 0, 0, 100);
  EXPECT_EQ(numbers[kTime], sample.time);
  EXPECT_EQ(numbers[kAttitude], sample.attitude.w());
  EXPECT_EQ(numbers[kAttitude + 3], sample.attitude.z());
  EXPECT_EQ(numbers[kAngularVelocity + 1], sample.angularVelocity.y());
  EXPECT_EQ(numbers[kAngularMomentum + 2], sample.angularMomentum.z());
  EXPECT_EQ(numbers[kEnergies], sample.kinetic);
  EXPECT_EQ(numbers[kTilt], sample.tiltDeg);
  EXPECT_EQ(numbers[kHalfTurns], sample.halfTurns);
  EXPECT_EQ(numbers[kError], sample.errorDeg);
  EXPECT_EQ(numbers[kHeld], 0);
  EXPECT_EQ(numbers[kCorners + 3 * 5 + 1], sample.cage(1, 5));
}

}  // namespace
}  // namespace rotatebook::bridge
