// Where the moments of cues and speeds are in the video.
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "messages.h"
#include "scene/parse.h"
#include "scene/scene_text.h"

namespace rotatebook::scene {
namespace {

using ::testing::ElementsAre;

// Of times that are found by way of others. [s]
constexpr double kRounding = 1e-12;

/// The exact motion about the middle axis, which flips at 2.428, 6.813 and 11.198 s.
constexpr const char* kFlipping =
    "[initial]\nangular_velocity = [4, 0, 0]\ntilt = [0.014, 'z']\n[simulation]\nmodel = 'exact'\n"
    "[clip]\nfps = 10\nduration = 14\n";

Scene flipping(const std::string& more, const std::vector<std::string>& overrides = {}) {
  return parseScene(kFlipping + more, "a.toml", overrides);
}

std::string errorOfFlipping(const std::string& more) {
  return errorOfText(kFlipping + more);
}

std::vector<std::int64_t> framesOf(const Scene& scene) {
  std::vector<std::int64_t> frames;
  for (const ShownCue& shown : scene.shownCues) frames.push_back(shown.frame);
  return frames;
}

std::string cue(const std::string& at, const std::string& more = "text = 'a'") {
  return "[[cue]]\nat = '" + at + "'\n" + more + "\n";
}

TEST(Schedule, FindsTheFramesOfCues) {
  const Scene scene = flipping(cue("flip 2") + cue("1 s before flip 1") + cue("3 s") +
                               cue("2 s before end") + cue("flip 1"));
  EXPECT_THAT(framesOf(scene), ElementsAre(15, 25, 30, 69, 120));
  EXPECT_NEAR(scene.shownCues[1].time, 2.428, 5e-3);  // measured 2.4236
  EXPECT_EQ(scene.shownCues[0].time, scene.shownCues[1].time - 1);
  EXPECT_FALSE(scene.schedule) << "no frame is at another time";
}

TEST(Schedule, FindsEventsThatNoFrameRateChanges) {
  const auto timeAtRate = [](const char* fps) {
    return flipping(cue("flip 3"), {std::string("clip.fps=") + fps}).shownCues[0].time;
  };
  EXPECT_NEAR(timeAtRate("24"), timeAtRate("240"), 3e-4);  // measured 2.4e-4
  // Holds and slow stretches change no event at all.
  const Scene slow = flipping(cue("flip 3", "hold = 1"));
  const Scene plain = flipping(cue("flip 3"));
  EXPECT_EQ(slow.shownCues[0].time, plain.shownCues[0].time);
}

TEST(Schedule, HoldsTheMotionForSoLong) {
  const Scene scene = flipping(cue("3 s", "hold = 2\ntext = 'a'"));
  ASSERT_TRUE(scene.schedule);
  EXPECT_THAT(scene.schedule->stretches, ElementsAre(SpeedStretch{3, 5, 0}));
  EXPECT_EQ(timeAt(scene, 40), timeAt(scene, 45)) << "to the last bit";
  EXPECT_NEAR(timeAt(scene, 40), 3, kRounding);
  EXPECT_NEAR(timeAt(scene, 60), 4, kRounding);
  EXPECT_EQ(timeAt(scene, 20), 2);
  // The caption comes with the first frame that is at its time: a quarter of a second after the
  // motion begins to stop.
  EXPECT_THAT(framesOf(scene), ElementsAre(33));
  EXPECT_EQ(captionAt(scene, 32), "");
  EXPECT_EQ(captionAt(scene, 33), "a");
}

TEST(Schedule, HoldsWhereTheClipIsSlow) {
  const Scene scene = flipping(cue("1 s", "hold = 2"), {"clip.speed=0.5"});
  EXPECT_THAT(scene.schedule->stretches, ElementsAre(SpeedStretch{2, 4, 0}));
  EXPECT_EQ(scene.schedule->constant, 0.5);
  EXPECT_NEAR(timeAt(scene, 60), 2, kRounding);
  const Scene stated = flipping(cue("1 s", "hold = 2"),
                                {"simulation.time_per_frame=0.05", "simulation.model=exact"});
  EXPECT_EQ(stated.schedule, scene.schedule);
}

TEST(Schedule, FindsStretchesThatEventsBound) {
  const Scene scene = flipping(
      "speed = [{ from = '0.5 s before flip 1', to = '0.5 s after flip 1', "
      "value = 0.25 }, { from = 8, to = 9, value = 2 }]\n");
  const auto& stretches = scene.schedule->stretches;
  ASSERT_EQ(stretches.size(), 2U);
  const double flip = flipping(cue("flip 1")).shownCues[0].time;
  EXPECT_NEAR(stretches[0].from, flip - 0.5, kRounding);
  EXPECT_NEAR(stretches[0].to, flip - 0.5 + 4, kRounding);
  EXPECT_EQ(stretches[1], (SpeedStretch{8, 9, 2}));
  // 3 s are lost to the flip, and one is won by the second stretch.
  EXPECT_NEAR(timeAt(scene, 130), 13 - 3 + 1, kRounding);
}

TEST(Schedule, GoesOnSlowlyAfterAHoldWithinAStretch) {
  const Scene scene =
      flipping("speed = [{ from = 'flip 1', to = '1 s after flip 1', value = 0.5 }]\n" +
               cue("0.5 s after flip 1", "hold = 3"));
  const auto& stretches = scene.schedule->stretches;
  const double flip = flipping(cue("flip 1")).shownCues[0].time;
  ASSERT_EQ(stretches.size(), 3U);
  EXPECT_NEAR(stretches[0].to, flip + 1, kRounding);
  EXPECT_EQ(stretches[1].value, 0);
  EXPECT_NEAR(stretches[2].from, flip + 4, kRounding);
  EXPECT_NEAR(stretches[2].to, flip + 5, kRounding);
  EXPECT_EQ(stretches[2].value, 0.5);
}

TEST(Schedule, KeepsTheDurationOfTheVideo) {
  const Scene scene = flipping(cue("end", "hold = 2\ntext = 'over'") + cue("1 s", "hold = 1"));
  EXPECT_EQ(scene.clip.frameCount(), 140);
  EXPECT_THAT(scene.schedule->stretches,
              ElementsAre(SpeedStretch{1, 2, 0}, SpeedStretch{12, 14, 0}));
  EXPECT_NEAR(timeAt(scene, 139), 11, kRounding);
}

TEST(Schedule, ShowsTheSceneCaptionUntilTheFirstText) {
  const Scene scene = flipping(cue("1 s", "chapter = 'One'") + cue("2 s") + cue("4 s", "text = ''"),
                               {"caption=first"});
  EXPECT_EQ(captionAt(scene, 19), "first");
  EXPECT_EQ(captionAt(scene, 20), "a");
  EXPECT_EQ(captionAt(scene, 39), "a");
  EXPECT_EQ(captionAt(scene, 40), "");
}

TEST(Schedule, TakesEventsOfThePanelThatIsNamed) {
  const std::string panels =
      "[[panel]]\nlabel = 'steady'\ninitial.angular_velocity = [0, 4, 0]\n"
      "[[panel]]\nlabel = 'middle'\ninitial.angular_velocity = [4, 0, 0]\n";
  EXPECT_THAT(framesOf(flipping(panels + cue("flip 1 of middle"))), ElementsAre(25));
  EXPECT_MESSAGE(errorOfFlipping(panels + cue("flip 1")));
  EXPECT_MESSAGE(errorOfFlipping(panels + cue("flip 1 of midle")));
}

TEST(Schedule, FindsTheBurst) {
  const Scene scene = parseScene(
      "[initial]\nangular_velocity = [5, 3, 1]\n[simulation]\nmodel = 'particles'\nsubsteps = 1\n"
      "time_per_frame = 0.041666666666666664\nnormalize = false\ndamping = 0\n[clip]\nfps = 24\n"
      "duration = 0.5\n[[cue]]\nat = 'burst'\ntext = 'a'\n",
      "a.toml");
  EXPECT_THAT(framesOf(scene), ElementsAre(5));
}

TEST(Schedule, FindsTheBurstThatNoFrameRateMoves) {
  const auto at = [](const char* fps) {
    const Scene scene = parseScene(
        "[initial]\nangular_velocity = [5, 3, 1]\n[simulation]\nmodel = 'particles'\n"
        "step = 0.001\nnormalize = false\ndamping = 0\n[clip]\nfps = " +
            std::string(fps) + "\nduration = 10\n[[cue]]\nat = 'burst'\ntext = 'a'\n",
        "a.toml");
    return scene.shownCues[0].time;
  };
  EXPECT_NEAR(at("8"), at("240"), 0.125 / 32);  // measured 2.9e-3
}

TEST(Schedule, RefusesCuesOfTheEndThatAreNeverSeen) {
  EXPECT_EQ(errorOfFlipping(cue("end")),
            "a.toml:10:6: nothing is seen of a cue at the clip's end; give it a hold, such as "
            "hold = \"3 s\", or take at = \"3 s before end\"");
  EXPECT_MESSAGE(errorOfFlipping(cue("1 s after end")));
  EXPECT_EQ(flipping(cue("end", "hold = 3\ntext = 'a'")).shownCues[0].frame, 113);
}

TEST(Schedule, RefusesEventsThatTheMotionLacks) {
  EXPECT_EQ(errorOfFlipping(cue("flip 4")),
            "a.toml:10:6: within 14 s the motion flips 3 times, so there is no \"flip 4\"");
  EXPECT_EQ(errorOfFlipping(cue("1 s after nudge 1")),
            "a.toml:10:6: the motion has 0 nudges, so there is no \"nudge 1\"");
  EXPECT_EQ(errorOfFlipping(cue("burst")),
            "a.toml:10:6: within 14 s the motion doesn't diverge, so there is no \"burst\"");
  EXPECT_EQ(errorOfFlipping("speed = [{ from = 'flip 9', to = 'end', value = 0.5 }]\n"),
            "a.toml:9:9: within 14 s the motion flips 3 times, so there is no \"flip 9\"");
}

TEST(Schedule, LooksForAnEventForSeconds) {
  const std::string steps = "model = 'quaternion'\nsubsteps = 1000000\n";
  EXPECT_EQ(errorOfText("[initial]\nangular_velocity = [4, 0, 0]\n[simulation]\n" + steps +
                        "[[cue]]\nat = 'flip 1'\ntext = 'a'\n"),
            "a.toml:7:6: the event isn't found within 5000000 integration steps; state a time in "
            "seconds");
  EXPECT_MESSAGE(
      errorOfFlipping("speed = [{ from = 1, to = 'flip 1', value = 1e6 }]\n" + cue("burst")));
}

TEST(Schedule, RefusesWhatCantBe) {
  EXPECT_EQ(errorOfFlipping(cue("9 s before flip 1")),
            "a.toml:10:6: the cue comes 6.58 s before the start");
  EXPECT_MESSAGE(errorOfFlipping(cue("3 s") + cue("2.98 s")));
  EXPECT_MESSAGE(errorOfFlipping("speed = [{ from = 2, to = 'flip 1', value = 0 }]\n"));
  EXPECT_MESSAGE(errorOfFlipping("speed = [{ from = 'flip 2', to = 'flip 1', value = 0.5 }]\n"));
  EXPECT_MESSAGE(
      errorOfFlipping("speed = [{ from = 0, to = 5, value = 2 }, { from = 'flip 1', to = "
                      "'flip 2', value = 0.5 }]\n"));
  for (const char* ends : {"from = '1 s before end', to = 'end'", "from = 'end', to = 'end'",
                           "from = 1, to = '1 s before end'", "from = 1, to = '1 s after end'"}) {
    EXPECT_MESSAGE(errorOfFlipping("speed = [{ " + std::string(ends) + ", value = 0.5 }]\n"))
        << ends;
  }
}

}  // namespace
}  // namespace rotatebook::scene
