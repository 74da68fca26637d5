// The energies of spins about the axes, as the ladder and the chart of the energy show them; of the
// book of scenes/starter.toml.
#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "overlay/motion.h"
#include "overlay/palette.h"
#include "overlay/text.h"

namespace rotatebook::overlay {
namespace {

scene::Scene starterShowing(const std::string& overlay, const std::string& spin = "[5, 0, 0]",
                            const std::string& tilt = "['1 deg', 'z']") {
  return scene::parseScene("simulation.model = 'exact'\noverlay.show = ['" + overlay +
                               "']\n[initial]\nangular_velocity = " + spin + "\ntilt = " + tilt +
                               "\n[clip]\nfps = 30\nduration = 2\nsize = [1280, 720]\n",
                           "starter.toml");
}

std::vector<Box> boxesOf(const scene::Scene& scene) {
  const physics::Trajectory trajectory = testing::motionOf(scene);
  MotionOverlays overlays = testing::overlaysOf(scene, trajectory);
  testing::drawn(overlays, scene, 0);
  return overlays.texts();
}

/// Returns the width of `text` on the ladder of a picture. [pixels]
double widthOnLadder(const std::string& text, int width = 1280, int height = 720) {
  TextStyle style;
  style.size = Scale(width, height).smallLetters;
  style.tabular = true;
  return Typesetter().measure(text, style, width).width;
}

double middleOf(const Box& box) {
  return box.y + box.height / 2;
}

// E lies below the middle axis' energy by 1.577e-4.
TEST(EnergyLadder, SaysByHowMuchTheEnergyIsUnderTheMiddleAxis) {
  const std::vector<Box> texts = boxesOf(starterShowing("energy_ladder"));
  ASSERT_EQ(texts.size(), 5U);
  EXPECT_EQ(texts[4].width, widthOnLadder("x − 0.016 %"));
  EXPECT_NE(widthOnLadder("x − 0.016 %"), widthOnLadder("x − 0.16 %"));
}

// From the top: smallest, middle and largest moment.
TEST(EnergyLadder, HasItsRungsInTheOrderOfTheMoments) {
  scene::Scene scene = starterShowing("energy_ladder");
  const std::vector<Box> brief = boxesOf(scene);
  scene.clip.width = 480;
  scene.clip.height = 360;  // Charts are at the bottom there, and wide.
  const std::vector<Box> whole = boxesOf(scene);
  ASSERT_EQ(brief.size(), 5U);
  ASSERT_EQ(whole.size(), 5U);
  const std::string words[] = {"y  smallest moment", "x  middle moment", "z  largest moment"};
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(brief[i + 1].width, widthOnLadder(words[i].substr(0, 1)));
    EXPECT_EQ(whole[i + 1].width, widthOnLadder(words[i], 480, 360));
  }
  EXPECT_LT(middleOf(brief[1]), middleOf(brief[2]) - brief[1].height);
  EXPECT_LT(middleOf(brief[2]), middleOf(brief[3]));
}

/// Returns the rows in which a column of pixels is as white as the ladder's pointer.
std::vector<int> whiteRowsOf(const scene::Scene& scene, int column) {
  const image::Image picture = testing::drawn(scene, 0);
  std::vector<int> rows;
  for (int y = 0; y < picture.height(); ++y) {
    const std::uint8_t* pixel = picture.row(y) + 4 * static_cast<std::ptrdiff_t>(column);
    if (std::min({pixel[0], pixel[1], pixel[2]}) > 225) rows.push_back(y);
  }
  return rows;
}

TEST(EnergyLadder, PointsAtTheEnergy) {
  const Box title = boxesOf(starterShowing("energy_ladder"))[0];
  const int column = static_cast<int>(title.x + 0.4 * Scale(1280, 720).smallLetters);
  const auto rowAt = [&](const std::string& spin, const std::string& tilt) {
    std::vector<int> rows = whiteRowsOf(starterShowing("energy_ladder", spin, tilt), column);
    std::erase_if(rows, [&](int row) { return row < title.bottom(); });
    EXPECT_FALSE(rows.empty());
    return rows.empty() ? 0.0 : (rows.front() + rows.back()) / 2.0;
  };
  const double x = rowAt("[5, 0, 0]", "[0.01, 'z']"), y = rowAt("[0, 5, 0]", "[1e-6, 'z']"),
               z = rowAt("[0, 0, 5]", "[1e-6, 'x']");
  // (1 / Ix - 1 / Iz) / (1 / Iy - 1 / Iz)
  EXPECT_NEAR((z - x) / (z - y), 0.1731, 0.01);  // measured 0.17
  EXPECT_GT(z - y, 60);
}

/// Returns the middles of the lines that cross a column of pixels, between two rows.
std::vector<double> linesAt(const image::Image& picture, int column, int from, int to) {
  std::vector<double> middles;
  int begin = -1;
  for (int y = from; y < to; ++y) {
    const std::uint8_t* pixel = picture.row(y) + 4 * static_cast<std::ptrdiff_t>(column);
    const bool isBright = std::max({pixel[0], pixel[1], pixel[2]}) > 48;
    if (isBright && begin < 0) begin = y;
    if (!isBright && begin >= 0) {
      middles.push_back((begin + y - 1) / 2.0);
      begin = -1;
    }
  }
  return middles;
}

TEST(EnergyChart, MarksTheEnergiesOfTheAxes) {
  scene::Scene scene = starterShowing("energy");
  scene.clip.width *= 2;
  scene.clip.height *= 2;
  // Title, "kinetic", the ticks 1 and 0, the letters z and x, the end's time; y's is out of range.
  const std::vector<Box> texts = boxesOf(scene);
  ASSERT_EQ(texts.size(), 7U);
  const std::vector<double> lines =
      linesAt(testing::drawn(scene, 0), static_cast<int>(texts[6].x),
              static_cast<int>(texts[0].bottom()) + 4, static_cast<int>(texts[6].y));
  ASSERT_EQ(lines.size(), 3U);  // x's is where 1 is
  EXPECT_NEAR((lines[2] - lines[1]) / (lines[2] - lines[0]), 0.726727807, 0.012);
}

TEST(EnergyChart, MarksNothingBeyondItsRange) {
  // About y, with 2.3 and 3.2 times less energy about x and z.
  const std::vector<Box> texts = boxesOf(starterShowing("energy", "[0, 5, 0]"));
  EXPECT_EQ(texts.size(), 8U);
}

}  // namespace
}  // namespace rotatebook::overlay
