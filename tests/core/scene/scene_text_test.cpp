#include "scene/scene_text.h"

#include <limits>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scene/parse.h"

namespace rotatebook::scene {
namespace {

using physics::InitialSpin;
using physics::Model;
using ::testing::HasSubstr;
using ::testing::Not;

/// A scene whose every value differs from its default and is hard to print.
Scene unusualScene() {
  Scene scene;
  scene.name = "unusual";
  scene.folder = "some/where";
  scene.title = "\"Quoted\" \\ and\nbroken é \t";
  scene.caption = "# no comment";
  scene.body = {{0.1, 1.0 / 3, 2e-5}, 7};
  scene.simulation = {Model::Particles, physics::Integrator::Euler, false, 0.3, 1e15, 0.1 / 3, 992};
  scene.initial = {InitialSpin::Kind::AngularMomentum, {-0.0, 1e-20, 0.7}, physics::Tilt{0.1, 1}};
  scene.clip = {640, 362, {30000, 1001}, 2.0 / 3, 0.2};
  scene.video = {7, "slow", 3};
  scene.camera = {{1.0 / 7, -2, 3}, {0.25, 0, 0}, {0, 0, 1}, 44.4, physics::ReferenceFrame::Body};
  scene.book = {"f \"1\".png", "s.png", "../b.png"};
  scene.look = {Background::Stars, 2, 8};
  scene.overlay = {{Overlay::Clock, Overlay::Caption}, "Some \"font\""};
  scene.expectations = {
      {Quantity::Stretch, 0.5, 1.0 / 3 + 1, 1.1, 0.9, 0.1, 2},
      {Quantity::DivergesAt, {}, {}, {}, 12, 0, std::numeric_limits<double>::infinity()},
      {Quantity::Stretch, {}, {}, 3, {}, 2, std::numeric_limits<double>::infinity()},
  };
  return scene;
}

void expectSameMotion(const Scene& a, const Scene& b) {
  EXPECT_EQ(a.body.size, b.body.size);
  EXPECT_EQ(a.body.mass, b.body.mass);
  EXPECT_EQ(a.simulation.model, b.simulation.model);
  EXPECT_EQ(a.simulation.integrator, b.simulation.integrator);
  EXPECT_EQ(a.simulation.normalize, b.simulation.normalize);
  EXPECT_EQ(a.simulation.damping, b.simulation.damping);
  EXPECT_EQ(a.simulation.stiffness, b.simulation.stiffness);
  EXPECT_EQ(a.simulation.timePerFrame, b.simulation.timePerFrame);
  EXPECT_EQ(a.simulation.substeps, b.simulation.substeps);
  EXPECT_EQ(a.initial.kind, b.initial.kind);
  EXPECT_EQ(a.initial.value, b.initial.value);
  EXPECT_EQ(a.initial.tilt, b.initial.tilt);
}

void expectSamePicture(const Scene& a, const Scene& b) {
  EXPECT_EQ(a.clip.width, b.clip.width);
  EXPECT_EQ(a.clip.height, b.clip.height);
  EXPECT_EQ(a.clip.frameRate, b.clip.frameRate);
  EXPECT_EQ(a.clip.duration, b.clip.duration);
  EXPECT_EQ(a.clip.poster, b.clip.poster);
  EXPECT_EQ(a.video.crf, b.video.crf);
  EXPECT_EQ(a.video.preset, b.video.preset);
  EXPECT_EQ(a.video.threads, b.video.threads);
  EXPECT_EQ(a.camera.position, b.camera.position);
  EXPECT_EQ(a.camera.target, b.camera.target);
  EXPECT_EQ(a.camera.up, b.camera.up);
  EXPECT_EQ(a.camera.fieldOfViewDeg, b.camera.fieldOfViewDeg);
  EXPECT_EQ(a.camera.frame, b.camera.frame);
  EXPECT_EQ(a.look.background, b.look.background);
  EXPECT_EQ(a.look.supersample, b.look.supersample);
  EXPECT_EQ(a.look.motionBlur, b.look.motionBlur);
  EXPECT_EQ(a.overlay.show, b.overlay.show);
  EXPECT_EQ(a.overlay.font, b.overlay.font);
  EXPECT_EQ(a.book.front, b.book.front);
  EXPECT_EQ(a.book.spine, b.book.spine);
  EXPECT_EQ(a.book.back, b.book.back);
}

void expectSame(const Scene& a, const Scene& b) {
  EXPECT_EQ(a.name, b.name);
  EXPECT_EQ(a.folder, b.folder);
  EXPECT_EQ(a.title, b.title);
  EXPECT_EQ(a.caption, b.caption);
  expectSameMotion(a, b);
  expectSamePicture(a, b);
}

TEST(SceneText, ReadsBackToTheSameScene) {
  const Scene scene = unusualScene();
  const std::string text = sceneText(scene);
  const Scene back = parseScene(text, "some/where/unusual.toml");
  SCOPED_TRACE(text);
  expectSame(scene, back);
  EXPECT_TRUE(std::signbit(back.initial.value.x()));
  // A table has each key once, so that bounds on the same quantity come together.
  ASSERT_EQ(back.expectations.size(), 3u);
  EXPECT_EQ(back.expectations[0], scene.expectations[0]);
  EXPECT_EQ(back.expectations[1], scene.expectations[2]);
  EXPECT_EQ(back.expectations[2], scene.expectations[1]);
}

TEST(SceneText, ReadsBackToTheSameInertia) {
  for (const std::string inertia :
       {"[3.0, 4.0, 5.1]", "[[3, 0.1, 0.2], [0.1, 4, 0.3], [0.2, 0.3, 5]]"}) {
    const Scene scene = sceneFrom("body.inertia = " + inertia);
    EXPECT_EQ(parseScene(sceneText(scene), "a.toml").inertia, scene.inertia) << sceneText(scene);
  }
}

TEST(SceneText, HasNoIntegratorWhereNothingIsStepped) {
  const std::string text = sceneText(sceneFrom("simulation.model = 'exact'"));
  EXPECT_EQ(text.find("integrator ="), std::string::npos) << text;
  EXPECT_EQ(sceneText(parseScene(text, "a.toml")), text);
}

TEST(SceneText, IsItsOwnText) {
  const std::string text = sceneText(parseScene(sceneText(unusualScene()), "a.toml"));
  EXPECT_EQ(sceneText(parseScene(text, "a.toml")), text);
}

TEST(SceneText, HasEveryDefault) {
  const Scene scene = sceneFrom("camera.position = [0, 0, 1]\nexpect.half_turns.min = 3");
  EXPECT_EQ(sceneText(scene), R"(title = "a"
caption = ""

[body]
size = [0.1878, 0.29085, 0.05]  # m, along x (from the spine), y (to the top), z (to the cover)
mass = 1.0  # kg

[simulation]
model = "quaternion"  # "particles", "matrix", "quaternion" or "exact"
integrator = "rk4"  # "euler", "rk4", "lie-euler", "cf4", "splitting", "suzuki4", "midpoint", "dmv2", "dmv4", "dmv6", "no-gyroscopic", "explicit-gyroscopic", "implicit-gyroscopic" or "renormalised"
normalize = true  # undo the integrator's drift after each step
damping = 1.0  # particles: fraction of critical damping
stiffness = 2000.0  # particles: N/m, of each spring
substeps = 64  # integration steps for each frame
time_per_frame = 0.016666666666666666  # s simulated for each frame of video

[initial]
angular_velocity = [0.0, 0.0, 6.0]  # rad/s

[clip]
size = [1280, 720]  # pixels, width and height, even
fps = 60  # frames a second
duration = 12.0  # s of video

[video]
crf = 18  # 1 to 51, smaller is better and takes more space
preset = "book"  # "book" or x264's "ultrafast" to "placebo"
threads = 1  # of the encoder; another number gives other bytes

[camera]
position = [0.0, 0.0, 1.0]  # m
target = [0.0, 0.0, 0.0]  # m, the point in the middle of the picture
up = [0.0, 1.0, 0.0]
field_of_view_deg = 30.0  # degrees, from bottom to top
frame = "world"  # "world", "body" or "momentum"

[book]
front = "builtin"  # "builtin" or a picture's path from the scene's folder
spine = "builtin"
back = "builtin"

[look]
background = "studio"  # "studio", "stars" or "transparent"
supersample = 1  # 1, or 2 to draw with twice as many pixels across and down
motion_blur = 1  # moments averaged in a picture: 1, 2, 4, 8 or 16

[overlay]
show = []  # of "caption", "clock", "axes", "omega", "momentum", "trail", "polhode", "energy", "error", "half_turns", "springs" and "ghost"
font = "builtin"  # "builtin" or an installed family

[expect]
half_turns = { min = 3.0, from = 0.0 }
)");
}

TEST(SceneText, NamesNoPlaceOfTheMachine) {
  Scene scene = unusualScene();
  scene.folder = "/home/somebody";
  EXPECT_THAT(sceneText(scene), Not(HasSubstr("somebody")));
}

TEST(SceneText, ReadsBackWhateverTheModelAndTheSpin) {
  Scene scene = unusualScene();
  for (const Model model : {Model::Particles, Model::Matrix, Model::Quaternion}) {
    scene.simulation.model = model;
    scene.initial.kind = InitialSpin::Kind::AngularVelocity;
    scene.initial.tilt.reset();
    expectSame(scene, parseScene(sceneText(scene), "some/where/unusual.toml"));
  }
}

}  // namespace
}  // namespace rotatebook::scene
