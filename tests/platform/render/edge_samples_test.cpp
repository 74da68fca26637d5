#include "render/antialias/edge_samples.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "image/srgb_formula.h"

namespace rotatebook::render {
namespace {

constexpr std::uint8_t kOne = 1, kTwo = 2, kThree = 3;  // surfaces
using Pixel = std::array<std::uint8_t, 4>;
constexpr Pixel kWhite{255, 255, 255, kOne}, kRed{255, 0, 0, kTwo}, kNothing{0, 0, 0, 0};

image::Image filled(const Pixel& pixel) {
  image::Image picture(8, 8, image::PixelFormat::Rgba8);
  for (int y = 0; y < 8; ++y) {
    for (int x = 0; x < 8; ++x) std::ranges::copy(pixel, picture.row(y) + 4 * x);
  }
  return picture;
}

Pixel at(const image::Image& picture, int x, int y) {
  Pixel pixel{};
  std::copy_n(picture.row(y) + 4 * x, 4, pixel.begin());
  return pixel;
}

std::uint8_t shareOfWhite(double share) {
  return image::srgbFromLinear(share);
}

/// A triangle that covers what is left of `edge`, at a depth.
ScreenTriangle leftOf(float edge, std::uint8_t surface, float depth = 0.5F) {
  return {{Eigen::Vector3f(edge, -100, depth), {edge, 100, depth}, {-1000, 0, depth}},
          static_cast<float>(surface)};
}

struct Scene {
  image::Image drawn = filled(kNothing);
  image::Image background = filled({0, 0, 0, 255});
  std::vector<ScreenTriangle> triangles;
  AlikeSurfaces alike{};

  /// The picture, with all of columns 3 and 4 among the edges.
  image::Image resolve() {
    EdgePixels pixels(8, 8);
    pixels.addLine({3.5F, 0}, {3.5F, 8});
    pixels.addLine({4.5F, 0}, {4.5F, 8});
    pixels.number();
    image::Image picture = background;
    for (int y = 0; y < 8; ++y) {
      for (int x = 0; x < 8; ++x) {
        const Pixel pixel = at(drawn, x, y);
        if (pixel[3] != 0)
          std::ranges::copy(Pixel{pixel[0], pixel[1], pixel[2], 255}, picture.row(y) + 4 * x);
      }
    }
    EdgeSamples(alike).resolve(pixels, triangles, drawn, {}, background, picture.from(0, 0));
    return picture;
  }

  void drawColumns(int from, int to, const Pixel& pixel) {
    for (int y = 0; y < 8; ++y) {
      for (int x = from; x < to; ++x) std::ranges::copy(pixel, drawn.row(y) + 4 * x);
    }
  }
};

TEST(EdgeSamples, GiveAPixelItsShareOfLight) {
  for (const int sixteenths : {1, 4, 8, 11, 15}) {
    Scene scene;
    const float edge = 3 + static_cast<float>(sixteenths) / 16;
    scene.drawColumns(0, sixteenths > 8 ? 4 : 3, kWhite);
    scene.triangles = {leftOf(edge, kOne)};
    const image::Image picture = scene.resolve();
    const std::uint8_t share = shareOfWhite(sixteenths / 16.0);
    EXPECT_EQ(at(picture, 3, 4), (Pixel{share, share, share, 255})) << sixteenths;
    EXPECT_EQ(at(picture, 2, 4), (Pixel{255, 255, 255, 255}));
    EXPECT_EQ(at(picture, 4, 4), (Pixel{0, 0, 0, 255}));
  }
}

constexpr int kSize = 64;  // of a picture all of whose pixels are among the edges

/// Returns a transparent picture with the triangle, white.
image::Image drawnAlone(const ScreenTriangle& triangle) {
  image::Image drawn(kSize, kSize, image::PixelFormat::Rgba8);
  std::ranges::copy(kWhite, drawn.row(40));  // So that there is a colour to mix.
  EdgePixels pixels(kSize, kSize);
  for (int y = 0; y < kSize; ++y) {
    const float middle = static_cast<float>(y) + 0.5F;
    pixels.addLine({0, middle}, {kSize, middle});
  }
  pixels.number();
  image::Image picture(kSize, kSize, image::PixelFormat::Rgba8);
  EdgeSamples({}).resolve(pixels, {&triangle, 1}, drawn, {}, picture, picture.from(0, 0));
  return picture;
}

// From the side all corners of a triangle lie on a line, but for rounding, by which the whole row
// to the right of this one lies within its three edges. From a clip of an hour.
TEST(EdgeSamples, StayWithinATriangleSeenFromItsSide) {
  const image::Image picture = drawnAlone({{Eigen::Vector3f(25.7919579F, 25.761055F, 0.5F),
                                            {25.9701672F, 25.7609348F, 0.5F},
                                            {25.7684898F, 25.7610703F, 0.5F}},
                                           kOne});
  for (int y = 0; y < kSize; ++y) {
    for (int x = 0; x < kSize; ++x) {
      if (x == 25 && y == 25) continue;
      EXPECT_EQ(at(picture, x, y), kNothing) << x << ", " << y;
    }
  }
}

// Half of the box around a racket's string was white, wherever an edge was.
TEST(EdgeSamples, StayBesideALongTriangleSeenFromItsSide) {
  for (int i = 0; i < 100; ++i) {
    const float shift = 0.07F * static_cast<float>(i);
    const Eigen::Vector3f a(2.3F + shift, 61 - shift, 0.5F), b(50 + shift, 3.7F, 0.5F);
    const Eigen::Vector3f c = a + 0.37F * (b - a);
    const image::Image picture = drawnAlone({{a, b, c}, kOne});
    const Eigen::Vector2f along = (b - a).head<2>().normalized();
    for (int y = 0; y < kSize; ++y) {
      for (int x = 0; x < kSize; ++x) {
        const Eigen::Vector2f from = Eigen::Vector2i(x, y).cast<float>() - a.head<2>();
        if (std::abs(along.x() * from.y() - along.y() * from.x()) < 2) continue;
        ASSERT_EQ(at(picture, x, y), kNothing) << i << ": " << x << ", " << y;
      }
    }
  }
}

TEST(EdgeSamples, GiveTransparentPicturesTheShareAsAlpha) {
  Scene scene;
  scene.background = filled(kNothing);
  scene.drawColumns(0, 3, kWhite);
  scene.triangles = {leftOf(3.25F, kOne)};
  EXPECT_EQ(at(scene.resolve(), 3, 4), (Pixel{255, 255, 255, 64}));  // 255 / 4
}

TEST(EdgeSamples, SeeTheNearestSurface) {
  Scene scene;
  scene.drawColumns(0, 3, kWhite);
  scene.drawColumns(3, 8, kRed);
  const ScreenTriangle near = leftOf(3.25F, kOne, 0.2F), far = leftOf(100, kTwo, 0.7F);
  const std::uint8_t quarter = shareOfWhite(0.25);
  for (const auto& triangles : {std::vector{near, far}, std::vector{far, near}}) {
    scene.triangles = triangles;
    EXPECT_EQ(at(scene.resolve(), 3, 4), (Pixel{255, quarter, quarter, 255}));
  }
}

// The mean of the numbers of the second and the third is the first's.
TEST(EdgeSamples, CountThreeSurfacesInAPixel) {
  Scene scene;
  scene.drawColumns(0, 3, kRed);
  scene.drawColumns(3, 4, kWhite);
  scene.drawColumns(4, 8, {0, 0, 255, kThree});
  scene.triangles = {leftOf(3.5F, kTwo, 0.1F), leftOf(3.75F, kOne, 0.2F), leftOf(100, kThree)};
  const Pixel expected{shareOfWhite(0.75), shareOfWhite(0.25), shareOfWhite(0.5), 255};
  EXPECT_EQ(at(scene.resolve(), 3, 4), expected);
}

TEST(EdgeSamples, FollowDepthThatChangesWithinAPixel) {
  Scene scene;
  scene.drawColumns(0, 4, kWhite);
  scene.drawColumns(4, 8, kRed);
  // The first lies in front up to x = 3.75.
  scene.triangles = {
      {{Eigen::Vector3f(-96.25F, -100, -1), {103.75F, -100, 1}, {3.75F, 300, 0}}, kOne},
      leftOf(100, kTwo, 0)};
  const std::uint8_t share = shareOfWhite(0.75);
  EXPECT_EQ(at(scene.resolve(), 3, 4), (Pixel{255, share, share, 255}));
}

// A strip between the pixels' middles is seen two columns away.
TEST(EdgeSamples, FindColoursCloseBy) {
  Scene scene;
  scene.drawColumns(0, 2, kWhite);
  scene.drawColumns(2, 8, kRed);
  scene.triangles = {leftOf(3.25F, kOne, 0.2F), leftOf(100, kTwo)};
  const std::uint8_t quarter = shareOfWhite(0.25);
  EXPECT_EQ(at(scene.resolve(), 3, 4), (Pixel{255, quarter, quarter, 255}));
}

TEST(EdgeSamples, TakeAnotherSurfaceForOneThatIsNowhereDrawn) {
  Scene scene;
  scene.drawColumns(0, 8, kRed);
  scene.triangles = {leftOf(3.25F, kOne, 0.2F), leftOf(100, kTwo)};
  EXPECT_EQ(at(scene.resolve(), 3, 4), (Pixel{255, 0, 0, 255}));
}

// As a string beside a racket's frame, between the pixels' middles.
TEST(EdgeSamples, TakeAnotherSurfaceOfTheMaterialForOneThatIsNowhereDrawn) {
  Scene scene;
  scene.drawColumns(0, 8, kRed);
  std::ranges::copy(Pixel{255, 255, 255, kThree}, scene.drawn.row(0) + 4 * 4);
  scene.alike = {0, kOne, kTwo, kOne};
  scene.triangles = {leftOf(3.25F, kOne, 0.2F), leftOf(100, kTwo)};
  const std::uint8_t quarter = shareOfWhite(0.25);
  EXPECT_EQ(at(scene.resolve(), 3, 7), (Pixel{255, quarter, quarter, 255}));
}

TEST(EdgeSamples, TakeTheColourOfTheBodyWhereNothingIsDrawnCloseBy) {
  Scene scene;
  std::ranges::copy(kRed, scene.drawn.row(0) + 4 * 4);
  scene.triangles = {leftOf(3.25F, kOne)};
  EXPECT_EQ(at(scene.resolve(), 3, 7), (Pixel{shareOfWhite(0.25), 0, 0, 255}));
}

TEST(EdgeSamples, LeavePixelsThatTheTrianglesDoNotExplain) {
  Scene scene;
  scene.drawColumns(0, 8, kRed);
  EXPECT_EQ(at(scene.resolve(), 3, 4), (Pixel{255, 0, 0, 255}));
}

TEST(EdgeSamples, LeaveOutTrianglesFarBesideThePicture) {
  Scene scene;
  scene.drawColumns(0, 8, kRed);
  scene.triangles = {
      {{Eigen::Vector3f(0, 3e9F, 0), {10, 3e9F, 0}, {0, 4e9F, 0}}, kOne},
      {{Eigen::Vector3f(3e9F, 0, 0), {4e9F, 8, 0}, {3e9F, 8, 0}}, kOne},
      {{Eigen::Vector3f(-1e10F, -1e10F, 0), {1e10F, -1e10F, 0}, {0, 1e10F, 0}}, kTwo}};
  EXPECT_EQ(at(scene.resolve(), 3, 4), (Pixel{255, 0, 0, 255}));
}

TEST(EdgeSamples, LeaveAllOtherPixels) {
  Scene scene;
  scene.drawColumns(0, 3, kWhite);
  scene.triangles = {leftOf(5.5F, kOne)};
  EXPECT_EQ(at(scene.resolve(), 5, 4), (Pixel{0, 0, 0, 255}));
}

}  // namespace
}  // namespace rotatebook::render
