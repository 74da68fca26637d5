#include "pipeline/verify_clip.h"

#include <algorithm>
#include <iterator>
#include <set>

#include "base/error.h"
#include "pipeline/picture_judge.h"
#include "pipeline/render_clip.h"
#include "pipeline/simulate_scene.h"
#include "pipeline/stream_checks.h"
#include "video/clip_reader.h"

namespace rotatebook::pipeline {
namespace {

constexpr std::int64_t kDefaultFrames = 6;

std::set<std::int64_t> spread(FrameRange range) {
  std::set<std::int64_t> frames;
  for (std::int64_t i = 0; i < kDefaultFrames; ++i) {
    frames.insert(range.first + (range.count() - 1) * i / (kDefaultFrames - 1));
  }
  return frames;
}

std::set<std::int64_t> chosenFrames(FrameRange range, const VerifyOptions& options) {
  if (options.frames.empty()) return spread(range);
  for (const std::int64_t frame : options.frames) {
    if (range.first <= frame && frame < range.end) continue;
    throw InputError("frame " + std::to_string(frame) + " isn't in the clip, which has " +
                     std::to_string(range.first) + " to " + std::to_string(range.end - 1));
  }
  return {options.frames.begin(), options.frames.end()};
}

ClipCheck checkMotion(const Making& there, const Making& here) {
  return {"motion", here.motion, there.motion.empty() ? "none is recorded" : there.motion,
          here.motion == there.motion};
}

/// Verifying on its way.
class Verifier {
 public:
  Verifier(const std::filesystem::path& clip, const VerifyOptions& options)
      : options_(options),
        record_(readRecordedClip(clip, options.sceneFolder).record),
        reader_(clip),
        motion_(simulateScene(record_.scene)),
        drawer_(record_.scene, motion_, options.device) {}

  Verification run() {
    Verification found{.record = record_,
                       .range = framesToRender(motion_, record_.part),
                       .wholeCount = motion_.frameCount()};
    const Making here = makingOf(record_.scene, motion_, drawer_.description());
    found.toolsDiffer = differencesOfTools(record_.making, here);
    found.checks = checkStream(reader_.facts(), record_.scene);
    found.checks.push_back(checkMotion(record_.making, here));
    // Pictures of other sizes and kinds can't be compared, and may be huge.
    const auto isWrong = [](const ClipCheck& check) {
      return !check.passed && (check.what == kSizeCheck || check.what == kCodecCheck);
    };
    if (std::ranges::none_of(found.checks, isWrong)) decode(found);
    return found;
  }

 private:
  void decode(Verification& found) {
    const std::set<std::int64_t> chosen = chosenFrames(found.range, options_);
    PictureJudge judge(record_.scene, drawer_, found.wholeCount, reader_.facts().format);
    TimeCheck times(reader_.facts(), record_.scene.clip.frameRate, found.range.count());
    for (std::int64_t frame = found.range.first; reader_.next(); ++frame) {
      times.add(reader_.time());
      const bool wanted = frame < found.range.end && (options_.allFrames || chosen.contains(frame));
      if (wanted) found.pictures.push_back(judge.judge(frame, reader_.picture()));
      if (options_.progress)
        options_.progress({frame + 1 - found.range.first, found.range.count()});
    }
    std::ranges::copy(times.checks(), std::back_inserter(found.checks));
  }

  const VerifyOptions& options_;
  ClipRecord record_;
  video::ClipReader reader_;
  ClipMotion motion_;
  FrameDrawer drawer_;
};

}  // namespace

std::int64_t Verification::failures() const {
  return std::ranges::count(checks, false, &ClipCheck::passed) +
         std::ranges::count(pictures, false, &PictureCheck::passed);
}

Verification verifyClip(const std::filesystem::path& clip, const VerifyOptions& options) {
  return Verifier(clip, options).run();
}

}  // namespace rotatebook::pipeline
