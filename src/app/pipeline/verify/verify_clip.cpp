#include "pipeline/verify/verify_clip.h"

#include <algorithm>
#include <iterator>
#include <set>

#include <fmt/core.h>

#include "base/error.h"
#include "pipeline/render_clip.h"
#include "pipeline/verify/picture_comparison.h"
#include "pipeline/verify/stream_checks.h"
#include "store/encoding.h"
#include "system/read_file.h"
#include "timeline/motion_checksum.h"
#include "timeline/simulate_scene.h"
#include "timeline/web_vtt.h"
#include "video/clip_form.h"
#include "video/clip_reader.h"
#include "video/video_writer.h"
#include "video/whole_file.h"

namespace rotatebook::pipeline {
namespace {

constexpr std::int64_t kDefaultFrames = 6;

/// Returns byte `index` of a checksum in hexadecimal digits.
std::int64_t byteOf(const std::string& checksum, std::int64_t index) {
  return std::stoi(checksum.substr(static_cast<std::size_t>(2 * index), 2), nullptr, 16);
}

/// Chooses one frame from each sixth of `range` by the motion's checksum: nobody can know which
/// frames before the motion exists, and everybody chooses the same.
std::set<std::int64_t> spreadFrames(store::FrameRange range, const std::string& motion) {
  constexpr std::int64_t kSteps = 256;  // Values of a byte.
  std::set<std::int64_t> frames;
  for (std::int64_t i = 0; i < kDefaultFrames; ++i) {
    const std::int64_t step = kSteps * i + byteOf(motion, i);
    frames.insert(range.first + range.count() * step / (kSteps * kDefaultFrames));
  }
  return frames;
}

std::set<std::int64_t> chosenFrames(store::FrameRange range, const std::string& motion,
                                    const VerifyOptions& options) {
  if (options.frames.empty()) return spreadFrames(range, motion);
  for (const std::int64_t frame : options.frames) {
    if (range.first <= frame && frame < range.end) continue;
    throw InputError(fmt::format("frame {} isn't in the clip, which has {} to {}", frame,
                                 range.first, range.end - 1));
  }
  return {options.frames.begin(), options.frames.end()};
}

ClipCheck checkRecord(const store::RecordedClip& clip) {
  constexpr const char* kWanted = "as rotatebook writes it";
  const bool isPlain = store::isPlainRecord(clip.record, clip.text);
  return {"record", isPlain ? kWanted : "other words, or written otherwise", kWanted, isPlain};
}

ClipCheck checkMotion(const store::Provenance& there, const std::string& motion) {
  return {"motion", motion, there.motion.empty() ? "none is recorded" : there.motion,
          motion == there.motion};
}

/// Checks the captions beside a whole clip whose scene has cues, if they are there.
std::vector<ClipCheck> checkCaptions(const std::filesystem::path& clip,
                                     const store::ClipRecord& record,
                                     const timeline::ClipMotion& motion) {
  const std::filesystem::path file = std::filesystem::path(clip).replace_extension(".vtt");
  if (record.scene.cues.empty() || record.part || !std::filesystem::is_regular_file(file))
    return {};
  constexpr const char* kWanted = "those of the scene";
  const std::string wanted =
      timeline::webVtt(record.scene, timeline::eventsOf(record.scene, motion), motion.frameCount());
  const bool isSame = system::readFileOrEmpty(file) == wanted;
  return {{"captions", isSame ? kWanted : "others are in " + file.filename().string(), kWanted,
           isSame}};
}

/// Follows the quantisers with which pictures are coded. Decoders report for a block that is copied
/// the quantiser that its picture states, whatever the block was coded with. Encoders state the
/// finest in key frames: a picture finer than its key frame is copied for the most part, and may be
/// as coarse as the coarsest since. Letters that stand still are copied in any case.
class Quantisers {
 public:
  CodedWith next(const video::PictureFacts& picture) {
    const double reported = picture.quantiser.value_or(0);
    const double block = picture.coarsestQuantiser.value_or(0);
    if (picture.isKey) key_ = coarsest_ = reported, keyBlock_ = block;
    coarsest_ = std::max(coarsest_, reported);
    return {picture.quantiser && reported < key_ ? coarsest_ : picture.quantiser,
            std::max(keyBlock_, block)};
  }

 private:
  double key_ = 0, coarsest_ = 0;
  double keyBlock_ = 0;  // The coarsest of a block of the key frame.
};

bool isCoarse(const Verification& found) {
  return found.quantiser.value_or(0) > kCoarsestProof;
}

/// A verification in progress.
class Verifier {
 public:
  Verifier(const std::filesystem::path& clip, const VerifyOptions& options)
      : path_(clip),
        options_(options),
        clip_(readWholeClip(clip, options.textures)),
        reader_(clip),
        motion_(timeline::simulateScene(record_.scene)),
        motionSum_(timeline::motionChecksum(motion_)) {}

  Verification run() {
    Verification found{.record = record_,
                       .range = pipeline::framesToRender(motion_, record_.part),
                       .wholeCount = motion_.frameCount()};
    const bool isOfBrowser = record_.provenance.isOfBrowser();
    found.checks = (isOfBrowser ? checkBrowserStream : checkStream)(reader_.facts(), record_.scene);
    found.checks.push_back(checkRecord(clip_));
    found.checks.push_back(checkMotion(record_.provenance, motionSum_));
    std::ranges::copy(checkCaptions(path_, record_, motion_), std::back_inserter(found.checks));
    // Pictures of another size or codec can't be compared, and drawing them may take gigabytes.
    const auto isWrong = [](const ClipCheck& check) {
      return !check.passed && (check.what == kSizeCheck || check.what == kCodecCheck);
    };
    if (std::ranges::any_of(found.checks, isWrong)) return found;
    isOfBrowser ? decodeBrowsers(found) : decode(found);
    return found;
  }

 private:
  static store::RecordedClip readWholeClip(const std::filesystem::path& clip,
                                           const store::TextureLookup& textures) {
    video::requireWholeFile(clip);
    return store::readRecordedClip(clip, textures);
  }

  /// Decodes a browser's clip, for the times of its pictures.
  void decodeBrowsers(Verification& found) {
    TimeCheck times(reader_.facts(), record_.scene.clip.frameRate, found.range.count());
    for (std::int64_t frame = 1; reader_.next(); ++frame) {
      times.add(reader_.time());
      if (options_.progress) options_.progress({frame, found.range.count()});
    }
    std::ranges::copy(times.checks(), std::back_inserter(found.checks));
  }

  void decode(Verification& found) {
    const std::set<std::int64_t> chosen = chosenFrames(found.range, motionSum_, options_);
    picture::FrameDrawer drawer(record_.scene, motion_, options_.device, clip_.textures);
    found.toolsDiffer = store::differencesOfTools(
        record_.provenance,
        store::provenanceOf(record_.scene, motionSum_, drawer.textureChecksums(),
                            drawer.description(), video::ffmpegVersion()));
    PictureComparison comparison(record_.scene, drawer, found.wholeCount);
    DisplayCheck display(scene::isTransparent(record_.scene));
    Quantisers coded;
    double quantisers = 0;  // The sum of those reported
    std::int64_t reported = 0;
    TimeCheck times(reader_.facts(), record_.scene.clip.frameRate, found.range.count());
    for (std::int64_t frame = found.range.first; reader_.next(); ++frame) {
      times.add(reader_.time());
      const bool wanted = frame < found.range.end && (options_.allFrames || chosen.contains(frame));
      const video::PictureFacts& facts = reader_.pictureFacts();
      display.add(facts);
      quantisers += facts.quantiser.value_or(0);
      reported += facts.quantiser ? 1 : 0;
      const CodedWith coding = coded.next(facts);
      if (wanted) found.pictures.push_back(comparison.compare(frame, reader_.picture(), coding));
      if (options_.progress)
        options_.progress({frame + 1 - found.range.first, found.range.count()});
    }
    std::ranges::copy(times.checks(), std::back_inserter(found.checks));
    std::ranges::copy(display.checks(reader_.facts()), std::back_inserter(found.checks));
    std::ranges::copy(checkForm(formDifferences(found.range)), std::back_inserter(found.checks));
    if (reported > 0) found.quantiser = quantisers / static_cast<double>(reported);
    if (isCoarse(found)) allowNoise(found);
  }

  video::FormDifferences formDifferences(store::FrameRange range) const {
    const scene::Scene& scene = record_.scene;
    return video::differencesFromWritten(
        path_,
        {.width = scene.clip.width,
         .height = scene.clip.height,
         .frameRate = scene.clip.frameRate,
         .frames = range.count(),
         .transparent = scene::isTransparent(scene),
         .crf = scene.video.crf,
         .preset = scene.video.preset,
         .chapters = record_.part ? std::vector<video::Chapter>{} : store::chaptersOf(scene)});
  }

  /// Sets the bounds of a coarse stream's pictures, which can't be proved, to their quantisers', or
  /// to the stream's: pictures take over noise of others.
  void allowNoise(Verification& found) const {
    const video::ClipFacts& facts = reader_.facts();
    for (PictureCheck& check : found.pictures) {
      const double quantiser = std::max(check.quantiser, *found.quantiser);
      const double shift = check.bound.shift;  // Of a picture with few edges.
      check.bound = encodingBound(quantiser, facts.width, facts.height);
      check.bound.shift = std::max(check.bound.shift, shift);
    }
  }

  const std::filesystem::path path_;
  const VerifyOptions& options_;
  const store::RecordedClip clip_;
  const store::ClipRecord& record_ = clip_.record;
  video::ClipReader reader_;
  timeline::ClipMotion motion_;
  std::string motionSum_;
};

}  // namespace

std::int64_t Verification::failures() const {
  return std::ranges::count(checks, false, &ClipCheck::passed) +
         std::ranges::count(pictures, false, &PictureCheck::passed);
}

Verdict Verification::verdict() const {
  if (failures() > 0) return Verdict::NotProved;
  if (record.provenance.isOfBrowser()) return Verdict::Motion;
  return isCoarse(*this) ? Verdict::Coarse : Verdict::Proved;
}

Deviation Verification::unnoticed() const {
  Deviation largest;
  for (const PictureCheck& check : pictures) {
    for (const MeasureRow& row : kMeasures) {
      largest.*row.value = std::max(largest.*row.value, check.bound.*row.value);
    }
  }
  return largest;
}

Verification verifyClip(const std::filesystem::path& clip, const VerifyOptions& options) {
  return Verifier(clip, options).run();
}

}  // namespace rotatebook::pipeline
