#include <algorithm>
#include <filesystem>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scene/parse.h"
#include "scene/scene_text.h"

namespace rotatebook::scene {
namespace {

using physics::InitialSpin;
using physics::Integrator;
using physics::Model;

TEST(SceneReader, NeedsOnlyASpin) {
  const Scene scene = parseScene(kSpin, "some/where/tumbling.toml");
  EXPECT_EQ(scene.name, "tumbling");
  EXPECT_EQ(scene.folder, std::filesystem::path("some/where"));
  EXPECT_EQ(scene.title, "tumbling");
  EXPECT_EQ(scene.caption, "");
  EXPECT_EQ(scene.motions[0].initial.kind, InitialSpin::Kind::AngularVelocity);
  EXPECT_EQ(scene.motions[0].initial.value, Eigen::Vector3d(0, 0, 6));
  EXPECT_FALSE(scene.motions[0].initial.tilt);
  EXPECT_TRUE(scene.motions[0].expectations.empty());
}

TEST(SceneReader, HasTheDocumentedDefaultsOfTheMotion) {
  const Scene scene = sceneFrom("");
  EXPECT_EQ(scene.motions[0].body.size, Eigen::Vector3d(0.1878, 0.29085, 0.05));
  EXPECT_EQ(scene.motions[0].body.mass, 1);
  EXPECT_EQ(scene.motions[0].simulation.model, Model::Quaternion);
  EXPECT_EQ(scene.motions[0].simulation.integrator, Integrator::Rk4);
  EXPECT_EQ(scene.motions[0].simulation.normalizeEvery, 1);
  EXPECT_EQ(scene.motions[0].simulation.damping, 1);
  EXPECT_EQ(scene.motions[0].simulation.stiffness, 2000);
  EXPECT_EQ(scene.timePerFrame(), 1.0 / 60);
  EXPECT_EQ(scene.motions[0].simulation.substeps, 64);
}

TEST(SceneReader, HasTheDocumentedDefaultsOfThePicture) {
  const Scene scene = sceneFrom("");
  EXPECT_EQ(scene.clip.width, 1280);
  EXPECT_EQ(scene.clip.height, 720);
  EXPECT_EQ(scene.clip.frameRate, (FrameRate{60, 1}));
  EXPECT_EQ(scene.clip.duration, 12);
  EXPECT_EQ(scene.video.crf, 18);
  EXPECT_EQ(scene.video.preset, "book");
  EXPECT_EQ(scene.video.threads, 1);
  EXPECT_EQ(scene.cameraPosition, defaultCameraPosition(scene.motions[0].body, 30, 1280, 720));
  EXPECT_EQ(scene.camera.target, Eigen::Vector3d::Zero());
  EXPECT_EQ(scene.camera.up, Eigen::Vector3d::UnitY());
  EXPECT_EQ(scene.camera.fieldOfViewDeg, 30);
  EXPECT_EQ(scene.book.front, "builtin");
  EXPECT_EQ(scene.book.spine, "builtin");
  EXPECT_EQ(scene.book.back, "builtin");
}

TEST(SceneReader, ReadsTitleAndCaption) {
  const Scene scene = sceneFrom("title = \"T\"\ncaption = 'C \"c\"'");
  EXPECT_EQ(scene.title, "T");
  EXPECT_EQ(scene.caption, "C \"c\"");
  EXPECT_EQ(scene.name, "a");
  EXPECT_EQ(sceneFrom("title = ''").title, "");
}

TEST(SceneReader, SimulatesInRealTimeUnlessTheSceneSaysOtherwise) {
  EXPECT_EQ(sceneFrom("[clip]\nfps = 25").motions[0].simulation.timePerFrame, 1.0 / 25);
  EXPECT_EQ(sceneFrom("[clip]\nfps = '30000/1001'").motions[0].simulation.timePerFrame,
            1001.0 / 30000);
  EXPECT_EQ(sceneFrom("simulation.time_per_frame = 0.5\nclip.fps = 25")
                .motions[0]
                .simulation.timePerFrame,
            0.5);
}

TEST(SceneReader, PlacesTheCameraByBodyAngleAndPicture) {
  const Scene scene =
      sceneFrom("camera.field_of_view_deg = 50\nbody.size = [1, 2, 3]\nclip.size = [320, 640]");
  EXPECT_EQ(scene.cameraPosition, defaultCameraPosition(scene.motions[0].body, 50, 320, 640));
  EXPECT_EQ(sceneFrom("camera.position = [1, 2, 3]").cameraPosition, Eigen::Vector3d(1, 2, 3));
}

TEST(SceneReader, NamesTheNearestSectionOrKey) {
  EXPECT_EQ(errorOf("titel = \"x\""), "a.toml:1:1: unknown key \"titel\"; did you mean \"title\"?");
  EXPECT_EQ(errorOf("\n[simulaton]\nsubsteps = 3"),
            "a.toml:2:2: unknown section \"simulaton\"; did you mean \"simulation\"?");
  EXPECT_EQ(errorOf("[body]\nsize = [1, 2, 3]\n  maas = 3"),
            "a.toml:3:3: unknown key \"maas\" in [body]; did you mean \"mass\"?");
}

TEST(SceneReader, ListsTheValidOnesWhereNoneIsNear) {
  EXPECT_EQ(
      errorOf("[sound]"),
      "a.toml:1:2: unknown section \"sound\"; valid are \"title\", \"caption\", \"body\", "
      "\"simulation\", \"initial\", \"nudge\", \"clip\", \"video\", \"cue\", \"camera\", \"book\", "
      "\"look\", "
      "\"overlay\", "
      "\"expect\", \"panel\", \"grid\", \"study\" and \"map\"");
  EXPECT_EQ(errorOf("[body]\ncolour = 3"),
            "a.toml:2:1: unknown key \"colour\" in [body]; valid are \"size\", \"mass\", "
            "\"inertia\", \"shape\", \"dimensions\", \"mesh\", \"unit\", \"density\" and \"part\"");
}

TEST(SceneReader, NamesTheSectionToWhichAKeyBelongs) {
  EXPECT_EQ(
      errorOf("angular_velocity = [1, 0, 0]"),
      "a.toml:1:1: unknown key \"angular_velocity\"; it belongs under [initial] or [[nudge]]");
  EXPECT_EQ(errorOf("[body]\ntitle = 'x'"),
            "a.toml:2:1: unknown key \"title\" in [body]; it belongs before the first [section]");
  EXPECT_EQ(errorOf("size = [1, 2, 3]"),
            "a.toml:1:1: unknown key \"size\"; it belongs under [body], [clip] or [map]");
  const std::string panel = "[[panel]]\nlabel = 'a'\nsubsteps = 3\n[[panel]]\nlabel = 'b'";
  EXPECT_EQ(errorOf(panel),
            "a.toml:3:1: unknown key \"substeps\" in [panel]; it belongs under "
            "[simulation]");
}

TEST(SceneReader, ReportsAllProblemsInTheOrderOfTheText) {
  EXPECT_EQ(errorOf("[video]\ncrf = 99\nthreads = 'x'\n[body]\nmass = 0"),
            "a.toml:2:7: video.crf must be an integer from 1 to 51, not 99\n"
            "  a.toml:3:11: video.threads must be an integer from 1 to 64, not \"x\"\n"
            "  a.toml:5:8: body.mass must be a mass from 1e-9 to 1e9 kg, not 0");
  // A table that is continued after another section, and overrides last.
  EXPECT_EQ(errorOf("body.mass = 0\nclip.fps = 0\nbody.size = 1", {"title=5", "x", "video.crf=0"}),
            "a.toml:1:13: body.mass must be a mass from 1e-9 to 1e9 kg, not 0\n"
            "  a.toml:2:12: clip.fps must be a frame rate from 1 to 1000, an integer or a fraction "
            "such as \"30000/1001\", not 0\n"
            "  a.toml:3:13: body.size must be three lengths from 1e-6 to 1e6 m, not 1\n"
            "  --set title=5: title must be a string in quotes, not 5\n"
            "  --set video.crf=0: video.crf must be an integer from 1 to 51, not 0\n"
            "  --set x: expected KEY=VALUE");
  // What is wrong across sections is found when each is right.
  EXPECT_EQ(
      errorOf("[camera]\nup = [0, 0, 1]\nposition = [0, 0, 1]\n[overlay]\nshow = ['springs']"),
      "a.toml:2:6: camera.up must not be parallel to the direction from camera.position to "
      "camera.target\n"
      "  a.toml:5:9: overlay.show: springs exist only in the particles model; this scene's is "
      "quaternion");
}

TEST(SceneReader, ReportsAProblemThatPanelsShareOnce) {
  EXPECT_EQ(errorOf("[body]\nmass = 0\n[[panel]]\nlabel = 'a'\n[[panel]]\nlabel = 3"),
            "a.toml:2:8: body.mass must be a mass from 1e-9 to 1e9 kg, not 0\n"
            "  a.toml:6:9: panel.label must be a string in quotes, not 3");
  EXPECT_EQ(errorOf("[[panel]]\nlabel = 'a'\n[[panel]]\nlabel = 'b'",
                    {"simulation.substeps=0", "body.mass=0"}),
            "--set body.mass=0: body.mass must be a mass from 1e-9 to 1e9 kg, not 0\n"
            "  --set simulation.substeps=0: simulation.substeps must be an integer from 1 to "
            "1000000, not 0");
}

TEST(SceneReader, ReportsTheFirstTwentyOfManyProblems) {
  std::string lines;
  for (int i = 0; i < 27; ++i) lines += "wrong" + std::to_string(i) + " = 1\n";
  const std::string message = errorOf(lines);
  EXPECT_THAT(message, testing::HasSubstr("\n  a.toml:20:1: unknown key \"wrong19\""));
  EXPECT_THAT(message, testing::EndsWith("\n  and 7 more"));
  EXPECT_EQ(std::ranges::count(message, '\n'), 20);
}

TEST(SceneReader, RefusesWrongTypes) {
  EXPECT_EQ(errorOf("title = 3"), "a.toml:1:9: title must be a string in quotes, not 3");
  EXPECT_EQ(errorOf("caption = true"), "a.toml:1:11: caption must be a string in quotes, not true");
  EXPECT_EQ(errorOf("body = 5"), "a.toml:1:8: body must be a section, not 5");
  EXPECT_EQ(errorOf("[[clip]]\nfps = 3"), "a.toml:1:1: clip must be a section, not [a table]");
}

TEST(SceneReader, NeedsASpin) {
  EXPECT_EQ(errorOfText("title = \"x\"\n"),
            "a.toml:1:1: [initial] is missing; it needs angular_velocity or angular_momentum");
  EXPECT_EQ(errorOfText(""),
            "a.toml:1:1: [initial] is missing; it needs angular_velocity or angular_momentum");
}

}  // namespace
}  // namespace rotatebook::scene
