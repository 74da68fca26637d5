// Honest clips of random scenes: verify refuses none. Ten of two hundred, one of each twenty, or
// all of them if ROTATEBOOK_ALL_FAULTS is set.
#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "pipeline/small_clip.h"
#include "pipeline/verify/verify_clip.h"

namespace rotatebook::pipeline {
namespace {

using video::VideoFormat;

constexpr int kClips = 200;
constexpr int kEach = 20;  // Of so many, the first is tested always.

/// Chooses among values, the same for the same clip.
class Choice {
 public:
  explicit Choice(int clip) : random_(static_cast<unsigned>(clip)) {}

  int below(int count) { return static_cast<int>(random_() % static_cast<unsigned>(count)); }
  std::string of(const std::vector<std::string>& values) {
    return values[static_cast<std::size_t>(below(static_cast<int>(values.size())))];
  }
  /// A number from -1 to 1.
  double signedShare() { return (below(20'001) - 10'000) / 10'000.0; }

 private:
  std::mt19937 random_;
};

std::string colour(Choice& choice) {
  std::string text = "#";
  for (int i = 0; i < 6; ++i) text += "0123456789abcdef"[choice.below(16)];
  return text;
}

std::string backgroundOf(Choice& choice) {
  const std::string kind =
      choice.of({"colour", "colour", "colour", "studio", "white", "black", "stars", "transparent"});
  return kind == "colour" ? colour(choice) : kind;
}

/// Mostly small, as software draws them.
std::string sizeOf(Choice& choice) {
  return choice.of({"[64, 36]", "[96, 96]", "[160, 90]", "[160, 90]", "[176, 144]", "[320, 180]",
                    "[320, 180]", "[320, 180]", "[362, 202]", "[640, 360]"});
}

std::string spin(Choice& choice) {
  const auto component = [&] { return std::to_string(8 * choice.signedShare()); };
  return "[" + component() + "," + component() + "," + component() + "]";
}

struct HonestClip {
  VideoFormat format = VideoFormat::Mp4;
  std::vector<std::string> settings;
};

HonestClip honestClip(int clip) {
  Choice choice(clip);
  const std::string background = backgroundOf(choice);
  HonestClip honest{
      choice.below(3) == 0 || background == "transparent" ? VideoFormat::WebM : VideoFormat::Mp4,
      {"look.background='" + background + "'",
       "clip.size=" + (clip % 50 == 0 ? "[1280, 720]" : sizeOf(choice)),
       "clip.fps='" + choice.of({"24", "25", "30", "30000/1001", "60", "120"}) + "'",
       "clip.duration=" + choice.of({"0.05", "0.2", "0.2", "0.4"}),
       "video.crf=" + std::to_string(1 + choice.below(22)),
       "video.preset=" + choice.of({"book", "book", "medium", "veryslow", "ultrafast", "faster"}),
       "initial.angular_velocity=" + spin(choice),
       "overlay.show=" + choice.of({"[]", "['caption', 'clock']", "['axes', 'omega', 'energy']",
                                    "['polhode', 'half_turns']"})}};
  if (choice.below(2) == 0) honest.settings.push_back("book.color='" + colour(choice) + "'");
  if (choice.below(6) == 0) honest.settings.push_back("look.motion_blur=2");
  return honest;
}

/// Returns the checks and measures that fail.
std::string failuresIn(const Verification& found) {
  std::string text;
  for (const ClipCheck& check : found.checks) {
    if (!check.passed) text += check.what + ": " + check.measured + "; ";
  }
  for (const PictureCheck& picture : found.pictures) {
    for (const MeasureRow& row : kMeasures) {
      const double measured = picture.measured.*row.value, bound = picture.bound.*row.value;
      if (measured <= bound) continue;
      text += "frame " + std::to_string(picture.frame) + " " + row.text + " " +
              std::to_string(measured) + " of " + std::to_string(bound) + "; ";
    }
    if (picture.closerTo) text += "frame " + std::to_string(picture.frame) + " is another; ";
  }
  return text;
}

/// The largest share of each bound that a picture measured.
class LargestShares {
 public:
  void add(const std::vector<PictureCheck>& pictures) {
    for (const PictureCheck& picture : pictures) {
      for (std::size_t i = 0; i < kMeasures.size(); ++i) {
        const auto value = kMeasures[i].value;
        shares_[i] = std::max(shares_[i], picture.measured.*value / picture.bound.*value);
      }
    }
  }
  std::string text() const {
    std::string text;
    for (std::size_t i = 0; i < kMeasures.size(); ++i) {
      text += std::string(kMeasures[i].name) + " " + std::to_string(shares_[i]) + "  ";
    }
    return text;
  }

 private:
  std::array<double, kMeasures.size()> shares_{};
};

TEST(HonestClips, AreNeverRefused) {
  const bool isAll = std::getenv("ROTATEBOOK_ALL_FAULTS") != nullptr;
  int proved = 0, coarse = 0;
  LargestShares shares;
  for (int clip = 0; clip < kClips; clip += isAll ? 1 : kEach) {
    const HonestClip honest = honestClip(clip);
    SCOPED_TRACE(std::to_string(clip) + " " + ::testing::PrintToString(honest.settings));
    const scene::Scene scene = scene::testing::smallScene(honest.settings);
    const auto rendered =
        pipeline::testing::render(scene, {.folder = pipeline::testing::emptyFolder(),
                                          .outputs = pipeline::outputsOf(false, {honest.format})});
    const Verification found = verifyClip(rendered.files.video(honest.format), {.allFrames = true});
    EXPECT_EQ(found.failures(), 0) << failuresIn(found);
    shares.add(found.pictures);
    proved += found.verdict() == Verdict::Proved ? 1 : 0;
    coarse += found.verdict() == Verdict::Coarse ? 1 : 0;
  }
  std::cout << proved << " proved, " << coarse << " consistent, coarsely; of bounds at most "
            << shares.text() << "\n";
  EXPECT_GE(proved, isAll ? 190 : 9);  // measured 198 and 10
}

}  // namespace
}  // namespace rotatebook::pipeline
