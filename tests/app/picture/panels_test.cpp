// Clips of several motions side by side.
#include <filesystem>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "base/same_bytes.h"
#include "image/png_file.h"
#include "messages.h"
#include "picture/attitudes.h"
#include "picture/composition.h"
#include "picture/frame_drawer.h"
#include "pipeline/small_clip.h"
#include "timeline/trajectory_csv.h"

namespace rotatebook::picture {
namespace {

namespace fs = std::filesystem;
using pipeline::testing::bytesOf;
using pipeline::testing::kFrames;
using ::testing::ElementsAre;

// Two panels beside each other, the second of a motion that diverges at frame 5 of 12.
scene::Scene pair(const std::vector<std::string>& overrides = {}) {
  return scene::parseScene(
      "[initial]\nangular_velocity = [5, 3, 1]\n"
      "[clip]\nsize = [128, 72]\nfps = 24\nduration = 0.5\n"
      "[simulation]\ntime_per_frame = 0.041666666666666664\n"
      "[[panel]]\nlabel = 'Goes on'\n"
      "[[panel]]\nlabel = 'Bursts'\nsimulation.model = 'particles'\nsimulation.substeps = 1\n"
      "simulation.normalize = false\nsimulation.damping = 0\n",
      "pair.toml", overrides);
}

image::Image drawnPair(const scene::Scene& scene, std::int64_t frame) {
  const timeline::ClipMotion motion = timeline::simulateScene(scene);
  FrameDrawer drawer(scene, motion);
  image::Image picture = drawer.makePicture();
  drawer.draw(frame, picture);
  return picture;
}

// The part of `picture` that panel `index` of two has.
image::Image panelOf(const image::Image& picture, std::size_t index) {
  const plot::PanelGrid grid = plot::panelGrid(2, picture.width(), picture.height());
  image::Image panel(grid.width, grid.height, picture.format());
  for (int y = 0; y < grid.height; ++y) {
    const std::uint8_t* row =
        picture.row(grid.positions[index].y + y) + 4 * grid.positions[index].x;
    std::copy_n(row, panel.stride(), panel.row(y));
  }
  return panel;
}

// Returns the lower part of a panel, which its label can't reach.
image::Image belowLabel(const image::Image& panel) {
  constexpr int kLowerRows = 30;
  const int top = panel.height() - kLowerRows;
  image::Image below(panel.width(), kLowerRows, panel.format());
  std::copy_n(panel.row(top), below.stride() * below.height(), below.row(0));
  return below;
}

TEST(Panels, EachShowTheirMotionsSample) {
  const scene::Scene scene = pair();
  const timeline::ClipMotion motion = timeline::simulateScene(scene);
  std::vector<image::Image> expected;
  {
    const geometry::Screen screen = Composition(scene, motion).screen();
    EXPECT_EQ(screen.height, 36) << "a head takes up to half of a very small panel";
    render::Renderer renderer = makeRenderer(scene, screen, loadLooks(scene).looks);
    for (const auto& trajectory : motion.trajectories()) {
      expected.push_back(renderer.makePicture());
      renderer.draw(trajectory.samples[3].cage, expected.back());
    }
  }
  const image::Image picture = drawnPair(scene, 3);
  for (const std::size_t i : {0, 1}) {
    EXPECT_EQ(belowLabel(panelOf(picture, i)), belowLabel(expected[i])) << i;
    const std::string other = "panel." + std::to_string(i) + ".label='Other'";
    const image::Image labelled = drawnPair(pair({other}), 3);
    EXPECT_NE(panelOf(picture, i), panelOf(labelled, i)) << i << " has no label";
    EXPECT_EQ(belowLabel(panelOf(picture, i)), belowLabel(panelOf(labelled, i)));
  }
  EXPECT_NE(belowLabel(expected[0]), belowLabel(expected[1]));
}

TEST(Panels, HoldTheLastPictureOfAMotionThatDivergesWhileOthersGoOn) {
  const scene::Scene scene = pair();
  EXPECT_EQ(timeline::simulateScene(scene).frameCount(), kFrames);
  const image::Image first = drawnPair(scene, 5), later = drawnPair(scene, 9);
  EXPECT_NE(panelOf(first, 0), panelOf(later, 0));
  EXPECT_EQ(panelOf(first, 1), panelOf(later, 1));
}

TEST(Panels, HaveATableEach) {
  const fs::path folder = pipeline::testing::emptyFolder();
  const pipeline::RenderResult result =
      pipeline::testing::render(pair(), pipeline::testing::pngAndMp4(folder));
  EXPECT_THAT(pipeline::testing::namesIn(folder),
              ElementsAre("pair", "pair.json", "pair.mp4", "pair.poster.png", "pair_bursts.csv",
                          "pair_goes-on.csv"));
  EXPECT_THAT(result.csvs, ElementsAre(folder / "pair_goes-on.csv", folder / "pair_bursts.csv"));
  const timeline::ClipMotion motion = timeline::simulateScene(pair());
  EXPECT_EQ(bytesOf(result.csvs[0]), timeline::trajectoryCsv(motion.trajectories()[0]));
  EXPECT_EQ(bytesOf(result.csvs[1]), timeline::trajectoryCsv(motion.trajectories()[1]));
  EXPECT_EQ(motion.trajectories()[1].samples.size(), 5U);
}

TEST(Panels, GiveTheSameBytesAgain) {
  const fs::path folder = pipeline::testing::emptyFolder();
  pipeline::testing::render(pair(), pipeline::testing::pngAndMp4(folder / "a"));
  pipeline::testing::render(pair(), pipeline::testing::pngAndMp4(folder / "b"));
  EXPECT_TRUE(rotatebook::testing::sameBytes(bytesOf(folder / "a/pair.mp4"),
                                             bytesOf(folder / "b/pair.mp4")));
}

TEST(Panels, NeedRoom) {
  EXPECT_MESSAGE(
      pipeline::testing::messageOf<InputError>([] { drawnPair(pair({"clip.size=[28, 16]"}), 0); }));
}

TEST(Panels, AreNamedInWhatIsWrongWithTheirMotion) {
  const scene::Scene scene =
      pair({"panel.1.simulation.model=quaternion", "panel.1.simulation.integrator=dmv2",
            "simulation.time_per_frame=2", "panel.1.initial.tilt=[0.3, 'z']"});
  EXPECT_MESSAGE(pipeline::testing::messageOf<InputError>([&] { timeline::simulateScene(scene); }));
}

std::vector<fs::path> filesOf(const std::vector<std::string>& labels) {
  scene::Scene scene;
  if (!labels.empty()) scene.motions.clear();
  for (const std::string& label : labels) scene.motions.emplace_back().label = label;
  return store::csvFiles("out/a.csv", scene);
}

TEST(CsvFiles, AreNamedAfterTheLabels) {
  EXPECT_THAT(filesOf({}), ElementsAre("out/a.csv"));
  EXPECT_THAT(filesOf({"particles", "h = 1/60 s", " (Matrix) "}),
              ElementsAre("out/a_particles.csv", "out/a_h-1-60-s.csv", "out/a_matrix.csv"));
}

TEST(CsvFiles, AreAllDifferent) {
  EXPECT_THAT(filesOf({"A", "a", "a!"}),
              ElementsAre("out/a_a.csv", "out/a_a2.csv", "out/a_a3.csv"));
  EXPECT_THAT(filesOf({"a2", "a", "?", "A"}),
              ElementsAre("out/a_a2.csv", "out/a_a.csv", "out/a_3.csv", "out/a_a4.csv"));
  EXPECT_THAT(filesOf({"a3", "a", "A"}),
              ElementsAre("out/a_a3.csv", "out/a_a.csv", "out/a_a3-3.csv"));
}

// Books in attitudes all round, as tests of the default camera have them.
TEST(Panels, ShowAllOfTheBookWhateverTheirShape) {
  for (const char* size : {"clip.size=[128,72]", "clip.size=[300,72]", "clip.size=[64,300]"}) {
    const scene::Scene scene = pair({size});
    const timeline::ClipMotion motion = timeline::simulateScene(scene);
    const geometry::Screen screen = Composition(scene, motion).screen();
    EXPECT_FALSE(testing::anyAttitudeTouchesBorder(scene, screen, 1)) << size;
    const int margin = std::min(screen.width, screen.height) / 5;
    EXPECT_TRUE(testing::anyAttitudeTouchesBorder(scene, screen, margin))
        << size << " shows it small";
  }
}

}  // namespace
}  // namespace rotatebook::picture
