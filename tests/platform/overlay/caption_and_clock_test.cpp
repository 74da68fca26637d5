#include "overlay/caption_and_clock.h"

#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "messages.h"
#include "overlay/motion.h"
#include "scene/scene_text.h"

namespace rotatebook::overlay {
namespace {

using ::testing::ElementsAre;

constexpr const char* kLongCaption =
    "The quaternion is normalised after every step, so the book keeps its shape, and it still goes "
    "wrong: each step adds a little energy. After a dozen seconds the book has stopped tumbling "
    "and "
    "spins fast about its long axis, for good. The exact motion from the same start tumbles on for "
    "ever.";

scene::Scene sceneWith(const std::vector<std::string>& overrides) {
  return scene::parseScene("title = \"A title\"\n[initial]\nangular_velocity = [5, 3, 1]\n",
                           "a.toml", overrides);
}

image::Image drawn(const scene::Scene& scene, std::int64_t frame) {
  image::Image picture(scene.clip.width, scene.clip.height, image::PixelFormat::Rgb8);
  CaptionAndClock(scene).draw(frame, picture);
  return picture;
}

// The rows that aren't black, first and one past the last.
struct Rows {
  int first = 0, end = 0;
};

Rows litRows(const image::Image& picture) {
  Rows rows{picture.height(), 0};
  for (int y = 0; y < picture.height(); ++y) {
    const auto* row = picture.row(y);
    bool lit = false;
    for (int i = 0; i < 3 * picture.width(); ++i) lit = lit || row[i] > 40;
    if (lit) rows = {std::min(rows.first, y), y + 1};
  }
  return rows;
}

TEST(CaptionAndClock, LeaveThePictureAloneIfNothingIsShown) {
  const scene::Scene scene = sceneWith({});
  EXPECT_EQ(drawn(scene, 3), image::Image(1280, 720, image::PixelFormat::Rgb8));
  EXPECT_EQ(CaptionAndClock(scene).bottomRows(), 0);
}

TEST(CaptionAndClock, HaveTheCaptionInTheRowsThatTheySay) {
  const scene::Scene scene = sceneWith({"overlay.show=['caption']", "caption='Some words.'"});
  const int rows = CaptionAndClock(scene).bottomRows();
  const Rows lit = litRows(drawn(scene, 0));
  EXPECT_GE(lit.first, 720 - rows);
  EXPECT_LT(lit.end, 720);
  EXPECT_GT(rows, 60);
  EXPECT_LT(rows, 200);
}

// On white, letters have a dark edge; above and between them nothing changes without the band.
TEST(CaptionAndClock, HaveNoGroundWithoutTheBand) {
  const auto onWhite = [](const std::string& band) {
    const scene::Scene scene =
        sceneWith({"overlay.show=['caption']", "caption='Some words.'", "overlay.band=" + band});
    image::Image picture(1280, 720, image::PixelFormat::Rgb8);
    for (int y = 0; y < 720; ++y) std::fill_n(picture.row(y), 3 * 1280, std::uint8_t{255});
    CaptionAndClock(scene).draw(0, picture);
    return picture;
  };
  const auto changed = [](const image::Image& picture) {
    return std::ranges::count_if(picture.bytes(), [](char value) { return value != '\xff'; });
  };
  const image::Image with = onWhite("true"), without = onWhite("false");
  EXPECT_LT(with.row(719)[3 * 1279], 120);  // measured 92
  EXPECT_EQ(without.row(719)[3 * 1279], 255);
  EXPECT_GT(changed(without), 1000);                // measured 12,975
  EXPECT_LT(20 * changed(without), changed(with));  // measured 652,800
  EXPECT_EQ(
      CaptionAndClock(sceneWith({"overlay.show=['caption']"})).bottomRows(),
      CaptionAndClock(sceneWith({"overlay.show=['caption']", "overlay.band=false"})).bottomRows());
}

TEST(CaptionAndClock, HaveAClockThatFollowsTheSimulatedTime) {
  const scene::Scene scene = sceneWith({"overlay.show=['clock']", "simulation.time_per_frame=0.5"});
  EXPECT_LT(litRows(drawn(scene, 0)).end, 72);
  EXPECT_NE(drawn(scene, 0), drawn(scene, 1));
  // The same moment and speed at twice the frame rate
  const scene::Scene finer =
      sceneWith({"overlay.show=['clock']", "clip.fps=120", "simulation.time_per_frame=0.25"});
  EXPECT_EQ(drawn(scene, 1), drawn(finer, 2));
}

// Outside of a stretch, and in real time, the clock is the same, whatever the stretch.
TEST(CaptionAndClock, SayTheSpeedWhereItIsNotReal) {
  const auto clockAt = [](const std::string& speed, std::int64_t frame,
                          const std::string& words = "english") {
    return drawn(sceneWith({"overlay.show=['clock']", "clip.fps=10", "clip.speed=" + speed,
                            "overlay.words=" + words}),
                 frame);
  };
  const std::string slowed = "[{ from = 2, to = 6, value = 0.5 }]";
  EXPECT_EQ(clockAt(slowed, 10), clockAt("1.0", 10));
  EXPECT_NE(clockAt(slowed, 40), clockAt("1.0", 30));  // both at 3 s
  EXPECT_EQ(clockAt(slowed, 40), clockAt("0.5", 60));
  EXPECT_NE(clockAt("0.5", 60), clockAt("0.25", 120));
  const std::string comma = "{ decimal_mark = ',' }";
  EXPECT_NE(clockAt("0.5", 60, comma), clockAt("2.0", 15, comma));
}

TEST(CaptionAndClock, HaveAClockThatRoundsToHundredths) {
  // At 1000 frames a second in real time, frame n is at n ms.
  const auto clockAt = [](std::int64_t milliseconds) {
    return drawn(sceneWith({"overlay.show=['clock']", "clip.size=[640, 360]", "clip.fps=1000"}),
                 milliseconds);
  };
  EXPECT_EQ(clockAt(166), clockAt(170));
  EXPECT_EQ(clockAt(174), clockAt(170));
  EXPECT_NE(clockAt(164), clockAt(170));
  EXPECT_NE(clockAt(176), clockAt(170));
}

// Clock above, caption below, at every size.
TEST(CaptionAndClock, NeverPutTextOnText) {
  for (const char* size : {"640, 360", "1280, 720", "1920, 1080", "3840, 2160", "480, 854"}) {
    const std::vector<std::string> common{std::string("clip.size=[") + size + "]",
                                          std::string("caption='") + kLongCaption + "'"};
    std::vector<std::string> clock = common, caption = common;
    clock.emplace_back("overlay.show=['clock']");
    caption.emplace_back("overlay.show=['caption']");
    const Rows above = litRows(drawn(sceneWith(clock), 100));
    const Rows below = litRows(drawn(sceneWith(caption), 100));
    EXPECT_LT(above.end, below.first) << size;
    EXPECT_GT(below.first, 0) << size;
  }
}

/// Texts that come after one second and after two.
std::vector<std::string> withCues(const std::string& first, const std::string& second) {
  return {"overlay.show=['caption', 'settings']", "caption=Before", "clip.fps=10",
          "cue=[{ at = 1, text = '" + first + "' }, { at = 2, text = '" + second + "' }]"};
}

TEST(CaptionAndClock, ShowEachCaptionUntilTheNext) {
  const auto with = [](const std::string& caption) {
    return drawn(sceneWith({"overlay.show=['caption', 'settings']", "caption=" + caption}), 0);
  };
  const scene::Scene scene = sceneWith(withCues("Now", ""));
  EXPECT_EQ(drawn(scene, 9), with("Before"));
  EXPECT_EQ(drawn(scene, 10), with("Now"));
  EXPECT_EQ(drawn(scene, 19), with("Now"));
  // The title and the settings stay where they are.
  const auto boxesAt = [&](std::int64_t frame) {
    CaptionAndClock captionAndClock(scene);
    image::Image picture(scene.clip.width, scene.clip.height, image::PixelFormat::Rgb8);
    captionAndClock.draw(frame, picture);
    return captionAndClock.texts();
  };
  const std::vector<Box> before = boxesAt(9), without = boxesAt(20);
  ASSERT_EQ(before.size(), 3U);
  ASSERT_EQ(without.size(), 2U);
  EXPECT_EQ(without[0].y, before[0].y);
  EXPECT_EQ(without[1].y, before[2].y);
}

// The clock stops with a motion that diverges, and captions go on.
TEST(CaptionAndClock, FollowTheFrameAndTheMotion) {
  std::vector<std::string> both = withCues("Now", "Then");
  both[0] = "overlay.show=['caption', 'clock']";
  const scene::Scene scene = sceneWith(both);
  image::Image stopped(scene.clip.width, scene.clip.height, image::PixelFormat::Rgb8);
  CaptionAndClock(scene).draw(25, 15, stopped);
  both.emplace_back("cue.0.text=Then");
  EXPECT_EQ(stopped, drawn(sceneWith(both), 15));
}

TEST(CaptionAndClock, KeepRoomForTheTallestCaption) {
  const int one = CaptionAndClock(sceneWith(withCues("Now", "Then"))).bottomRows();
  const int all = CaptionAndClock(sceneWith(withCues("Now", kLongCaption))).bottomRows();
  EXPECT_GT(all, one + 50);
  std::vector<std::string> alone = withCues("Now", "Then");
  alone[1] = std::string("caption=") + kLongCaption;
  EXPECT_EQ(CaptionAndClock(sceneWith(alone)).bottomRows(), all);
  // What is never shown takes no room.
  alone.emplace_back("cue.0.at=0");
  EXPECT_EQ(CaptionAndClock(sceneWith(alone)).bottomRows(), one);
  EXPECT_THAT(CaptionAndClock(sceneWith(withCues("Now", kLongCaption))).longCues(),
              ElementsAre(1U));
  EXPECT_THAT(CaptionAndClock(sceneWith(withCues("Now", "Then"))).longCues(), ::testing::IsEmpty());
}

TEST(CaptionAndClock, SayHowTheMotionWasSimulatedIfAsked) {
  const auto seen = [](const std::string& show, const std::string& model) {
    return drawn(sceneWith({"overlay.show=[" + show + "]", "simulation.model=" + model}), 0);
  };
  EXPECT_EQ(seen("'caption'", "quaternion"), seen("'caption'", "exact"));
  EXPECT_NE(seen("'settings'", "quaternion"), seen("'settings'", "exact"));
  EXPECT_NE(seen("'caption', 'settings'", "exact"), seen("'caption'", "exact"));
}

/// Returns the heights of the texts of a caption in one line at this size. [pixels]
std::vector<double> heightsOf(const std::string& size, const std::string& scale) {
  const scene::Scene scene =
      sceneWith({"overlay.show=['caption', 'settings']", "caption='Some words.'",
                 "clip.size=" + size, "overlay.scale=" + scale});
  CaptionAndClock captionAndClock(scene);
  image::Image picture(scene.clip.width, scene.clip.height, image::PixelFormat::Rgb8);
  captionAndClock.draw(0, picture);
  std::vector<double> heights;
  for (const Box& box : captionAndClock.texts()) heights.push_back(box.height);
  return heights;
}

// Inter's lines are 1.21 times as high as its letter size.
TEST(CaptionAndClock, HaveLettersThatAreLargeEnoughToRead) {
  for (const int rows : {360, 720, 2160}) {
    const auto size = "[" + std::to_string(rows / 9 * 16) + ", " + std::to_string(rows) + "]";
    const std::vector<double> heights = heightsOf(size, "1");
    ASSERT_EQ(heights.size(), 3U);
    EXPECT_GE(heights[0], 1.21 * 0.045 * rows - 1) << "title";
    EXPECT_GE(heights[1], 1.21 * 0.035 * rows - 1) << "caption";
    EXPECT_GE(heights[2], 1.21 * 0.022 * rows - 1) << "settings";
  }
}

TEST(CaptionAndClock, HaveLettersOfTheScale) {
  const std::vector<double> usual = heightsOf("[1280, 720]", "1");
  const std::vector<double> large = heightsOf("[1280, 720]", "2");
  for (std::size_t i = 0; i < usual.size(); ++i) EXPECT_NEAR(large[i], 2 * usual[i], 1.5) << i;
}

// Over a white page, as behind a book that has burst.
TEST(CaptionAndClock, CanBeReadOverWhite) {
  const scene::Scene scene = sceneWith(
      {"overlay.show=['caption', 'settings']", std::string("caption='") + kLongCaption + "'"});
  CaptionAndClock captionAndClock(scene);
  image::Image picture = testing::plainPicture(scene, 255);
  captionAndClock.draw(0, picture);
  ASSERT_EQ(captionAndClock.texts().size(), 3U);
  for (const Box& box : captionAndClock.texts()) {
    EXPECT_GE(testing::contrastOf(box, picture), 4.5);  // measured 4.78 to 6.14
  }
}

/// Returns the columns of `box` with light of its words, first and one past the last.
std::pair<int, int> litColumns(const Box& box, const image::Image& picture) {
  std::pair<int, int> columns{picture.width(), 0};
  for (int y = static_cast<int>(box.y); y < static_cast<int>(box.bottom()); ++y) {
    for (int x = 0; x < picture.width(); ++x) {
      if (picture.row(y)[3 * x] <= 40) continue;
      columns = {std::min(columns.first, x), std::max(columns.second, x + 1)};
    }
  }
  return columns;
}

// Each begins at the right margin, and all of it is seen.
TEST(CaptionAndClock, BeginAtTheRightInScriptsThatAreReadFromThere) {
  for (const std::string words : {"הציר שאינו מחזיק", "المحور الذي لا يثبت"}) {
    const scene::Scene scene =
        sceneWith({"overlay.show=['caption', 'settings', 'clock']", "overlay.font='DejaVu Sans'",
                   "title='" + words + "'", "caption='" + words + " 123 abc'"});
    CaptionAndClock captionAndClock(scene, CaptionAndClock::ClockPosition::Bottom);
    image::Image picture(scene.clip.width, scene.clip.height, image::PixelFormat::Rgb8);
    captionAndClock.draw(0, picture);
    const std::vector<Box>& texts = captionAndClock.texts();
    ASSERT_EQ(texts.size(), 4U);
    const Box& clock = texts[3];
    EXPECT_FALSE(clock.meets(texts[0]));
    EXPECT_LT(clock.right(), texts[0].x);
    for (std::size_t i = 1; i < 3; ++i) {
      const auto [first, end] = litColumns(texts[i], picture);
      EXPECT_EQ(texts[i].right(), texts[0].right());
      EXPECT_NEAR(first, texts[i].x, 8) << words;      // measured 1
      EXPECT_NEAR(end, texts[i].right(), 8) << words;  // measured 1
    }
  }
}

std::string sceneRefusal(const std::string& text) {
  try {
    CaptionAndClock captionAndClock(
        scene::parseScene(text + "\n[initial]\nangular_velocity = [5, 3, 1]\n", "a.toml"));
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

std::string repeated(const std::string& text, int times) {
  std::string all;
  for (int i = 0; i < times; ++i) all += text;
  return all;
}

TEST(CaptionAndClock, AreRefusedWhereTheyWouldHideTheBook) {
  const std::string show = "overlay.show = ['caption']\n";
  const std::string caption = "caption = '" + repeated("words on words ", 66) + "'\n";
  EXPECT_MESSAGE(sceneRefusal(show + caption + "clip.size = [128, 720]"));
  EXPECT_MESSAGE(
      sceneRefusal(show + "title = '" + repeated("a title ", 25) + "'\nclip.size = [64, 720]"));
  EXPECT_EQ(sceneRefusal(show + caption + "overlay.scale = 0.8"), "no error");
  EXPECT_MESSAGE(sceneRefusal(show + caption));
  EXPECT_EQ(sceneRefusal(show + caption + "clip.size = [320, 180]"), "no error");
}

TEST(CaptionAndClock, LeaveTheUpperHalfOfASmallPicture) {
  std::vector<std::size_t> counts;
  for (const char* size : {"[426, 240]", "[320, 180]", "[240, 160]", "[160, 90]", "[64, 36]"}) {
    const scene::Scene scene = sceneWith(
        {"overlay.show=['caption', 'settings']", "caption='" + std::string(kLongCaption) + "'",
         "title='Energy not corrected: the book spins up'", std::string("clip.size=") + size});
    image::Image picture = testing::plainPicture(scene, 17);
    CaptionAndClock all(scene);
    all.draw(0, picture);
    counts.push_back(all.texts().size());
    for (const Box& text : all.texts()) EXPECT_GE(text.y, scene.clip.height / 2) << size;
  }
  EXPECT_THAT(counts, ElementsAre(3, 2, 1, 1, 0)) << "title, caption, settings";
}

TEST(CaptionAndClock, NameThePlaceOfALetterOrAFontThatIsMissing) {
  const std::string show = "overlay.show = ['caption']\n";
  EXPECT_MESSAGE(sceneRefusal(show + "title = '漢'"));
  EXPECT_MESSAGE(sceneRefusal(show + "caption = '漢'"));
  EXPECT_MESSAGE(sceneRefusal(show + "overlay.font = 'No Such Font'"));
}

}  // namespace
}  // namespace rotatebook::overlay
