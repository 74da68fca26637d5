// Pictures of the book. ROTATEBOOK_UPDATE_GOLDENS=1 renews the goldens, see golden.h.
#include "image/golden.h"

#include <filesystem>
#include <numbers>
#include <ostream>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "render/drawing.h"

namespace rotatebook::render {
namespace {

using testing::book;
using testing::kX;
using testing::kY;
using testing::kZ;

// The software rasteriser with vectors of 128 and 256 bits and 0, 1 and 3 threads: measured 0. The
// rest is for other versions of it.
constexpr image::Tolerance kSameMachineKind{.largest = 3, .failPercent = 0.5};

struct Pose {
  std::string name;
  body::Cage corners;
  RenderSettings settings = testing::settingsOf(128, 72);
};

/// Views for judging the look, larger: the book turned about x, then y, then z [rad], before a
/// camera that stands near.
Pose view(const std::string& name, const Eigen::Vector3d& angles) {
  const Eigen::Vector3d degrees = angles * 180 / std::numbers::pi;
  RenderSettings settings = testing::settingsOf(640, 360);
  settings.camera = {{0, 0, 0.76}, {0, 0, 0}, {0, 1, 0}, 30};
  return {name, book({{degrees.x(), kX}, {degrees.y(), kY}, {degrees.z(), kZ}}), settings};
}

void PrintTo(const Pose& pose, std::ostream* stream) {
  *stream << pose.name;
}

image::Image redAndBlueSwapped(image::Image picture) {
  for (int y = 0; y < picture.height(); ++y) {
    for (int x = 0; x < picture.width(); ++x) {
      auto* pixel = picture.row(y) + 4 * x;
      std::swap(pixel[0], pixel[2]);
    }
  }
  return picture;
}

class Golden : public ::testing::TestWithParam<Pose> {
 protected:
  image::Image draw(const body::Cage& corners) { return testing::drawn(renderer_, corners); }

  static bool same(const std::string& name, const image::Image& picture) {
    return image::compare(image::testing::golden(name).view(), picture.view(), kSameMachineKind)
        .same;
  }

  Renderer renderer_{GetParam().settings, testing::builtinTextures()};
};

TEST_P(Golden, IsMatched) {
  const image::Image picture = draw(GetParam().corners);
  if (image::testing::updatingGoldens())
    image::testing::updateGolden(GetParam().name, picture.view());
  const auto result =
      image::testing::matchesGolden(GetParam().name, picture.view(), kSameMachineKind);
  EXPECT_TRUE(result);
  RecordProperty("comparison", result.message());
}

TEST_P(Golden, IsNotMatchedByABookTurnedByOneDegree) {
  for (const Eigen::Vector3d& axis : {kX, kY, kZ}) {
    const body::Cage corners = testing::turned(GetParam().corners, {{1, axis}});
    EXPECT_FALSE(same(GetParam().name, draw(corners))) << "turned about " << axis.transpose();
  }
}

TEST_P(Golden, IsNotMatchedWithRedAndBlueSwapped) {
  EXPECT_FALSE(same(GetParam().name, redAndBlueSwapped(draw(GetParam().corners))));
}

INSTANTIATE_TEST_SUITE_P(Poses, Golden,
                         ::testing::Values(Pose{"front", book()}, Pose{"back", book({{180, kY}})},
                                           Pose{"spine", book({{80, kY}})},
                                           Pose{"three_quarter", book({{-35, kY}, {20, kX}})},
                                           Pose{"head", book({{-20, kY}, {65, kX}})},
                                           Pose{"fore_edge", book({{-70, kY}, {-15, kX}})},
                                           Pose{"skewed", testing::skewedBook()},
                                           Pose{"inside_out", testing::insideOutBook()},
                                           Pose{"exploding", testing::explodingBook()},
                                           view("cover_and_spine", {-0.5, 0.55, 0.12}),
                                           view("cover_and_edges", {0.9, -0.7, 0.3}),
                                           view("fore_edge_upright", {-0.35, -1.15, 0.2}),
                                           view("head_and_cover", {1.25, 0.15, -0.4})),
                         [](const auto& test) { return test.param.name; });

TEST(GoldenFailure, LeavesThePictureTheDifferenceAndTheirPaths) {
  const std::filesystem::path actual = image::testing::leftovers("front", "actual");
  const std::filesystem::path difference = image::testing::leftovers("front", "difference");
  std::filesystem::remove(actual);
  std::filesystem::remove(difference);
  const image::Image wrong = testing::plain(128, 72, {200, 0, 0});
  const auto result = image::testing::matchesGolden("front", wrong.view(), kSameMachineKind);
  EXPECT_FALSE(result);
  const std::string message = result.message();
  EXPECT_NE(message.find(actual.string()), std::string::npos) << message;
  EXPECT_NE(message.find(difference.string()), std::string::npos) << message;
  EXPECT_TRUE(std::filesystem::remove(actual));
  EXPECT_TRUE(std::filesystem::remove(difference));
}

TEST(GoldenFailure, NamesAMissingGolden) {
  const image::Image picture = testing::plain(8, 8, {1, 2, 3});
  const auto result =
      image::testing::matchesGolden("no_such_golden", picture.view(), kSameMachineKind);
  EXPECT_FALSE(result);
  EXPECT_NE(std::string(result.message()).find("no_such_golden.png"), std::string::npos);
  EXPECT_TRUE(std::filesystem::remove(image::testing::leftovers("no_such_golden", "actual")));
}

}  // namespace
}  // namespace rotatebook::render
