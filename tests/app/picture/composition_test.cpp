// Pictures of a comparison clip around its books, over plain grey. image/golden.h says how the
// golden is renewed.
#include "picture/composition.h"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "image/golden.h"
#include "picture/looks.h"
#include "picture/preflight.h"
#include "scene/scene_text.h"
#include "timeline/scene_camera.h"
#include "timeline/simulate_scene.h"

namespace rotatebook::picture {
namespace {

// Letters of other versions of the libraries differ in their edges.
constexpr image::Tolerance kOtherLibraries{.largest = 24, .failPercent = 0.025};
// Four panels, the first of which has diverged at 0.21 s; its notice is there, the others go on.
constexpr std::int64_t kFrame = 9;

scene::Scene comparison(const std::vector<std::string>& overrides = {}) {
  return scene::parseScene(
      "title = 'Four at once'\ncaption = 'The first of them did not last.'\n"
      "[simulation]\nintegrator = 'euler'\n"
      "[initial]\nangular_velocity = [5, 3, 1]\n"
      "[clip]\nsize = [480, 270]\nfps = 24\nduration = 0.5\n"
      "[camera]\nposition = [0.27, 0.19, 0.65]\n"
      "[overlay]\nshow = ['caption', 'clock', 'axes']\n"
      "[[panel]]\nlabel = 'bursts'\nsimulation.model = 'particles'\nsimulation.substeps = 1\n"
      "simulation.normalize = false\nsimulation.damping = 0\n"
      "[[panel]]\nlabel = 'matrix'\nsimulation.model = 'matrix'\n"
      "[[panel]]\nlabel = 'faster'\ninitial.angular_velocity = [10, 6, 2]\n"
      "[[panel]]\nlabel = 'exact'\nsimulation.model = 'exact'\n",
      "comparison.toml", overrides);
}

void makeGrey(image::Image& picture) {
  for (int y = 0; y < picture.height(); ++y) {
    for (int x = 0; x < picture.width(); ++x) {
      constexpr std::array<std::uint8_t, 4> kGrey{96, 96, 96, 255};
      std::ranges::copy(kGrey, picture.row(y) + static_cast<std::ptrdiff_t>(x) * 4);
    }
  }
}

/// Draws a frame over grey; with `touching`, bodies say that they touch all of the picture.
image::Image drawn(const scene::Scene& scene, std::int64_t frame, bool touching = false) {
  const timeline::ClipMotion motion = timeline::simulateScene(scene);
  Composition composition(scene, motion);
  const geometry::Camera camera = timeline::cameraOf(scene, composition.screen());
  image::Image picture = composition.makePicture();
  image::Image grey(composition.screen().width, composition.screen().height,
                    image::PixelFormat::Rgba8);
  makeGrey(grey);
  composition.setBackground(grey);
  const auto drawBody = [&](std::size_t i, std::size_t sample, const plot::PanelGrid::Position&,
                            image::Image& into) {
    if (touching) into.touch(into.area());
    const body::Cage& corners = motion.trajectories()[i].samples[sample].cage;
    return geometry::project(camera, corners, composition.screen()).clipFromWorld;
  };
  composition.draw(frame, drawBody, picture);
  return picture;
}

bool isMatchedBy(const image::Image& picture) {
  const image::Image golden = image::testing::golden("comparison");
  return image::compare(golden.view(), picture.view(), kOtherLibraries).same;
}

TEST(ComparisonGolden, IsMatched) {
  const image::Image picture = drawn(comparison(), kFrame);
  if (image::testing::updatingGoldens()) {
    image::testing::updateGolden("comparison", picture.view());
  }
  const auto result = image::testing::matchesGolden("comparison", picture.view(), kOtherLibraries);
  EXPECT_TRUE(result) << result.message();
}

TEST(ComparisonGolden, IsNotMatchedAtAnotherTime) {
  EXPECT_FALSE(isMatchedBy(drawn(comparison(), kFrame - 1)));
}

TEST(ComparisonGolden, IsNotMatchedWithoutTheNoticeOfADivergence) {
  EXPECT_FALSE(isMatchedBy(drawn(comparison({"panel.0.simulation.damping=1"}), kFrame)));
}

TEST(ComparisonGolden, IsNotMatchedByOtherLabelsOrPanels) {
  EXPECT_FALSE(isMatchedBy(drawn(comparison({"panel.3.label=precise"}), kFrame)));
  EXPECT_FALSE(
      isMatchedBy(drawn(comparison({"panel.1.simulation.model=exact", "panel.1.label=exact",
                                    "panel.3.label=matrix", "panel.3.simulation.model=matrix"}),
                        kFrame)));
}

// Of three panels: the arrow of the second begins in a tile that the first one's polhode has, too.
TEST(Composition, DrawsTheSameWhateverIsTouched) {
  const scene::Scene scene = scene::parseScene(
      "[initial]\nangular_velocity = [-5, -2, 0.02]\n[clip]\nsize = [1062, 402]\nduration = 0.2\n"
      "[camera]\nposition = [0, 0, 0.35]\n[overlay]\nshow = ['polhode', 'omega', 'energy']\n"
      "[[panel]]\nlabel = 'one'\n"
      "[[panel]]\nlabel = 'two'\ninitial.angular_velocity = [-5, 4, 1]\n"
      "[[panel]]\nlabel = 'three'\n",
      "three.toml");
  EXPECT_EQ(drawn(scene, 4), drawn(scene, 4, true));
}

/// The left panel of two with charts of the energy; the right one's motion is stepped as told.
image::Image calmBeside(const std::string& substeps) {
  const scene::Scene scene = scene::parseScene(
      "[initial]\nangular_velocity = [5, 3, 1]\n[clip]\nsize = [640, 360]\nduration = 0.5\n"
      "[overlay]\nshow = ['energy']\n[[panel]]\nlabel = 'calm'\n"
      "[[panel]]\nlabel = 'other'\nsimulation.model = 'particles'\nsimulation.damping = 0\n"
      "simulation.normalize = false\nsimulation.substeps = " +
          substeps + "\n",
      "pair.toml");
  const image::Image picture = drawn(scene, 9);
  image::Image left(310, 360, image::PixelFormat::Rgba8);
  for (int y = 0; y < left.height(); ++y) {
    std::copy_n(picture.row(y), left.stride(), left.row(y));
  }
  return left;
}

TEST(Composition, GivesChartsOfTheEnergyOneScale) {
  EXPECT_EQ(calmBeside("256"), calmBeside("512"));
  EXPECT_NE(calmBeside("256"), calmBeside("1"));  // with which the other bursts
}

/// A picture's panels, or the cells of a grid, of which some have diverged.
scene::Scene divided(const std::string& parts, const std::string& size) {
  return scene::parseScene(
      "[simulation]\nmodel = 'particles'\nnormalize = false\ndamping = 0\nintegrator = 'euler'\n"
      "[initial]\nangular_velocity = [5, 3, 1]\n[clip]\nfps = 24\nduration = 0.5\nsize = " +
          size + "\n[overlay]\nshow = ['half_turns']\n" + parts,
      "divided.toml");
}

std::string panels(int count) {
  std::string text;
  for (int i = 0; i < count; ++i)
    text += "[[panel]]\nlabel = 'explicit Euler, again " + std::to_string(i) +
            "'\nsimulation.substeps = " + std::to_string(i % 2 == 0 ? 1 : 64) + "\n";
  return text;
}

std::string grid(const std::string& rows) {
  return "[grid]\ncolumns = { key = 'simulation.substeps', values = [1, 2, 64] }\n" +
         (rows.empty() ? "" : "rows = { key = 'simulation.stiffness', values = [" + rows + "] }\n");
}

// Bodies are drawn below their texts, so that grey as far as the eye reaches stays grey.
TEST(Composition, WritesNothingOnThePicturesOfBodies) {
  for (const char* size : {"[320, 180]", "[426, 240]", "[640, 360]", "[240, 426]", "[160, 90]"}) {
    for (const std::string& parts :
         {panels(2), panels(4), panels(6), grid(""), grid("125, 250"), grid("125, 200, 250")}) {
      if (parts == panels(6) && std::string(size) == "[240, 426]") continue;  // refused
      SCOPED_TRACE(size + ("\n" + parts));
      const scene::Scene scene = divided(parts, size);
      const timeline::ClipMotion motion = timeline::simulateScene(scene);
      ASSERT_TRUE(motion.trajectories()[0].divergedAt);
      const geometry::Screen screen = Composition(scene, motion).screen();
      for (const std::int64_t frame : {0, 11}) {
        const image::Image picture = drawn(scene, frame);
        std::size_t grey = 0;
        for (int y = 0; y < picture.height(); ++y) {
          for (int x = 0; x < picture.width(); ++x) {
            const std::uint8_t* pixel = picture.row(y) + static_cast<std::ptrdiff_t>(x) * 4;
            if (pixel[0] == 96 && pixel[1] == 96 && pixel[2] == 96) ++grey;
          }
        }
        const auto whole = static_cast<std::size_t>(screen.width * screen.height);
        EXPECT_GE(grey, whole * motion.trajectories().size()) << "frame " << frame;
      }
    }
  }
}

TEST(Composition, NotesOverlaysThatHaveNoRoom) {
  const std::string show = "overlay.show=['caption', 'error', 'energy', 'polhode', 'axes']";
  const auto noteOnRoom = [](const scene::Scene& scene) {
    return notesOn(scene).empty() ? "" : notesOn(scene).back();
  };
  EXPECT_EQ(noteOnRoom(comparison()), "");
  EXPECT_EQ(noteOnRoom(comparison({show, "clip.size=[1920, 1080]"})), "");
  EXPECT_EQ(noteOnRoom(comparison({show, "clip.size=[480, 530]"})),
            "overlay.show has \"error\", for which panels have no room in 480x530 pixels; make the "
            "picture larger, or leave it out");
  EXPECT_EQ(noteOnRoom(comparison({show, "clip.size=[320, 240]"})),
            "overlay.show has \"polhode\", \"energy\" and \"error\", for which panels have no room "
            "in 320x240 "
            "pixels; make the picture larger, or leave them out");
  scene::Scene one = comparison({"overlay.show=['error']", "clip.size=[64, 64]"});
  one.motions.resize(1);
  one.motions[0].label.clear();
  one.motions[0].simulation.model = physics::Model::Matrix;
  EXPECT_EQ(noteOnRoom(one),
            "overlay.show has \"error\", for which a picture has no room in 64x64 pixels; make the "
            "picture larger, or leave it out");
}

}  // namespace
}  // namespace rotatebook::picture
