#include "timeline/web_vtt.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scene/scene_text.h"
#include "timeline/simulate_scene.h"

namespace rotatebook::timeline {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

/// Ten frames a second.
scene::Scene slideshow(const std::string& more = "") {
  return scene::parseScene(
      "clip.fps = 10\nclip.duration = 8\n" + more + "[initial]\nangular_velocity = [0, 4, 0]\n",
      "a.toml");
}

ClipEvent event(std::int64_t frame, const std::string& words, const std::string& label = "") {
  return {frame, static_cast<double>(frame) / 10, label, words};
}

std::string vttOf(const std::vector<ClipEvent>& events, const std::string& more = "") {
  return webVtt(slideshow(more), events, 80);
}

TEST(WebVtt, ShowsAnEventUntilTheNextOrTheEnd) {
  EXPECT_EQ(vttOf({event(10, "a"), event(20, "b"), event(70, "c")}),
            "WEBVTT rotatebook\n\n00:00:01.000 --> 00:00:01.950 line:0\n1.00 s: a\n\n"
            "00:00:02.000 --> 00:00:05.000 line:0\n2.00 s: b\n\n"
            "00:00:07.000 --> 00:00:07.950 line:0\n7.00 s: c\n");
}

TEST(WebVtt, EndsWithTheClip) {
  EXPECT_THAT(vttOf({event(79, "end")}), HasSubstr("00:00:07.900 --> 00:00:08.000 line:0\n7.90 s"));
}

TEST(WebVtt, HoldsWordsAsWords) {
  EXPECT_THAT(vttOf({event(0, "a --> <b> & c")}),
              AllOf(HasSubstr("a --&gt; &lt;b&gt; &amp; c"), Not(HasSubstr("<b>"))));
  EXPECT_EQ(vttOf({}), "WEBVTT rotatebook\n");
}

TEST(WebVtt, ShowsEachCaptionUntilTheNext) {
  EXPECT_EQ(vttOf({event(15, "flip 1", "x")},
                  "caption = 'first'\n[[cue]]\nat = 1\ntext = \"two\\n\\nlines\"\n"
                  "[[cue]]\nat = 3\ntext = ''\n[[cue]]\nat = 99\ntext = 'never'\n"),
            "WEBVTT rotatebook\n\n00:00:00.000 --> 00:00:01.000 line:0\nfirst\n\n"
            "00:00:01.000 --> 00:00:03.000 line:0\ntwo\nlines\n\n"
            "00:00:01.500 --> 00:00:04.500 line:0\n1.50 s: x: flip 1\n");
}

TEST(WebVtt, IsInThePicturesLanguage) {
  scene::Words german = scene::germanWords();
  EXPECT_EQ(eventText({1, 4.067, "", german[scene::Word::Flip] + " 1"}, german),
            "4,07 s: Überschlag 1");
  const scene::Scene scene =
      slideshow("overlay.words = 'german'\n[[nudge]]\nat = 1\nangular_velocity = [0, 0, 1]\n");
  EXPECT_THAT(webVtt(scene, eventsOf(scene, simulateScene(scene)), 80),
              HasSubstr("1,00 s: Stoß 1"));
}

}  // namespace
}  // namespace rotatebook::timeline
