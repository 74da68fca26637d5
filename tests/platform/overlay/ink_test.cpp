#include "overlay/ink.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "overlay/caption_and_clock.h"
#include "overlay/motion.h"
#include "overlay/palette.h"

namespace rotatebook::overlay {
namespace {

constexpr std::array<Colour, 12> kInks{kWhite,          kGrey,           kAxisColours[0],
                                       kAxisColours[1], kAxisColours[2], kVelocityColour,
                                       kMomentumColour, kKineticColour,  kSpringColour,
                                       kErrorColour,    kGhostColour,    kWarningColour};

scene::Scene sceneOn(const std::string& background) {
  return testing::tumbling({"look.background='" + background + "'", "clip.size=[1280, 720]",
                            "overlay.show=['caption', 'clock']"});
}

double luminanceOf(const Colour& colour) {
  const auto linear = [](double value) {
    return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
  };
  return 0.2126 * linear(colour.red) + 0.7152 * linear(colour.green) + 0.0722 * linear(colour.blue);
}

double contrast(const Colour& a, const Colour& b) {
  const double x = luminanceOf(a) + 0.05, y = luminanceOf(b) + 0.05;
  return std::max(x, y) / std::min(x, y);
}

bool same(const Colour& a, const Colour& b) {
  return a.red == b.red && a.green == b.green && a.blue == b.blue;
}

TEST(Ink, IsTheColourItselfOnDarkGround) {
  for (const char* ground : {"studio", "stars", "transparent", "black", "#2b5d8a", "#c00000"}) {
    const Ink ink(sceneOn(ground));
    for (const Colour& colour : kInks) EXPECT_TRUE(same(ink(colour), colour)) << ground;
    EXPECT_TRUE(same(ink(kDark), kDark)) << ground;
  }
}

TEST(Ink, IsDarkOnBrightGround) {
  constexpr double kMin = 4.5;  // measured 4.56
  for (const auto& [name, grey] : {std::pair("white", 1.0), std::pair("#c0c0c0", 192 / 255.0)}) {
    const Ink ink(sceneOn(name));
    const Colour ground{grey, grey, grey};
    for (const Colour& colour : kInks) {
      EXPECT_GT(contrast(ink(colour), ground), kMin)
          << name << ": " << colour.red << ' ' << colour.green << ' ' << colour.blue;
    }
    EXPECT_GT(luminanceOf(ink(kDark)), 0.8);
  }
}

TEST(Ink, KeepsHuesApart) {
  const Ink ink(sceneOn("white"));
  const Colour red = ink(kAxisColours[0]), green = ink(kAxisColours[1]),
               blue = ink(kAxisColours[2]);
  EXPECT_GT(red.red, 2 * std::max(red.green, red.blue));
  EXPECT_GT(green.green, 1.2 * std::max(green.red, green.blue));
  EXPECT_GT(blue.blue, 1.2 * std::max(blue.red, blue.green));
}

/// Returns how bright the darkest pixel is when the clock is drawn over white. [0 to 255]
int darkest(const scene::Scene& scene) {
  image::Image picture(scene.clip.width, scene.clip.height, image::PixelFormat::Rgba8);
  std::fill_n(picture.row(0), picture.stride() * picture.height(), std::uint8_t{255});
  CaptionAndClock(scene).draw(0, picture);
  int least = 255;
  for (int y = 0; y < picture.height() / 2; ++y) {
    for (int x = 0; x < picture.width(); ++x) {
      least = std::min<int>(least,
                            *std::max_element(picture.row(y) + 4 * x, picture.row(y) + 4 * x + 3));
    }
  }
  return least;
}

TEST(Ink, IsWhatTextsAreWrittenWith) {
  EXPECT_LT(darkest(sceneOn("white")), 45);   // measured 35
  EXPECT_GT(darkest(sceneOn("studio")), 60);  // measured 78
}

// Not even the shade that lies below a caption on other backgrounds.
TEST(Ink, LeavesAFlatBackgroundFlat) {
  const scene::Scene scene = sceneOn("#2b5d8a");
  image::Image picture(scene.clip.width, scene.clip.height, image::PixelFormat::Rgba8);
  CaptionAndClock(scene).draw(0, picture);
  const std::uint8_t* corner = picture.row(picture.height() - 1);
  EXPECT_EQ(corner[3], 0);
  CaptionAndClock(sceneOn("studio")).draw(0, picture);
  EXPECT_GT(corner[3], 0);
}

}  // namespace
}  // namespace rotatebook::overlay
