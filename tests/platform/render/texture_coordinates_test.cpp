// Positions of the cover's pictures on the screen.
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "render/drawing.h"

namespace rotatebook::render {
namespace {

using testing::book;
using testing::Colour;
using testing::colourAt;
using testing::drawn;
using testing::kX;
using testing::kY;
using testing::plain;
using testing::setColour;

constexpr Colour kRed{200, 10, 10};
constexpr Colour kGreen{10, 200, 10};
constexpr Colour kBlue{10, 10, 200};
constexpr Colour kYellow{200, 200, 10};
constexpr Colour kBlack{10, 10, 10};

// The side's picture: red, green over blue, yellow.
image::Image quadrants() {
  constexpr int kSide = 64;
  image::Image picture = plain(kSide, kSide, kRed);
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x) {
      const bool right = x >= kSide / 2, lower = y >= kSide / 2;
      setColour(picture, x, y, lower ? (right ? kYellow : kBlue) : (right ? kGreen : kRed));
    }
  }
  return picture;
}

std::string hueOf(const Colour& colour) {
  constexpr int kClear = 40;
  const bool red = colour.red > colour.blue + kClear;
  const bool green = colour.green > colour.blue + kClear;
  if (red && green) return std::abs(colour.red - colour.green) < kClear ? "yellow" : "unclear";
  if (red) return "red";
  if (green) return "green";
  return colour.blue > colour.red + kClear ? "blue" : "none";
}

constexpr int kSize = 128;

// Hues at `across` and `down` pixels from the middle: top left, top right, bottom left, bottom
// right.
std::string huesAround(const image::Image& picture, int across, int down) {
  std::string text;
  for (const int y : {kSize / 2 - down, kSize / 2 + down - 1}) {
    for (const int x : {kSize / 2 - across, kSize / 2 + across - 1}) {
      text += hueOf(colourAt(picture, x, y)) + " ";
    }
  }
  return text;
}

// Seen from `direction`, with quadrants on one side and black on the others.
image::Image inReferenceFrame(const Eigen::Vector3d& direction, const BookTextures& textures) {
  RenderSettings settings = testing::settingsOf(kSize, kSize);
  settings.camera.position = 0.9 * direction;
  Renderer renderer(settings, textures);
  return drawn(renderer, book());
}

TEST(TextureCoordinates, FrontIsUprightFromTheFront) {
  const BookTextures textures{quadrants(), plain(8, 8, kBlack), plain(8, 8, kBlack)};
  EXPECT_EQ(huesAround(inReferenceFrame({0, 0, 1}, textures), 12, 20), "red green blue yellow ");
}

TEST(TextureCoordinates, BackIsUprightFromBehind) {
  const BookTextures textures{plain(8, 8, kBlack), plain(8, 8, kBlack), quadrants()};
  EXPECT_EQ(huesAround(inReferenceFrame({0, 0, -1}, textures), 12, 20), "red green blue yellow ");
}

TEST(TextureCoordinates, SpineIsUprightFromTheSpine) {
  const BookTextures textures{plain(8, 8, kBlack), quadrants(), plain(8, 8, kBlack)};
  EXPECT_EQ(huesAround(inReferenceFrame({-1, 0, 0}, textures), 4, 20), "red green blue yellow ");
}

TEST(TextureCoordinates, EachCoverIsOnItsOwnSide) {
  const BookTextures textures{plain(8, 8, kRed), plain(8, 8, kGreen), plain(8, 8, kBlue)};
  EXPECT_EQ(huesAround(inReferenceFrame({0, 0, 1}, textures), 12, 20), "red red red red ");
  EXPECT_EQ(huesAround(inReferenceFrame({0, 0, -1}, textures), 12, 20), "blue blue blue blue ");
  EXPECT_EQ(huesAround(inReferenceFrame({-1, 0, 0}, textures), 4, 20), "green green green green ");
}

TEST(TextureCoordinates, PagesShowOnTheThreeOtherSides) {
  const BookTextures textures{plain(8, 8, kGreen), plain(8, 8, kGreen), plain(8, 8, kGreen)};
  for (const Eigen::Vector3d& side :
       {Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(0.01, 1, 0), Eigen::Vector3d(0.01, -1, 0)}) {
    RenderSettings settings = testing::settingsOf(kSize, kSize);
    settings.camera.position = 0.9 * side;
    settings.camera.up = {0, 0, 1};
    Renderer renderer(settings, textures);
    const Colour middle = colourAt(drawn(renderer, book()), kSize / 2, kSize / 2);
    // The colour of paper, far from the covers' green; lit least from below. measured 52
    EXPECT_GE(middle.red, middle.green) << "from " << side.transpose();
    EXPECT_GE(middle.green, middle.blue) << "from " << side.transpose();
    EXPECT_GT(middle.blue, 40) << "from " << side.transpose();
  }
}

TEST(TextureCoordinates, NearAndFarCoversHideEachOther) {
  const BookTextures textures{plain(8, 8, kRed), plain(8, 8, kBlack), plain(8, 8, kBlue)};
  Renderer renderer(testing::settingsOf(kSize, kSize), textures);
  body::Cage swapped = book();
  swapped.row(2) *= -1;  // Inside out: now the back cover is nearest.
  EXPECT_EQ(huesAround(drawn(renderer, book()), 12, 20), "red red red red ");
  EXPECT_EQ(huesAround(drawn(renderer, swapped), 12, 20), "blue blue blue blue ");
}

// A picture whose left part, up to `share` of its width, is red; the rest is blue.
image::Image split(double share) {
  constexpr int kWide = 1024;
  image::Image picture = plain(kWide, 16, kBlue);
  for (int y = 0; y < 16; ++y) {
    for (int x = 0; x < kWide * share; ++x) setColour(picture, x, y, kRed);
  }
  return picture;
}

constexpr int kWide = 512;

// Returns the position along row `y` at which red gives way to blue. [pixels]
double splitInRow(const image::Image& picture, int y) {
  for (int x = 1; x < picture.width(); ++x) {
    const Colour left = colourAt(picture, x - 1, y), right = colourAt(picture, x, y);
    if (hueOf(left) == "red" && hueOf(right) != "red") return x;
  }
  return -1;
}

// The picture's place of the point `unit` of the cube that `corners` span.
Eigen::Vector2d placeOf(const RenderSettings& settings, const body::Cage& corners,
                        const Eigen::Vector3d& unit) {
  Eigen::Vector3d world = Eigen::Vector3d::Zero();
  for (int i = 0; i < 8; ++i) {
    double weight = 1;
    for (int axis = 0; axis < 3; ++axis) {
      weight *= (i >> axis & 1) != 0 ? unit[axis] : 1 - unit[axis];
    }
    world += weight * corners.col(i);
  }
  const geometry::Projection projection =
      geometry::project(settings.camera, corners, {settings.width, settings.height});
  const Eigen::Vector4d clip = projection.clipFromWorld * world.homogeneous();
  return {(clip.x() / clip.w() + 1) / 2 * settings.width,
          (clip.y() / clip.w() + 1) / 2 * settings.height};
}

// Largest distance of the split from where the trilinear map puts it, along five lines. [pixels]
double largestError(const body::Cage& corners, double share) {
  RenderSettings settings = testing::settingsOf(kWide, kWide);
  settings.camera.position = {0, 0, 0.2};  // So near that perspective is strong.
  settings.camera.fieldOfViewDeg = 90;
  Renderer renderer(settings, {split(share), plain(8, 8, kBlack), plain(8, 8, kBlack)});
  const image::Image picture = drawn(renderer, corners);
  double largest = 0;
  for (const double height : {0.35, 0.45, 0.5, 0.55, 0.65}) {
    const Eigen::Vector2d place = placeOf(settings, corners, {share, height, 1});
    if (!(place.y() >= 0 && place.y() < kWide)) return kWide;
    const double found = splitInRow(picture, static_cast<int>(place.y()));
    largest = std::max(largest, std::abs(found - place.x()));
  }
  return largest;
}

// Halfway between two lines of the grid, where a map that ignores perspective is worst.
TEST(TextureCoordinates, IsCorrectInPerspective) {
  constexpr double kBound = 1;  // pixels; measured 0.40, without perspective 2.2
  EXPECT_LT(largestError(book({{60, kY}}), 0.375), kBound);
  EXPECT_LT(largestError(book({{-55, kY}, {10, kX}}), 0.625), kBound);
}

TEST(TextureCoordinates, FollowsTheTrilinearMapOnASkewedSide) {
  constexpr double kBound = 1;  // pixels; measured 0.53
  body::Cage corners = book({{40, kY}});
  corners.col(7) += Eigen::Vector3d(0.03, -0.06, 0.06);  // Fore edge, head, front.
  corners.col(4) += Eigen::Vector3d(-0.04, 0.03, 0.02);  // Spine, foot, front.
  EXPECT_LT(largestError(corners, 0.5), kBound);
  EXPECT_LT(largestError(corners, 0.375), kBound);
}

}  // namespace
}  // namespace rotatebook::render
