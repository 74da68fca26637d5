// Bodies of any shape, drawn.
#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "body/shape.h"
#include "render/drawing.h"
#include "render/surface_look.h"

namespace rotatebook::render::testing {
namespace {

const body::Cuboid kBox{{0.2, 0.3, 0.05}, 1};

std::shared_ptr<SurfaceLook> boxLook(const body::Material& material) {
  auto look = std::make_shared<SurfaceLook>();
  const std::array<double, 3> lengths{0.2, 0.3, 0.05};
  look->surface.mesh = body::findShape("box")->solid(lengths).surface;
  look->surface.materials = {material};
  look->size = kBox.size;
  return look;
}

RenderSettings transparent(int width, int height) {
  RenderSettings settings = settingsOf(width, height);
  settings.background = Background::Transparent;
  return settings;
}

image::Image drawn(const RenderSettings& settings, const BodyLook& look, const body::Cage& cage) {
  Renderer renderer(settings, std::vector<BodyLook>{look});
  image::Image picture = renderer.makePicture();
  renderer.draw(cage, picture);
  return picture;
}

/// Returns the sum of all pixels' coverages. [pixels]
double areaOf(const image::Image& picture) {
  double sum = 0;
  for (int y = 0; y < picture.height(); ++y) {
    for (int x = 0; x < picture.width(); ++x) sum += picture.row(y)[4 * x + 3];
  }
  return sum / 255;
}

TEST(Surface, CoversWhatItsOutlineHolds) {
  const RenderSettings settings = transparent(320, 180);
  const image::Image picture = drawn(settings, boxLook({}), kBox.corners());
  // The front, at a distance of 0.9 - 0.025 m, on a picture 2 * 0.9 tan 15 deg high at 0.9 m
  const double pixels = 180 / (2 * std::tan(15 * kDegree) * 0.875);        // [1/m]
  EXPECT_NEAR(areaOf(picture) / (0.2 * 0.3 * pixels * pixels), 1, 0.002);  // measured 0.9994
}

/// Returns a racket with its usual lengths, in the middle of its box.
std::shared_ptr<SurfaceLook> racketLook() {
  const body::Shape& shape = *body::findShape("racket");
  std::vector<double> lengths;
  for (const body::ShapeLength& length : shape.lengths) lengths.push_back(length.byDefault);
  auto look = std::make_shared<SurfaceLook>();
  look->surface = shape.look(lengths);
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& point : look->surface.mesh.points) box.extend(point);
  for (Eigen::Vector3d& point : look->surface.mesh.points) point -= box.center();
  look->size = box.sizes();
  return look;
}

// In the seventh picture a string's triangle is seen so exactly from its side that rounding decides
// on which side of its edges it lies.
TEST(Surface, OfThinPartsCoversWhatTheirOutlinesHold) {
  RenderSettings settings = transparent(320, 180);
  const std::vector<BodyLook> looks{racketLook()};
  Renderer once(settings, looks);
  settings.supersample = 2;
  Renderer fourTimes(settings, looks);
  const body::Cage racket = body::Cuboid{racketLook()->size, 1}.corners();
  image::Image coarse = once.makePicture(), fine = fourTimes.makePicture();
  double largest = 0;
  for (int i = 0; i < 16; ++i) {
    const body::Cage cage = turned(racket, {{7.0 * i, kY}, {11.0 * i, kX}});
    once.draw(cage, coarse);
    fourTimes.draw(cage, fine);
    largest = std::max(largest, std::abs(areaOf(coarse) / areaOf(fine) - 1));
  }
  EXPECT_LT(largest, 0.004);  // measured 0.0019
}

/// Returns a white box through whose front a dark ball comes.
std::shared_ptr<SurfaceLook> ballInBox() {
  auto look = boxLook({.baseColour = {0.9F, 0.9F, 0.9F}});
  const std::array<double, 3> lengths{0.08, 0.08, 0.08};
  body::addSurface({.mesh = body::findShape("ellipsoid")->solid(lengths).surface,
                    .materials = {{.baseColour = {0.01F, 0.01F, 0.01F}}}},
                   look->surface);
  look->size = {0.2, 0.3, 0.16};
  return look;
}

// Neither surface has an edge there.
TEST(Surface, IsSmoothWhereItGoesThroughAnother) {
  const image::Image picture =
      drawn(transparent(320, 180), ballInBox(), body::Cuboid{{0.2, 0.3, 0.16}, 1}.corners());
  int between = 0;
  for (int y = 60; y < 120; ++y) {
    for (int x = 130; x < 190; ++x) {
      const int green = picture.row(y)[4 * x + 1];
      between += green > 90 && green < 230 ? 1 : 0;
    }
  }
  EXPECT_GT(between, 40);  // measured 50, without it 2
}

TEST(Surface, HasTheColourOfItsMaterial) {
  body::Material red{.baseColour = {0.6F, 0.02F, 0.02F}};
  const image::Image picture = drawn(transparent(64, 36), boxLook(red), kBox.corners());
  const std::uint8_t* middle = picture.row(18) + 4 * 32;
  EXPECT_GT(middle[0], 2 * middle[1]);
  EXPECT_EQ(middle[3], 255);
}

/// Returns a box with a picture, green above and blue below, `times` as often as it is high.
std::shared_ptr<SurfaceLook> picturedBox(float times, const body::Sampling& sampling) {
  auto look = boxLook({.baseColour = {1, 1, 1}, .baseColourImage = 0});
  for (const auto& triangle : look->surface.mesh.triangles) {
    auto& corners = look->surface.texCoords.emplace_back();
    for (std::size_t i = 0; i < 3; ++i) {
      const Eigen::Vector3d& point = look->surface.mesh.points[triangle[i]];
      corners[i] = {static_cast<float>(point.x() / 0.2 + 0.5),
                    times * static_cast<float>(0.5 - point.y() / 0.3)};  // Down, as in glTF.
    }
  }
  look->surface.samplings = {sampling};
  image::Image& picture = look->images.emplace_back(8, 8, image::PixelFormat::Rgb8);
  for (int y = 0; y < 8; ++y) {
    for (int x = 0; x < 8; ++x) picture.row(y)[3 * x + (y < 4 ? 1 : 2)] = 200;
  }
  return look;
}

/// Returns whether the box is green rather than blue, `share` of its height below its top.
bool isGreenAt(const image::Image& picture, double share) {
  constexpr double kTop = 6, kHeight = 24;  // As in CoversWhatItsOutlineHolds: 23.0 pixels high.
  const std::uint8_t* pixel = picture.row(static_cast<int>(kTop + share * kHeight)) + 4 * 32;
  EXPECT_GT(std::max(pixel[1], pixel[2]), 2 * std::min(pixel[1], pixel[2]));
  return pixel[1] > pixel[2];
}

TEST(Surface, ShowsItsPictureWhereItsTextureCoordinatesSay) {
  const image::Image made =
      drawn(transparent(64, 36), BodyLook(picturedBox(1, {})), kBox.corners());
  EXPECT_TRUE(isGreenAt(made, 0.25));
  EXPECT_FALSE(isGreenAt(made, 0.75));
}

// Half a picture in each quarter of the box: green, blue, and what is beyond the picture's edge.
TEST(Surface, GoesOnBeyondItsPictureAsTheSamplingSays) {
  const auto beyond = [](body::Wrap wrap) {
    const image::Image made =
        drawn(transparent(64, 36), BodyLook(picturedBox(2, {.down = wrap})), kBox.corners());
    EXPECT_TRUE(isGreenAt(made, 0.12));
    EXPECT_FALSE(isGreenAt(made, 0.38));
    return std::array{isGreenAt(made, 0.62), isGreenAt(made, 0.88)};
  };
  EXPECT_EQ(beyond(body::Wrap::Repeat), (std::array{true, false}));
  EXPECT_EQ(beyond(body::Wrap::Mirror), (std::array{false, true}));
  EXPECT_EQ(beyond(body::Wrap::Clamp), (std::array{false, false}));
}

// Of 8x8 pixels, the two in the middle mix over an eighth of the box's height.
TEST(Surface, MixesNoPixelsOfAPictureWithSquares) {
  const auto mixedRows = [](bool hasSquares) {
    const image::Image made =
        drawn(transparent(640, 360), BodyLook(picturedBox(1, {.hasSquares = hasSquares})),
              kBox.corners());
    int rows = 0;
    for (int y = 90; y < 270; ++y) {
      const std::uint8_t* pixel = made.row(y) + 4 * 320;
      rows += std::min(pixel[1], pixel[2]) > 60 ? 1 : 0;
    }
    return rows;
  };
  EXPECT_GT(mixedRows(false), 10);
  EXPECT_LE(mixedRows(true), 1);
}

TEST(Surface, OfMetalMirrorsWhereARoughOneScatters) {
  const body::Material metal{.metalness = 1, .roughness = 0.1F}, matt{.roughness = 1};
  const body::Cage cage = turned(kBox.corners(), {{30, kY}});
  EXPECT_NE(drawn(transparent(64, 36), boxLook(metal), cage),
            drawn(transparent(64, 36), boxLook(matt), cage));
}

TEST(Surface, MayBeDrawnBesideTheBookByOneRenderer) {
  const RenderSettings settings = settingsOf(160, 90);
  const std::shared_ptr<SurfaceLook> box = boxLook({});
  const image::Image boxAlone = drawn(settings, box, kBox.corners());
  const image::Image bookAlone = drawn(settings, builtinTextures(), book());
  Renderer both(settings, {builtinTextures(), box});
  image::Image picture = both.makePicture();
  both.draw(1, kBox.corners(), picture);
  EXPECT_EQ(picture, boxAlone);
  both.draw(0, book(), picture);
  EXPECT_EQ(picture, bookAlone);
}

}  // namespace
}  // namespace rotatebook::render::testing
