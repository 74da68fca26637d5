#include "scene/scene_text.h"

#include <cmath>
#include <cstddef>
#include <filesystem>
#include <limits>
#include <string>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scene/parse.h"
#include "scene/shipped_scene.h"

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
  scene.title = "\"Quoted\" \\ é";
  scene.caption = "# no comment\nbut broken \t";
  scene.motions[0].body = {{0.1, 1.0 / 3, 2e-5}, 7};
  scene.motions[0].simulation = {
      Model::Particles, physics::Integrator::Euler, 50, 1, 0, 0.3, 1e15, 0.1 / 3, 992};
  scene.motions[0].initial = {
      InitialSpin::Kind::AngularMomentum, {-0.0, 1e-20, 0.7}, physics::Tilt{0.1, 1}};
  scene.clip = {640, 362, {30000, 1001}, 2.0 / 3, 0.2};
  scene.video = {7, "slow", 3};
  scene.cameraPosition = {1.0 / 7, -2, 3};
  scene.camera = {scene.cameraPosition, {0.25, 0, 0}, {0, 0, 1}, 44.4, ReferenceFrame::Body};
  scene.book = {"f \"1\".png", "s.png", "../b.png", Rgb{1, 0xab, 255}};
  scene.look = {Background::Plain, 2, 8, {0x2b, 0, 9}};
  scene.overlay = {{Overlay::Clock, Overlay::Caption}, "Some \"font\"", 1.5, germanWords()};
  scene.motions[0].expectations = {
      {Measure::Stretch, 0.5, 1.0 / 3 + 1, 1.1, 0.9, 0.1, 2},
      {Measure::DivergesAt, {}, {}, {}, 12, 0, std::numeric_limits<double>::infinity()},
      {Measure::Stretch, {}, {}, 3, {}, 2, std::numeric_limits<double>::infinity()},
  };
  scene.motion = scene.motions[0];
  return scene;
}

Scene readBack(const std::string& text) {
  return parseScene(text, "some/where/unusual.toml");
}

TEST(SceneText, ReadsBackToTheSameScene) {
  Scene scene = unusualScene();
  const std::string text = sceneText(scene);
  const Scene back = readBack(text);
  // A table has each key once, so that bounds on the same quantity come together.
  for (Motion* motion : {&scene.motion, static_cast<Motion*>(scene.motions.data())})
    std::swap(motion->expectations[1], motion->expectations[2]);
  EXPECT_TRUE(back == scene) << text;
  EXPECT_TRUE(std::signbit(back.motions[0].initial.value.x()));
}

TEST(SceneText, DistinguishesScenes) {
  const Scene scene = unusualScene();
  EXPECT_TRUE(readBack(sceneText(scene)) != scene);  // in the order of the expectations alone
  Scene other = scene;
  other.motions[0].initial.value.z() = std::nextafter(other.motions[0].initial.value.z(), 1);
  EXPECT_TRUE(other != scene);
  other = scene;
  other.motions[0].inertia = Eigen::Matrix3d::Identity();
  EXPECT_TRUE(other != scene);
}

TEST(SceneText, ReadsBackToTheSameInertia) {
  for (const std::string inertia :
       {"[3.0, 4.0, 5.1]", "[[3, 0.1, 0.2], [0.1, 4, 0.3], [0.2, 0.3, 5]]"}) {
    const Scene scene = sceneFrom("body.inertia = " + inertia);
    EXPECT_EQ(parseScene(sceneText(scene), "a.toml").motions[0].inertia, scene.motions[0].inertia)
        << sceneText(scene);
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
model = "quaternion"  # "particles", "matrix", "quaternion", "exact" or "recorded"
integrator = "rk4"  # )" + listOfIntegrators("or", Model::Quaternion) +
                                  R"(
normalize = true  # undo the integrator's drift after each step, or after each n-th
damping = 1.0  # particles: fraction of critical damping
stiffness = 2000.0  # particles: N/m, of each spring
dissipation = 0.0  # matrix and quaternion: kg m^2 s, of a damper inside
particles = "corners"  # particles: where they are
substeps = 64  # integration steps in 1/60 s of motion, or in time_per_frame if it is stated

[initial]
angular_velocity = [0.0, 0.0, 6.0]  # rad/s

[clip]
size = [1280, 720]  # pixels, width and height, even
fps = 60  # frames a second
duration = 12.0  # s of video
speed = 1.0  # of the motion in the video; 0.25 is slow motion

[video]
crf = 18  # 1 to 51, smaller is better and takes more space
preset = "book"  # "book" or x264's "ultrafast" to "placebo"
threads = 1  # encoder threads; another number gives other bytes

[camera]
position = [0.0, 0.0, 1.0]  # m
target = [0.0, 0.0, 0.0]  # m, the point in the middle of the picture
up = [0.0, 1.0, 0.0]
field_of_view_deg = 30.0  # degrees, from bottom to top
frame = "world"  # "world", "body", "momentum" or "turning"
follow = "none"  # "none" or "size"
fit = "all"  # "all" or "each"

[book]
front = "builtin"  # "builtin" or a path relative to the scene's folder
spine = "builtin"
back = "builtin"

[look]
background = "studio"  # "studio", "stars", "transparent", "white", "black" or a colour such as "#2b5d8a"
supersample = 1  # 1, or 2 to draw with twice as many pixels across and down
motion_blur = 1  # moments averaged in a picture: 1, 2, 4, 8 or 16
body = true

[overlay]
show = []  # of )" + listOfOverlays("and") +
                                  R"(
font = "builtin"  # "builtin" or an installed family
scale = 1.0
words = "english"  # "english", "german", a table or the file of one
band = true

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
  scene.motions[0].expectations.clear();
  for (const Model model : {Model::Particles, Model::Matrix, Model::Quaternion}) {
    scene.motions[0].simulation.model = model;
    scene.motions[0].initial.kind = InitialSpin::Kind::AngularVelocity;
    scene.motions[0].initial.tilt.reset();
    scene.motion = scene.motions[0];
    EXPECT_TRUE(readBack(sceneText(scene)) == scene) << sceneText(scene);
  }
}

// A default that depends on what an axis varies isn't stated in its place.
TEST(SceneText, ReadsBackToTheSameCellsAndRuns) {
  const std::string models =
      "{ key = 'simulation.model', values = ['matrix', 'particles', 'exact'] }";
  const std::string shapes = "{ key = 'body.shape', values = ['book', 'racket'] }";
  for (const std::string& lines : std::vector<std::string>{
           "[grid]\ncolumns = " + models, "[grid]\nrows = " + shapes,
           "[body]\nmass = 3\n[grid]\nrows = " + shapes,
           "[simulation]\nintegrator = 'rk4'\n[grid]\nrows = { key = 'simulation.model', values = "
           "['matrix', 'particles'] }",
           "[study]\nmeasure = ['tilt_deg']\nx = " + models,
           "[study]\nmeasure = ['tilt_deg']\nx = { key = 'simulation.substeps', values = [64, 128] "
           "}\n"
           "curves = " +
               shapes}) {
    const Scene scene = sceneFrom(lines);
    const Scene back = parseScene(sceneText(scene), "a.toml");
    EXPECT_EQ(back.motions, scene.motions) << lines;
    EXPECT_EQ(back.runs, scene.runs) << lines;
    EXPECT_EQ(sceneText(back), sceneText(scene));
  }
}

TEST(BriefText, IsWhatOneWouldWrite) {
  const std::string text =
      "title = \"Small & <small>\"\n"
      "\n[simulation]\nmodel = \"exact\"\n"
      "\n[initial]\nangular_velocity = [5.0, 3.0, 1.0]\n"
      "\n[clip]\nsize = [64, 36]\nfps = 24\nduration = 0.5\n"
      "\n[expect]\nhalf_turns = { max = 0.0, from = 0.0 }\n";
  EXPECT_EQ(briefText(parseScene(text, "small.toml")), text);
}

TEST(BriefText, OfAllShippedScenesHasNoCommentAndReadsBackEqual) {
  const std::filesystem::path scenes = ROTATEBOOK_SOURCE "/scenes";
  std::size_t size = 0, whole = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(scenes)) {
    if (entry.path().extension() != ".toml") continue;
    const Scene scene =
        shippedScene(entry.path().lexically_relative(scenes).replace_extension().string());
    const std::string text = briefText(scene);
    EXPECT_THAT(text, Not(HasSubstr("  # "))) << entry.path();
    size += text.size();
    whole += sceneText(scene).size();
    EXPECT_EQ(sceneText(parseScene(text, scene.name + ".toml")), sceneText(scene));
  }
  // Measured 0.34.
  EXPECT_LT(10 * size, 4 * whole) << size << " of " << whole << " bytes";
}

TEST(BriefText, IsTheWholeTextIfWordsLookLikeAComment) {
  const Scene scene =
      parseScene("title = \"A  # B\"\n[initial]\nangular_velocity = [5, 3, 1]\n", "small.toml");
  EXPECT_EQ(briefText(scene), sceneText(scene));
}

}  // namespace
}  // namespace rotatebook::scene
