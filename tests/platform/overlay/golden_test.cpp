// Pictures of each overlay over plain grey. ROTATEBOOK_UPDATE_GOLDENS=1 renews the goldens,
// see image/golden.h.
#include "image/golden.h"

#include <algorithm>
#include <ostream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "overlay/caption_and_clock.h"
#include "overlay/motion.h"

namespace rotatebook::overlay {
namespace {

// Letters and lines of other versions of the libraries differ in their edges. That many are 29 or
// 38 pixels of these pictures; the twin that differs least does in 63, that of the momentum.
constexpr image::Tolerance kOtherLibraries{.largest = 24, .failPercent = 0.05};

// Insets are larger there than on a wide picture of as many pixels.
constexpr const char* kPortrait = "clip.size=[240, 320]";

/// A frame that is compared, and one that must differ.
struct Case {
  const char* name;
  std::int64_t frame = 70;
  std::int64_t otherFrame = 74;
  std::vector<std::string> overrides{};
  bool isRigid = false;

  friend std::ostream& operator<<(std::ostream& stream, const Case& one) {
    return stream << one.name;
  }
};

scene::Scene sceneOf(const Case& one) {
  std::vector<std::string> overrides{"clip.size=[320, 180]",
                                     "overlay.show=['" + std::string(one.name) + "']"};
  for (const char* of : {"model='particles'", "integrator='verlet'", "stiffness=200"}) {
    if (!one.isRigid) overrides.push_back("simulation." + std::string(of));
  }
  overrides.insert(overrides.end(), one.overrides.begin(), one.overrides.end());
  return testing::tumbling(overrides);
}

image::Image pictureOf(const Case& one, std::int64_t frame) {
  const scene::Scene scene = sceneOf(one);
  image::Image picture = testing::drawn(scene, frame);
  CaptionAndClock(scene).draw(frame, picture);
  return picture;
}

image::Image movedByOnePixel(const image::Image& picture) {
  image::Image moved = picture;
  for (int y = 0; y < picture.height(); ++y) {
    std::copy(picture.row(y), picture.row(y) + picture.stride() - 4, moved.row(y) + 4);
  }
  return moved;
}

bool same(const Case& one, const image::Image& picture) {
  const image::Comparison found =
      image::compare(image::testing::golden(one.name).view(), picture.view(), kOtherLibraries);
  ::testing::Test::RecordProperty("differingPixels", std::to_string(found.differingPixels));
  return found.same;
}

class OverlayGolden : public ::testing::TestWithParam<Case> {};
class MovingOverlayGolden : public OverlayGolden {};

TEST_P(OverlayGolden, IsMatched) {
  const Case& one = GetParam();
  const image::Image picture = pictureOf(one, one.frame);
  if (image::testing::updatingGoldens()) image::testing::updateGolden(one.name, picture.view());
  const auto result = image::testing::matchesGolden(one.name, picture.view(), kOtherLibraries);
  EXPECT_TRUE(result) << result.message();
}

TEST_P(MovingOverlayGolden, IsNotMatchedAtAnotherTime) {
  EXPECT_FALSE(same(GetParam(), pictureOf(GetParam(), GetParam().otherFrame)));
}

TEST_P(OverlayGolden, IsNotMatchedWithoutIt) {
  EXPECT_FALSE(same(GetParam(), testing::greyPicture(sceneOf(GetParam()))));
}

TEST_P(OverlayGolden, IsNotMatchedOnePixelBeside) {
  EXPECT_FALSE(same(GetParam(), movedByOnePixel(pictureOf(GetParam(), GetParam().frame))));
}

std::string nameOf(const ::testing::TestParamInfo<Case>& test) {
  return test.param.name;
}

// Overlays that look the same at all times.
INSTANTIATE_TEST_SUITE_P(
    Still, OverlayGolden,
    ::testing::Values(
        Case{"caption",
             70,
             70,
             {"caption='In two lines, if it is long enough for them, as this one is.'"}},
        Case{"settings", 70, 70}),
    nameOf);

const auto kMoving = ::testing::Values(
    Case{"clock"}, Case{"axes"}, Case{"omega"}, Case{"momentum", 70, 90}, Case{"trail", 70, 90},
    Case{"polhode", 70, 90, {kPortrait}}, Case{"energy", 70, 110, {kPortrait}},
    Case{"error", 70, 140, {kPortrait}}, Case{"half_turns", 70, 150}, Case{"springs"},
    Case{"ghost"}, Case{"energy_ladder", 70, 90, {kPortrait}}, Case{"poinsot", 70, 74, {}, true},
    Case{"forces", 70, 74, {kPortrait, "camera.frame='turning'"}});
INSTANTIATE_TEST_SUITE_P(Each, OverlayGolden, kMoving, nameOf);
INSTANTIATE_TEST_SUITE_P(Each, MovingOverlayGolden, kMoving, nameOf);

}  // namespace
}  // namespace rotatebook::overlay
