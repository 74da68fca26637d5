#include "pipeline/verify/stream_checks.h"

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scene/small_scene.h"

namespace rotatebook::pipeline {
namespace {

using scene::testing::smallScene;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using video::VideoFormat;

TEST(StreamChecks, KnowTheColoursAndTheCodec) {
  const scene::Scene scene = smallScene();
  const video::ColourTags bt709{"bt709", "bt709", "bt709", "tv"};
  video::ClipFacts facts{.title = scene.title,
                         .width = 64,
                         .height = 36,
                         .codec = "h264",
                         .profile = "High",
                         .pixelFormat = "yuv420p",
                         .colours = bt709,
                         .containerColours = bt709,
                         .pixelShape = "1:1",
                         .containerShape = "1:1",
                         .display = "as stored",
                         .duration = 0.5};
  const auto failed = [&](const video::ClipFacts& changed) {
    std::vector<std::string> names;
    for (const ClipCheck& check : checkStream(changed, scene)) {
      if (!check.passed) names.push_back(check.what);
    }
    return names;
  };
  EXPECT_THAT(failed(facts), IsEmpty());
  for (std::string video::ColourTags::*field :
       {&video::ColourTags::primaries, &video::ColourTags::transfer, &video::ColourTags::matrix,
        &video::ColourTags::range}) {
    video::ClipFacts changed = facts;
    changed.colours.*field = "unknown";
    EXPECT_THAT(failed(changed), ElementsAre("colours"));
    changed = facts;
    changed.containerColours.*field = "unknown";
    EXPECT_THAT(failed(changed), ElementsAre("container"));
  }
  for (std::string video::ClipFacts::*field :
       {&video::ClipFacts::pixelShape, &video::ClipFacts::containerShape}) {
    video::ClipFacts changed = facts;
    changed.*field = "4:3";
    EXPECT_THAT(failed(changed), ElementsAre("pixel shape"));
  }
  for (std::string video::ClipFacts::*field :
       {&video::ClipFacts::codec, &video::ClipFacts::profile, &video::ClipFacts::pixelFormat}) {
    video::ClipFacts changed = facts;
    changed.*field = "unknown";
    EXPECT_THAT(failed(changed), ElementsAre("codec"));
  }
  for (std::string video::ClipFacts::*field :
       {&video::ClipFacts::title, &video::ClipFacts::display}) {
    video::ClipFacts changed = facts;
    changed.*field = "another";
    EXPECT_EQ(failed(changed).size(), 1U);
  }
  facts.width = 66;
  EXPECT_THAT(failed(facts), ElementsAre("size"));
}

/// Adds what each picture of a clip of this program states to `facts`.
video::PictureFacts tagged(video::PictureFacts facts) {
  facts.colours = {"bt709", "bt709", "bt709", "tv"};
  facts.pixelShape = "1:1";
  return facts;
}

TEST(DisplayCheck, KnowsTagsThatChangeInMidClip) {
  const auto failureOf = [](const video::PictureFacts& second) {
    DisplayCheck check(false);
    check.add(tagged({}));
    check.add(second);
    const ClipCheck tags = check.checks({.scan = "progressive"}).front();
    EXPECT_EQ(tags.what, "tags");
    return tags.passed ? "" : tags.measured;
  };
  EXPECT_EQ(failureOf(tagged({})), "");
  for (std::string video::ColourTags::*field :
       {&video::ColourTags::primaries, &video::ColourTags::transfer, &video::ColourTags::matrix,
        &video::ColourTags::range}) {
    video::PictureFacts changed = tagged({});
    changed.colours.*field = "another";
    EXPECT_THAT(failureOf(changed), ::testing::HasSubstr("another"));
  }
  video::PictureFacts wide = tagged({});
  wide.pixelShape = "1:4";
  EXPECT_EQ(failureOf(wide),
            "primaries bt709, transfer bt709, matrix bt709, range tv, pixels 1:4 in picture 1");
}

TEST(DisplayCheck, RefusesAlphaWhereTheSceneHasNone) {
  for (const bool transparent : {false, true}) {
    DisplayCheck check(transparent);
    check.add(tagged({.alpha = true}));
    const ClipCheck alpha = check.checks({.scan = "progressive"}).at(1);
    EXPECT_EQ(alpha.what, "alpha");
    EXPECT_EQ(alpha.passed, transparent);
  }
}

TEST(DisplayCheck, NamesTheFirstPictureThatPlayersChange) {
  const auto failed = [](const video::PictureFacts& second, const std::string& scan) {
    DisplayCheck check(false);
    check.add(tagged({.crop = {0, 0, 0, 12}}));  // Up to the macroblock's end.
    check.add(tagged(second));
    check.add(tagged(second));
    std::vector<std::string> texts;
    for (const ClipCheck& one : check.checks({.scan = scan})) {
      if (!one.passed) texts.push_back(one.what + ": " + one.measured);
    }
    return texts;
  };
  EXPECT_THAT(failed({}, "progressive"), IsEmpty());
  EXPECT_THAT(failed({}, "interlaced"), ElementsAre("scan: interlaced"));
  EXPECT_THAT(failed({.interlaced = true}, "progressive"),
              ElementsAre("scan: interlaced in picture 1"));
  EXPECT_THAT(failed({.messages = "Display Matrix"}, "progressive"),
              ElementsAre("messages: Display Matrix in picture 1"));
  EXPECT_THAT(failed({.crop = {16, 0, 0, 0}}, "progressive"),
              ElementsAre("coded crop: 16, 0, 0 and 0 pixels at left, top, right and bottom in "
                          "picture 1"));
}

TEST(StreamChecks, MeasureTimesAgainstTheRate) {
  const video::ClipFacts facts{.format = VideoFormat::Mp4, .duration = 3 / 24.0};
  const auto passed = [&](const std::vector<double>& times) {
    TimeCheck check(facts, {24, 1}, 3);
    for (const double time : times) check.add(time);
    std::vector<bool> results;
    for (const ClipCheck& one : check.checks()) results.push_back(one.passed);
    return results;
  };
  const double missing = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(passed({0, 1 / 24.0, 2 / 24.0}), ElementsAre(true, true, true));
  EXPECT_THAT(passed({0, 1 / 24.0 + 0.0002, 2 / 24.0}), ElementsAre(true, false, true));
  EXPECT_THAT(passed({0, missing, 2 / 24.0}), ElementsAre(true, false, true));
  EXPECT_THAT(passed({0, 1 / 24.0}), ElementsAre(false, true, true));
}

TEST(StreamChecks, NameWhatRotatebookWritesOtherwise) {
  const auto failed = [](const video::FormDifferences& found) {
    std::vector<std::string> texts;
    for (const ClipCheck& check : checkForm(found)) {
      if (!check.passed) texts.push_back(check.what + ": " + check.measured);
    }
    return texts;
  };
  EXPECT_THAT(failed({}), IsEmpty());
  EXPECT_THAT(failed({"moov differs", "a message"}),
              ElementsAre("layout: moov differs", "coding: a message"));
}

}  // namespace
}  // namespace rotatebook::pipeline
