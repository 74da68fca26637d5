#include "overlay/arrow_labels.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "overlay/arrows.h"
#include "overlay/caption_and_clock.h"
#include "overlay/motion.h"
#include "scene/reference_frame.h"
#include "scene/shipped_scene.h"

namespace rotatebook::overlay {
namespace {

namespace fs = std::filesystem;

Layer letterOf(int width, int height) {
  Layer layer{0, 0, width, height, {}};
  layer.pixels.assign(static_cast<std::size_t>(width * height * 4), 200);
  return layer;
}

constexpr Box kPicture{0, 0, 200, 200};

ArrowShape arrowTo(const Point& tip, const Point& from = {100, 100}) {
  return {from, tip, from, 4, 16, 13};
}

/// An arrow without a head.
ArrowShape line(const Point& from, const Point& to) {
  return {from, to, from, 4, 0, 0};
}

std::vector<LabelledArrow> labelled(const std::vector<ArrowShape>& shapes, const Layer& letter,
                                    Side side) {
  std::vector<LabelledArrow> arrows;
  for (const ArrowShape& shape : shapes) arrows.push_back({shape, &letter, 15, {side, 0}});
  return arrows;
}

/// Places letters of 10 x 12 pixels, 15 pixels ahead of the arrows; all give way to the right.
std::vector<ArrowLabels::Placed> placed(const std::vector<ArrowShape>& arrows,
                                        const std::vector<Box>& taken = {},
                                        Side side = Side::Right) {
  Canvas canvas(200, 200);
  const Layer letter = letterOf(10, 12);
  ArrowLabels labels(kPicture, taken, 0, 0);
  labels.place(0, [&](std::int64_t) { return labelled(arrows, letter, side); });
  labels.write(canvas);
  EXPECT_EQ(canvas.texts().size(), labels.placed().size());
  return labels.placed();
}

double middle(const Box& box) {
  return box.x + box.width / 2;
}

TEST(LengthWithin, IsWhatLiesInTheBox) {
  const ArrowShape across = line({0, 50}, {100, 50});
  EXPECT_NEAR(lengthWithin(Box{20, 40, 30, 20}, across), 30, 1e-12);
  EXPECT_EQ(lengthWithin(Box{20, 51, 30, 20}, across), 0);
  EXPECT_EQ(lengthWithin(Box{110, 40, 30, 20}, across), 0);
  EXPECT_GT(lengthWithin(Box{85, 45, 3, 3}, arrowTo({100, 50}, {0, 50})), 0);  // in its head
}

TEST(ArrowLabels, AreAheadOfTheirArrows) {
  const auto all = placed({arrowTo({150, 100}), arrowTo({100, 50})});
  ASSERT_EQ(all.size(), 2U);
  EXPECT_EQ(all[0].box.x, 160);
  EXPECT_EQ(all[0].box.y, 94);
  EXPECT_EQ(all[1].box.x, 95);
  EXPECT_EQ(all[1].box.y, 29);
}

TEST(ArrowLabels, MakeRoomForAnArrowThatIsLonger) {
  const std::vector<ArrowShape> arrows{arrowTo({100, 20}), arrowTo({100, 50})};
  for (const Side side : {Side::Right, Side::Left}) {
    const auto all = placed(arrows, {}, side);
    ASSERT_EQ(all.size(), 2U);
    EXPECT_EQ(lengthWithin(all[1].ink, arrows[0]), 0);
    EXPECT_EQ(middle(all[1].box) > 100, side == Side::Right);
  }
}

TEST(ArrowLabels, StayOnTheirSideWhileTheArrowsNearlyCoincide) {
  const auto isRight = [](double tip) {
    const ArrowShape other = arrowTo({tip, 20});
    const auto all = placed({other, arrowTo({100, 50})});
    EXPECT_EQ(lengthWithin(all[1].ink, other), 0) << tip;
    return middle(all[1].box) > 100;
  };
  for (const double tip : {90., 95., 99.9, 100., 100.1, 105.}) EXPECT_TRUE(isRight(tip)) << tip;
  EXPECT_FALSE(isRight(120));
}

TEST(ArrowLabels, ComeIntoTheWayOfNothingStepByStep) {
  // A long arrow nears that of the letter, which moves by no more than this from one to the next.
  constexpr double kStep = 0.25, kMaxMoved = 2.5;  // [pixels]; measured 1.0
  Point last(0, 0);
  for (double tip = 30; tip < 104; tip += kStep) {
    const Box box = placed({arrowTo({tip, 20}), arrowTo({100, 50})})[1].box;
    const Point here(box.x, box.y);
    if (tip > 30) {
      EXPECT_LT((here - last).norm(), kMaxMoved) << tip;
    }
    last = here;
  }
}

TEST(ArrowLabels, MakeRoomForThoseAfterThemAndForWhatIsTaken) {
  const Box taken{90, 20, 20, 20};
  const auto all = placed(std::vector<ArrowShape>(4, arrowTo({100, 50})), {taken});
  std::vector<Box> boxes{taken};
  for (const auto& one : all) boxes.push_back(one.box);
  EXPECT_EQ(boxes.size(), 5U);
  EXPECT_EQ(testing::meeting(boxes), "");
}

TEST(ArrowLabels, CrossAnArrowRatherThanVanish) {
  std::vector<ArrowShape> fan{arrowTo({100, 60}, {100, 65})};
  for (int i = 0; i < 60; ++i) fan.push_back(line({0, 3.5 * i}, {200, 3.5 * i}));
  const auto all = placed(fan);
  ASSERT_FALSE(all.empty());
  EXPECT_EQ(all.front().arrow, 0U);
}

TEST(ArrowLabels, AreLeftOutWhereThereIsNoRoom) {
  EXPECT_TRUE(placed({arrowTo({100, 50})}, {{50, 0, 100, 100}}).empty());
  EXPECT_TRUE(placed({arrowTo({300, 50})}).empty());
}

TEST(ArrowLabels, GlideToTheOtherSideWhileAnArrowPasses) {
  // It passes at once, between frames 9 and 10.
  constexpr std::int64_t kReach = 4;
  constexpr double kMaxMoved = 12;  // [pixels]; measured 9.7, and 48 without its neighbours
  const Layer letter = letterOf(10, 12);
  const auto arrowsAt = [&](std::int64_t frame) {
    return labelled({arrowTo({frame < 10 ? 60. : 140., 20}), arrowTo({100, 50})}, letter,
                    Side::Right);
  };
  const auto pathOf = [&](std::int64_t reach, bool forward) {
    ArrowLabels labels(kPicture, {}, 19, reach);
    std::vector<double> path(20);
    for (std::int64_t i = 0; i < 20; ++i) {
      const std::int64_t frame = forward ? i : 19 - i;
      labels.place(frame, arrowsAt);
      path[static_cast<std::size_t>(frame)] = labels.placed()[1].box.x;
    }
    return path;
  };
  const std::vector<double> path = pathOf(kReach, true);
  EXPECT_EQ(path, pathOf(kReach, false));  // whatever was drawn before
  for (std::size_t i = 1; i < path.size(); ++i) {
    EXPECT_LT(std::abs(path[i] - path[i - 1]), kMaxMoved) << i;
  }
  EXPECT_EQ(path.front(), pathOf(0, true).front());
  EXPECT_EQ(path.back(), pathOf(0, true).back());
}

/// Measures of a clip's letters, over all its frames.
struct Seen {
  int frames = 0;
  int missing = 0;         // letters that found no place
  int meeting = 0;         // frames in which two letters' boxes meet
  int crossed = 0;         // frames in which an arrow goes through another's letter
  int longestCrossed = 0;  // of them, one after the other
  int plainlyCrossed = 0;  // frames in which one would, if all letters were straight ahead
  double fastest = 0;      // that a letter moves about its arrow from a frame to the next [pixels]
};

/// The letters of one frame, each by its arrow, and the arrows.
struct Frame {
  std::vector<LabelledArrow> arrows;
  std::vector<ArrowLabels::Placed> letters;
};

class Clip {
 public:
  explicit Clip(const scene::Scene& asked)
      : scene_(asked),
        trajectory_(testing::motionOf(scene_)),
        captionAndClock_(scene_),
        scale_(scene_.clip.width, scene_.clip.height),
        overlays_(scene_, trajectory_,
                  {.width = scene_.clip.width,
                   .height = scene_.clip.height,
                   .corner = captionAndClock_.corner(),
                   .bottomRows = captionAndClock_.bottomRows()}) {}

  Seen seen() {
    Seen seen;
    Frame last;
    const Eigen::Matrix4d clip = testing::clipFromWorld(scene_, overlays_.bottomRows());
    for (std::size_t n = 0; n < trajectory_.samples.size(); ++n) {
      const ArrowLabels& labels = overlays_.placeLetters(static_cast<std::int64_t>(n), clip);
      Frame frame{labels.arrows(), labels.placed()};
      add(frame, last, seen);
      last = std::move(frame);
    }
    return seen;
  }

 private:
  static bool isCrossed(const Box& ink, std::size_t own, const Frame& frame) {
    for (std::size_t i = 0; i < frame.arrows.size(); ++i) {
      if (i != own && lengthWithin(ink, frame.arrows[i].shape) > 0) return true;
    }
    return false;
  }

  /// `letter` with its middle straight ahead of its arrow.
  Box ahead(const ArrowLabels::Placed& letter, const ArrowShape& arrow) const {
    const Point along = (arrow.tip - arrow.from).normalized();
    const Point corner = arrow.tip + along * 0.85 * scale_.letters -
                         Point(letter.box.width / 2, letter.box.height / 2);
    Box ink = letter.ink;
    ink.x += corner.x() - letter.box.x;
    ink.y += corner.y() - letter.box.y;
    return ink;
  }

  /// Of a letter's middle from its tip, along its arrow and to the right. [pixels]
  static Point offset(const ArrowLabels::Placed& letter, const Frame& frame) {
    const ArrowShape& arrow = frame.arrows[letter.arrow].shape;
    const Point along = (arrow.tip - arrow.from).normalized();
    const Point off =
        Point(letter.box.x + letter.box.width / 2, letter.box.y + letter.box.height / 2) -
        arrow.tip;
    return {off.dot(along), off.dot(Point(-along.y(), along.x()))};
  }

  void add(const Frame& frame, const Frame& last, Seen& seen) {
    ++seen.frames;
    seen.missing += static_cast<int>(frame.arrows.size() - frame.letters.size());
    std::vector<Box> boxes;
    bool crossed = false, plainly = false;
    for (const auto& letter : frame.letters) {
      boxes.push_back(letter.box);
      crossed = isCrossed(letter.ink, letter.arrow, frame) || crossed;
      plainly = isCrossed(ahead(letter, frame.arrows[letter.arrow].shape), letter.arrow, frame) ||
                plainly;
      for (const auto& before : last.letters) {
        if (before.arrow != letter.arrow) continue;
        const Point moved = offset(letter, frame) - offset(before, last);
        seen.fastest = std::max(seen.fastest, moved.norm());
      }
    }
    seen.meeting += testing::meeting(boxes).empty() ? 0 : 1;
    seen.crossed += crossed ? 1 : 0;
    atAStretch_ = crossed ? atAStretch_ + 1 : 0;
    seen.longestCrossed = std::max(seen.longestCrossed, atAStretch_);
    seen.plainlyCrossed += plainly ? 1 : 0;
  }

  scene::Scene scene_;
  physics::Trajectory trajectory_;
  CaptionAndClock captionAndClock_;
  Scale scale_;
  MotionOverlays overlays_;
  int atAStretch_ = 0;  // frames up to the last in which a letter is crossed
};

/// A scene that ships and shows arrows, and how many frames of it at least need letters that give
/// way.
struct Shown {
  const char* name;
  int plainlyCrossed;
};

// While an arrow passes another's letter, which is glided over within a tenth of a second.
constexpr int kLongestCrossed = 5;       // [frames]; measured 4
constexpr double kMaxCrossed = 0.08;     // of all frames; measured 0.069, in figa-exact
constexpr double kFastestLetter = 12.0;  // [pixels a frame]; measured 10.3, in fig03

TEST(ArrowLabels, OfTheFiguresMeetNothing) {
  for (const Shown& one : {Shown{"figures/fig03-stable-z", 756},            // measured 756
                           Shown{"figures/fig04-stable-y", 756},            // measured 756
                           Shown{"figures/fig05-unstable-x", 350},          // measured 364
                           Shown{"figures/fig05b-rounding-only", 920},      // measured 957
                           Shown{"figures/fig09-matrix", 340},              // measured 355
                           Shown{"figures/fig09b-matrix-large-step", 250},  // measured 260
                           Shown{"figures/figa-exact", 480},                // measured 509
                           Shown{"comparisons/axes", 0}}) {
    const scene::Scene whole = scene::shippedScene(one.name);
    for (const scene::Panel& motion : whole.motions) {
      SCOPED_TRACE(one.name);
      const Seen seen = Clip(scene::withMotion(whole, motion)).seen();
      EXPECT_EQ(seen.missing, 0);
      EXPECT_EQ(seen.meeting, 0);
      EXPECT_LE(seen.longestCrossed, kLongestCrossed);
      EXPECT_LE(seen.crossed, kMaxCrossed * seen.frames);
      EXPECT_LT(seen.fastest, kFastestLetter);
      EXPECT_GE(seen.plainlyCrossed, one.plainlyCrossed);
    }
  }
}

}  // namespace
}  // namespace rotatebook::overlay
