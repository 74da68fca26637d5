#include "bridge/bridge.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/document/toml_json.h"
#include "geometry/camera.h"
#include "scene/scene_text.h"
#include "timeline/motion_checksum.h"
#include "timeline/scene_camera.h"
#include "timeline/simulate_scene.h"

namespace rotatebook::bridge {
namespace {

using ::testing::HasSubstr;

constexpr std::string_view kScene =
    "title = \"A throw\"\n"
    "[initial]\nangular_velocity = [5.0, 0.0, 0.0]\ntilt = [\"1 deg\", \"z\"]\n"
    "[clip]\nduration = 2.0\n"
    "[[nudge]]\nat = 0.5\nangular_velocity = [0.0, 0.2, 0.0]\n";
constexpr int kFrames = 120;
constexpr std::int32_t kAll = 1'000'000'000;

std::int32_t put(std::string_view text) {
  std::memcpy(rb_buffer(), text.data(), text.size());
  return static_cast<std::int32_t>(text.size());
}

std::string taken(std::int32_t length) {
  return {rb_buffer(), static_cast<std::size_t>(std::abs(length))};
}

void read(std::int32_t slot, std::string_view text) {
  const std::int32_t length = rb_read(slot, put(text));
  ASSERT_GT(length, 0) << taken(length);
}

/// Reads a scene into a slot that holds other motions.
void readAnew(std::int32_t slot, std::string_view text) {
  read(slot, "[initial]\nangular_velocity = [0.0, 0.0, 1.0]\n[clip]\nduration = 0.1\n");
  read(slot, text);
}

std::string with(std::string_view text, std::string_view part, std::string_view other) {
  std::string changed(text);
  return changed.replace(changed.find(part), part.size(), other);
}

std::string wholeChecksum(std::string_view text) {
  return timeline::motionChecksum(timeline::simulateScene(scene::parseScene(text, "scene.toml")));
}

TEST(Bridge, HasTheMotionOfTheProgramInSlices) {
  readAnew(0, kScene);
  for (int frame = 0; rb_advance(0, frame, kAll) < kFrames; frame += 7) {
    EXPECT_LT(rb_checksum(0), 0) << "before the end";
  }
  EXPECT_EQ(taken(rb_checksum(0)), wholeChecksum(kScene));
  // Another nudge is another motion.
  EXPECT_NE(taken(rb_checksum(0)), wholeChecksum(with(kScene, "0.2", "0.3")));
}

void giveFile(std::string_view name, std::string_view bytes) {
  put(std::string(name) + std::string(bytes));
  ASSERT_EQ(
      rb_file(static_cast<std::int32_t>(name.size()), static_cast<std::int32_t>(bytes.size())), 0);
}

TEST(Bridge, ReadsRecordingsThatItWasGiven) {
  constexpr std::string_view kName = "a.csv";
  constexpr std::string_view kTable =
      "t,wx (rad/s),wy (rad/s),wz (rad/s)\n0,0,0,2\n0.5,0,0,2\n1,0,0,2\n";
  constexpr std::string_view kRecorded =
      "[simulation]\nmodel = \"recorded\"\nfile = \"a.csv\"\n[clip]\nduration = 0.5\n";
  EXPECT_EQ(taken(rb_read(0, put(kRecorded))),
            "scene.toml: the model \"recorded\" has no recording: the file \"a.csv\" hasn't been "
            "read");
  giveFile(kName, kTable);
  read(0, kRecorded);
  EXPECT_GT(rb_advance(0, kAll, kAll), 20);
  EXPECT_EQ(rb_sample(0, 0, 0)[kAngularVelocity + 2], 2);
  EXPECT_EQ(taken(rb_read(0, put(with(kRecorded, "a.csv", "b.csv")))),
            "scene.toml:3:8: can't read b.csv: it isn't here");
  EXPECT_LT(rb_file(1 << 20, 1), 0);
  EXPECT_LT(rb_file(1, -1), 0);
  ASSERT_EQ(rb_file(0, 0), 0);
  EXPECT_LT(rb_read(0, put(kRecorded)), 0) << "forgotten";
}

TEST(Bridge, StopsAfterSoManySteps) {
  readAnew(0, kScene);
  EXPECT_EQ(rb_advance(0, kFrames, 1), 2) << "at least a frame";
  EXPECT_EQ(rb_advance(0, kFrames, 640), 12) << "64 steps a frame";
  EXPECT_EQ(rb_advance(0, 3, kAll), 12) << "that is simulated already";
}

TEST(Bridge, KeepsAScenePastOneThatIsRefused) {
  read(0, kScene);
  rb_advance(0, kAll, kAll);
  const std::string before = taken(rb_checksum(0));
  const std::int32_t length = rb_read(0, put("[body]\nmaas = 1\n"));
  ASSERT_LT(length, 0);
  EXPECT_EQ(taken(length).substr(0, 40), "scene.toml:2:1: unknown key \"maas\" in [b");
  EXPECT_EQ(taken(rb_checksum(0)), before);
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
    ASSERT_EQ(rb_advance(0, frames - 1, kAll), frames);
    for (const std::string& text : {longer, larger, std::string(kScene) + lookOfIt}) {
      read(0, text);
      EXPECT_EQ(rb_advance(0, 0, kAll), frames) << text;
      // The camera's axes are the new scene's.
      const bool isTurned = std::abs(rb_sample(0, 0, 20)[kAttitude]) < 0.9;
      EXPECT_EQ(isTurned, text.find("[camera]") == text.npos);
    }
    EXPECT_EQ(rb_advance(0, kAll, kAll), kFrames);
    EXPECT_EQ(taken(rb_checksum(0)), wholeChecksum(kScene));
    EXPECT_THAT(taken(rb_scene_text(0)), HasSubstr("background = \"stars\""));
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
    rb_advance(0, kAll, kAll);
    read(0, text);
    EXPECT_EQ(rb_advance(0, 0, kAll), 1) << text;
    while (rb_advance(0, kAll, kAll) < rb_frames(0)) {
    }
    EXPECT_EQ(taken(rb_checksum(0)), wholeChecksum(text)) << text;
  }
}

// A label is no part of a motion.
TEST(Bridge, KeepsThePanelsThatAreTheSame) {
  const std::string panels = std::string(kScene) +
                             "[[panel]]\nlabel = \"a\"\n[[panel]]\nlabel = \"b\"\n"
                             "[panel.simulation]\nmodel = \"exact\"\n";
  readAnew(0, panels);
  EXPECT_EQ(rb_advance(0, 40, kAll), 41);
  read(0, with(panels, "\"b\"", "\"c\""));
  EXPECT_EQ(rb_advance(0, 0, kAll), 41);
  read(0, with(panels, "\"exact\"", "\"matrix\""));
  EXPECT_EQ(rb_advance(0, 0, kAll), 1);
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
    const std::int32_t length = rb_read(2, put(text));
    return length > 0 ? "" : taken(length);
  };
  EXPECT_EQ(message(kMaxFrames, 1), "");
  EXPECT_EQ(rb_frames(2), kMaxFrames);
  EXPECT_EQ(message(kMaxFrames + 1, 1),
            "scene.toml: the motion is too long to be played here: 72001 frames, at most 72000; "
            "rotatebook render makes its clip");
  EXPECT_EQ(rb_frames(2), kMaxFrames) << "which the slot keeps";
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
    EXPECT_EQ(rb_advance(slot, kAll, kAll), 36'000);
  for (std::int32_t slot = 0; slot < kSlots; ++slot) {
    EXPECT_EQ(rb_sample(slot, 0, 35'999)[kTime], 35'999 / 60.0);
  }
}

TEST(Bridge, AnswersWhatIsntThere) {
  read(0, kScene);
  for (const std::int32_t slot : {-1, static_cast<std::int32_t>(kSlots), 1'000'000}) {
    const std::string message = "there is no slot " + std::to_string(slot);
    EXPECT_EQ(taken(rb_read(slot, put(kScene))), message);
    EXPECT_EQ(taken(rb_scene_text(slot)), message);
    EXPECT_LT(rb_checksum(slot), 0);
    EXPECT_LT(rb_table_checksum(slot), 0);
    EXPECT_EQ(rb_advance(slot, 0, 1), -1);
    EXPECT_EQ(taken(rb_message()), message);
    EXPECT_EQ(rb_frames(slot), 0);
    EXPECT_EQ(rb_sample(slot, 0, 0), nullptr);
  }
  EXPECT_EQ(rb_sample(0, 1, 0), nullptr);
  EXPECT_EQ(rb_sample(0, -1, 0), nullptr);
  EXPECT_EQ(rb_sample(0, 0, -7)[kTime], 0);
  rb_advance(0, 9, kAll);
  EXPECT_EQ(rb_sample(0, 0, kAll)[kTime], rb_sample(0, 0, rb_advance(0, 0, 1) - 1)[kTime]);
  std::int32_t count = 7;
  EXPECT_EQ(rb_mesh_indices(5, &count), nullptr);
  EXPECT_EQ(count, 0);
  EXPECT_EQ(rb_mesh_indices(-1, &count), nullptr);
}

TEST(Bridge, HasNoCameraOfWhatIsntThere) {
  readAnew(0, std::string(kScene) + "[camera]\nfollow = \"size\"\n");
  rb_advance(0, kAll, kAll);
  const std::array<double, 2> straight{0, 0};
  std::array<float, 16> matrix{};
  std::array<float, 3> eye{};
  const auto camera = [&](std::int32_t slot, std::int32_t motion, std::int32_t frame, float width) {
    return rb_camera(slot, motion, frame, width, 90, straight.data(), 1, matrix.data(), eye.data());
  };
  EXPECT_EQ(camera(-1, 0, 0, 160), 0);
  EXPECT_EQ(camera(0, 1, 0, 160), 0);
  EXPECT_EQ(camera(0, -1, 0, 160), 0);
  EXPECT_EQ(eye[2], 0) << "nothing is written";
  for (const std::int32_t frame : {-5, kFrames, 1'000'000'000}) {
    EXPECT_EQ(camera(0, 0, frame, 160), 1);
    EXPECT_GT(eye[2], 0);
  }
  for (const float width : {0.0f, -1e30f, 1e30f, std::nanf("")}) {
    EXPECT_EQ(camera(0, 0, 0, width), 1) << width;
  }
}

TEST(Bridge, KeepsItsSlotsApart) {
  read(0, kScene);
  rb_advance(0, kAll, kAll);
  read(1, "[initial]\nangular_velocity = [0.0, 5.0, 0.1]\n");
  EXPECT_EQ(rb_advance(1, 3, kAll), 4);
  EXPECT_EQ(taken(rb_checksum(0)), wholeChecksum(kScene));
}

TEST(Bridge, WritesASceneThatReadsBack) {
  read(0, kScene);
  const std::string text = taken(rb_scene_text(0));
  EXPECT_EQ(wholeChecksum(text), wholeChecksum(kScene));
  EXPECT_THAT(text, HasSubstr("[[nudge]]"));
}

TEST(Bridge, GivesATextAsJson) {
  const std::int32_t length = rb_toml_to_json(put("a = [1, 2.5, \"</script>\"]\n[b]\nc = true\n"));
  EXPECT_EQ(taken(length), R"({"a": [1, 2.5, "\u003C/script>"], "b": {"c": true}})");
  EXPECT_LT(rb_toml_to_json(put("a = ")), 0);
}

TEST(Bridge, WritesJsonAsASceneOfTheSameValues) {
  const std::string json =
      R"({"title": "a \"b\"\n\u0007", "initial": {"angular_velocity": {"about": "middle", )"
      R"("value": 1e-300}, "tilt": ["1 deg", "z"]}, "overlay": {"words": {"a b": "c"}, "show": []}, )"
      R"("nudge": [{"at": 1}], "panel": [{"label": "a"}, {"label": "b", "simulation": )"
      R"({"normalize": true}}], "clip": {"speed": [{"from": 1}]}})";
  const std::string text = taken(rb_json_to_toml(put(json)));
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
  EXPECT_EQ(taken(rb_toml_to_json(put(text))), json);
  EXPECT_LT(rb_json_to_toml(put("{\"a\": null}")), 0);
  EXPECT_LT(rb_json_to_toml(put("{")), 0);
}

TEST(Bridge, SaysWhatKeysTakeAndWhoseMotionsTheyChange) {
  const std::string words = taken(rb_words());
  EXPECT_THAT(words,
              HasSubstr(R"("simulation.substeps": {"type": "integer", "unit": "", "models": )"
                        R"(["particles", "matrix", "quaternion"], "min": 1, "max": 1e+06})"));
  EXPECT_THAT(words, HasSubstr(R"("simulation.stiffness": {"type": "number", "unit": "N/m", )"
                               R"("models": ["particles"], )"));
  EXPECT_THAT(words, HasSubstr(R"("choices": ["none", "size"])"));
  EXPECT_THAT(words, HasSubstr(R"("longestScene": 32768, "maxNudges": 100})"));
}

TEST(Bridge, NamesModelsWithTheirIntegrators) {
  const std::string words = taken(rb_words());
  EXPECT_THAT(words, HasSubstr(R"({"name": "exact", "integrators": [], "integrator": null})"));
  EXPECT_THAT(words, HasSubstr(R"("integrator": "rk4"})"));
  EXPECT_THAT(words, HasSubstr("\"splitting\""));
}

TEST(Bridge, GivesTheNumbersOfASample) {
  read(0, kScene);
  rb_advance(0, kAll, kAll);
  const auto motion = timeline::simulateScene(scene::parseScene(kScene, "scene.toml"));
  const physics::Sample& sample = motion.trajectories()[0].samples[100];
  const double* numbers = rb_sample(0, 0, 100);
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

// Where the program's picture of a corner is, but with y up.
TEST(Bridge, HasTheProgramsCamera) {
  read(0, kScene);
  const std::array<double, 2> straight{0, 0}, turned{0.3, 0};
  std::array<float, 16> matrix{};
  std::array<float, 3> eye{};
  rb_camera(0, 0, 0, 1280, 720, straight.data(), 1, matrix.data(), eye.data());
  const scene::Scene scene = scene::parseScene(kScene, "scene.toml");
  const geometry::Screen screen{1280, 720, 0};
  const physics::Cage cage = scene.motions[0].body.corners();
  const auto projection = geometry::project(timeline::cameraOf(scene, screen), cage, screen);
  constexpr double kBound = 1e-6;  // measured 6e-8
  const auto difference = [&] {
    const Eigen::Matrix4d clipFromWorld = Eigen::Map<Eigen::Matrix4f>(matrix.data()).cast<double>();
    const Eigen::Vector4d here = clipFromWorld * cage.col(6).homogeneous();
    const Eigen::Vector4d there = projection.clipFromWorld * cage.col(6).homogeneous();
    return (Eigen::Vector2d(here.x(), -here.y()) / here.w() - there.head<2>() / there.w()).norm();
  };
  EXPECT_LT(difference(), kBound);
  EXPECT_NEAR(eye[2], scene.cameraPosition.z(), kBound);
  rb_camera(0, 0, 0, 1280, 720, turned.data(), 1, matrix.data(), eye.data());
  EXPECT_GT(difference(), 0.01) << "of a camera that is turned";
}

TEST(Bridge, HasTheBooksMesh) {
  std::int32_t count = 0;
  const float* vertices = rb_mesh_vertices(&count);
  EXPECT_GT(count, 1000);
  for (std::int32_t i = 0; i < count; ++i) {
    EXPECT_GE(vertices[10 * i], 0) << "position in the unit cube";
    EXPECT_LE(vertices[10 * i], 1);
    EXPECT_GE(vertices[10 * i + 9], 1) << "number of a surface";
  }
  for (std::int32_t part = 0; part < 5; ++part) {
    std::int32_t indexCount = 0;
    const std::uint16_t* indices = rb_mesh_indices(part, &indexCount);
    EXPECT_GT(indexCount, 0);
    EXPECT_EQ(indexCount % 3, 0);
    for (std::int32_t i = 0; i < indexCount; ++i) EXPECT_LT(indices[i], count);
  }
}

TEST(Bridge, HasTheMeshesOfOtherBodies) {
  read(0, kScene);
  EXPECT_EQ(taken(rb_body(0, 0)), "null") << "the book";
  EXPECT_LT(rb_body(0, 1), 0) << "no such motion";
  read(0, "[body]\nshape = \"t-handle\"\n[initial]\nangular_velocity = [4, 0, 0]\n");
  const std::string json = taken(rb_body(0, 0));
  EXPECT_THAT(json, HasSubstr("\"parts\": [{\"first\": 0, "));
  const std::size_t vertices = std::stoul(json.substr(json.find(':') + 1));
  EXPECT_GT(vertices, 1000U);
  for (std::size_t i = 0; i < vertices; ++i) {
    EXPECT_GE(rb_body_vertices()[10 * i], -1e-6) << "position in the unit cube";
    EXPECT_LE(rb_body_vertices()[10 * i], 1 + 1e-6);
  }
  for (std::size_t i = 0; i < 300; ++i) EXPECT_LT(rb_body_indices()[i], vertices);
}

TEST(Bridge, ReadsMeshesThatItWasGiven) {
  constexpr std::string_view kName = "a.obj";
  constexpr std::string_view kTetrahedron =
      "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 2\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
  constexpr std::string_view kBody =
      "[body]\nmesh = \"a.obj\"\ndensity = 1\n[initial]\nangular_velocity = [4, 0, 0]\n";
  EXPECT_LT(rb_read(0, put(kBody)), 0);
  giveFile(kName, kTetrahedron);
  read(0, kBody);
  EXPECT_THAT(taken(rb_body(0, 0)), HasSubstr("\"vertices\": 12, \"indices\": 12"));
  // Of a record, which has the numbers alone, a box is drawn
  const std::string record = taken(rb_scene_text(0));
  ASSERT_EQ(rb_file(0, 0), 0);
  read(0, record);
  EXPECT_THAT(taken(rb_body(0, 0)), HasSubstr("\"indices\": 48"));
}

}  // namespace
}  // namespace rotatebook::bridge
