#include "render/renderer.h"

#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "render/drawing.h"

namespace rotatebook::render {
namespace {

using testing::book;
using testing::builtinTextures;
using testing::colourAt;
using testing::drawn;
using ::testing::HasSubstr;
using testing::kX;
using testing::kY;
using testing::settingsOf;

std::vector<body::Cage> someShapes() {
  return {book({{-35, kY}, {20, kX}}), testing::explodingBook(), book({{180, kY}}),
          testing::insideOutBook(), testing::skewedBook()};
}

std::vector<image::Image> drawAll(Renderer& renderer) {
  std::vector<image::Image> pictures;
  for (const auto& corners : someShapes()) pictures.push_back(drawn(renderer, corners));
  return pictures;
}

/// Returns the message with which `make` throws an `Expected`.
template <typename Expected, typename Make>
std::string messageOf(const Make& make) {
  try {
    make();
    return "no error";
  } catch (const Expected& error) {
    return error.what();
  }
}

TEST(Renderer, MakesOpaquePicturesOfItsSize) {
  Renderer renderer(settingsOf(130, 74), builtinTextures());
  const image::Image picture = drawn(renderer, book());
  EXPECT_EQ(picture.width(), 130);
  EXPECT_EQ(picture.height(), 74);
  ASSERT_EQ(picture.format(), image::PixelFormat::Rgba8);
  for (int y = 0; y < 74; ++y) {
    for (int x = 0; x < 130; ++x) ASSERT_EQ(picture.row(y)[4 * x + 3], 255);
  }
}

TEST(Renderer, DrawsTheSamePictureAgain) {
  Renderer renderer(settingsOf(128, 72), builtinTextures());
  const std::vector<image::Image> first = drawAll(renderer);
  EXPECT_EQ(drawAll(renderer), first);
  EXPECT_NE(first[0], first[2]);
}

TEST(Renderer, DrawsTheSamePicturesInAnyOrder) {
  Renderer renderer(settingsOf(128, 72), builtinTextures());
  const std::vector<image::Image> inOrder = drawAll(renderer);
  const std::vector<body::Cage> shapes = someShapes();
  for (const std::size_t i : {4U, 1U, 3U, 0U, 1U, 2U}) {
    EXPECT_EQ(drawn(renderer, shapes[i]), inOrder[i]) << "shape " << i;
  }
}

TEST(Renderer, DrawsTheSamePicturesAnew) {
  std::vector<image::Image> first;
  {
    Renderer renderer(settingsOf(128, 72), builtinTextures());
    first = drawAll(renderer);
  }
  Renderer renderer(settingsOf(128, 72), builtinTextures());
  EXPECT_EQ(drawAll(renderer), first);
}

TEST(Renderer, DrawsTheSamePicturesOnAnotherThread) {
  std::vector<image::Image> here, there;
  const auto draw = [](std::vector<image::Image>& pictures) {
    Renderer renderer(settingsOf(128, 72), builtinTextures());
    pictures = drawAll(renderer);
  };
  draw(here);
  std::thread([&] { draw(there); }).join();
  EXPECT_EQ(there, here);
}

TEST(Renderer, DrawsTheSamePictureOverAnyContent) {
  Renderer renderer(settingsOf(128, 72), builtinTextures());
  const image::Image fresh = drawn(renderer, book());
  image::Image used = drawn(renderer, testing::explodingBook());
  renderer.draw(book(), used);
  EXPECT_EQ(used, fresh);
}

TEST(Renderer, CanBeMoved) {
  Renderer renderer(settingsOf(128, 72), builtinTextures());
  const image::Image before = drawn(renderer, book());
  Renderer moved(std::move(renderer));
  EXPECT_EQ(drawn(moved, book()), before);
}

TEST(Renderer, DrawsNothingFromWithinTheBook) {
  RenderSettings settings = settingsOf(128, 72);
  settings.camera.position = {0, 0, 0.005};
  Renderer renderer(settings, builtinTextures());
  EXPECT_EQ(drawn(renderer, book()), testing::emptyPicture(renderer));
  settings.camera.position = {0, 0, 0.05};  // Just above the cover, which fills the picture.
  Renderer outside(settings, builtinTextures());
  EXPECT_NE(drawn(outside, book()), testing::emptyPicture(outside));
}

// The picture of a book that reaches behind the camera is only changed along its edges.
TEST(Renderer, SmoothsABookThatReachesBehindTheCamera) {
  const body::Cage corners = testing::explodingBook();
  Renderer renderer(settingsOf(256, 144), builtinTextures());
  DrawnBody raw = renderer.makeBody();
  renderer.draw(corners, raw);
  const image::Image picture = drawn(renderer, corners);
  int shown = 0, changed = 0;
  for (int y = 0; y < 144; ++y) {
    for (int x = 0; x < 256; ++x) {
      if (raw.pixels.row(y)[4 * x + 3] == 0) continue;
      ++shown;
      changed += colourAt(raw.pixels, x, y) == colourAt(picture, x, y) ? 0 : 1;
    }
  }
  EXPECT_GT(shown, 10'000);
  EXPECT_LT(changed, shown / 20);
}

TEST(Renderer, SaysWhatDraws) {
  const Renderer renderer(settingsOf(64, 36), builtinTextures());
  EXPECT_THAT(renderer.description(), HasSubstr("OpenGL "));
  EXPECT_THAT(renderer.description(), HasSubstr("EGL"));
}

// Neither sizes, covers nor the camera matter: parts of a clip are drawn with the same ones.
TEST(Renderer, DrawsATestFrameThatDependsOnWhatDrawsIt) {
  const std::string frame = Renderer(settingsOf(128, 72), builtinTextures()).testFrame();
  EXPECT_EQ(frame.size(), 32U);
  EXPECT_EQ(Renderer(settingsOf(128, 72), builtinTextures()).testFrame(), frame);
  RenderSettings other = settingsOf(128, 72);
  other.camera.position = {0.1, 0, 2};
  const image::Image cloth = plainCloth({1, 2, 3});
  EXPECT_EQ(Renderer(other, {cloth, cloth, cloth}).testFrame(), frame);
  other.background = Background::Stars;
  EXPECT_NE(Renderer(other, builtinTextures()).testFrame(), frame);
}

TEST(Renderer, DrawsTheSamePicturesAfterATestFrame) {
  Renderer renderer(settingsOf(128, 72), builtinTextures());
  const std::vector<image::Image> before = drawAll(renderer);
  const std::string frame = renderer.testFrame();
  EXPECT_EQ(drawAll(renderer), before);
  EXPECT_EQ(renderer.testFrame(), frame);
}

TEST(Renderer, CarriesCoversOfItsOwn) {
  for (const auto& picture : {builtinFront(), builtinSpine(), builtinBack()}) {
    EXPECT_GT(picture.width(), 64);
    EXPECT_GT(picture.height(), 4 * 64);
  }
  EXPECT_LT(4 * builtinSpine().width(), builtinSpine().height());
  EXPECT_NE(builtinFront(), builtinBack());
}

TEST(Renderer, RefusesATextureThatIsTooLarge) {
  constexpr int kTooLarge = 1 << 17;
  BookTextures textures = builtinTextures();
  textures.spine = image::Image(kTooLarge, 1, image::PixelFormat::Rgb8);
  const std::string message =
      messageOf<InputError>([&] { Renderer(settingsOf(64, 36), textures); });
  EXPECT_THAT(message,
              HasSubstr("a texture of 131072x1 pixels is too large: this renderer takes up to "));
}

TEST(Renderer, RefusesAPictureThatIsTooLarge) {
  const std::string message =
      messageOf<InputError>([] { Renderer(settingsOf(64, 1 << 17), builtinTextures()); });
  EXPECT_THAT(message,
              HasSubstr("a picture of 64x131072 is too large: this renderer draws up to "));
}

TEST(Renderer, WorksAfterOneThatFailed) {
  EXPECT_THROW(Renderer(settingsOf(64, 1 << 17), builtinTextures()), InputError);
  Renderer renderer(settingsOf(64, 36), builtinTextures());
  EXPECT_NE(drawn(renderer, book()), testing::emptyPicture(renderer));
}

}  // namespace
}  // namespace rotatebook::render
