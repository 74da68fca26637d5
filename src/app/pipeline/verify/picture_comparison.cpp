#include "pipeline/verify/picture_comparison.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "store/clip_files.h"

namespace rotatebook::pipeline {
namespace {

// Frames on either side with which a picture is compared: each picture, and one that fails.
constexpr std::int64_t kReach = 1;
constexpr std::int64_t kFarReach = 5;

// A picture belongs to another frame if its distance to that frame, over the distance to its own,
// is less than this. Measured from 64x36 to 1280x720: at least 0.73 in correct clips (160x90 at crf
// 42; 2.6 at crf 18), at most 0.38 in clips that are off by a frame, at crf 18.
constexpr double kCloserRatio = 0.6;

// A picture whose worst block is off by less than this share of its bound isn't said to be of
// another frame, or shifted: where little changes, encoders copy what is there. Measured in 200
// clips of a small book on a flat ground: at most 0.13 in those that are closer to another frame.
constexpr double kCopiedShare = 0.25;

// A WebM's largest, as this program encodes them: for pictures of which none is reported.
constexpr double kUnreportedQuantiser = 26;

/// A measure's bound.
struct BoundRow {
  double Deviation::*value;
  double noise;     ///< The bound at quantiser 20.
  double doubling;  ///< Steps of the quantiser that double it.
  double smallest;  ///< For conversion, rounding and another rasteriser's edges.
  double largest;   ///< Beyond it not even a coarse clip is consistent.
  bool averages;    ///< A mean over the whole picture: smaller in larger pictures.
};

// Beyond kCoarsestProof bounds double with fewer steps, as whole blocks lose their gradients; all
// that averages doubles with a sixteenth of kCalibratedPixels.
constexpr double kCoarseDoubling = 5;
constexpr double kCalibratedPixels = 640 * 360;

// Measured on 24 frames of all scenes, figures and comparisons at 64x36 to 640x360 and of six
// scenes at 1280x720, at crf 1, 18, 24 and 30 and as WebM, also with other presets, stars, motion
// blur and transparency: the largest share of the bound in clips that can be proved, and at 320x180
// and crf 18, quantisers 15 to 25, the values in honest clips and with brightness + 2 %, hue + 10
// degrees, the picture a pixel aside and 10 % white letters:
//   rms          0.68  0.7-1.5    1.2-1.8  0.8-1.7    3.6-5.9   1.7-2.4
//   worst block  0.74  2.2-4.9    3.4-5.2  2.9-5.4    17-31     8.4-11
//   detail       0.78  in the 200 clips of honest_clips_test.cpp
//   brightness   0.76  0.04-0.18  1.0-1.2  0.2-0.3    0.3-1.0   0.2-0.4
//   colour       0.73  0.20-0.56  0.2-0.6  0.9-2.4    0.2-0.6   0.2-0.6
//   shift        0.50  0.00-0.04  0-0.02   0-0.03     0.9-1.0   0-0.03
//   luma patch   0.76  0.3-0.9    2.4-3.6  0.4-1.1    2.7-4.9   4.6-5.7
//   chroma patch 0.75  0.5-1.1    0.6-1.2  2.2-6.5    0.9-1.5   0.6-1.1
constexpr std::array<BoundRow, 8> kBounds{{{&Deviation::rms, 2.8, 8, 1.2, 26, true},
                                           {&Deviation::worstBlock, 10.7, 8, 4.5, 100, false},
                                           {&Deviation::detail, 19, 8, 8, 150, false},
                                           {&Deviation::brightness, 0.53, 7, 0.2, 30, true},
                                           {&Deviation::colour, 1.2, 10, 0.75, 15, true},
                                           {&Deviation::shift, 0.08, 8, 0.03, 0.8, true},
                                           {&Deviation::lumaPatch, 2.05, 7, 0.56, 45, false},
                                           {&Deviation::chromaPatch, 1.8, 9, 0.86, 25, false}}};

// The quantiser that codingNoise() suggests, at most: slower presets skip more blocks, which leaves
// coarser quantisers in the stream than noise in the pictures. Measured on 3 frames of all scenes,
// figures and comparisons at 320x180 and 640x360, with the presets book, medium and veryslow at crf
// 18 and 24: no measure above 0.77 of the bound, also as WebM. The median at 320x180 and veryslow,
// crf 18, is 22, that of the reported quantisers 29.
constexpr double kNoiseQuantiser = 11;  // At noise 1.
constexpr double kNoiseDoubling = 9;    // Steps of the quantiser that double the noise.
// It suggests no less than this: where most texture stands still, as stars and text do, the noise
// is that of a finer quantiser than the moving rest has. Measured with stars and text around a
// small or slow book, as WebM and at crf 10: at most 0.72 of the bound, where without it 1.21.
constexpr double kFinestSuggested = 14;
// Likewise of patches, which a moving book's shade leaves behind. Measured as WebM at 240 frames a
// second, with a caption below the book: at most 0.76 of the bound, where without it 1.37.
constexpr double kFinestPatch = 20;
// The largest error of a block over codingNoise(). Measured on these: at most 3.75.
constexpr double kWorstOverNoise = 5;

// The coarsest quantiser of a single block that its bounds follow. Where x264 varies quantisers,
// all presets but book and ultrafast, a fine picture has blocks of letters and edges that are far
// coarser than its mean. Measured on scenes/starter.toml of 2 and 30 frames at 320x180 to
// 1280x720, with medium and veryslow at crf 1 to 8: at most 0.77 of the bound, where without
// it 1.42.
constexpr double kCoarsestBlock = 18;

/// Returns the bound of a picture that can be proved.
Deviation boundOfMean(double quantiser, std::optional<double> noise, int width, int height) {
  const double proving = std::min(quantiser, kCoarsestProof);
  if (!noise) return encodingBound(proving, width, height);
  const double suggested =
      std::max(kNoiseQuantiser + kNoiseDoubling * std::log2(*noise), kFinestSuggested);
  const Deviation reported = encodingBound(proving, width, height);
  Deviation bound = encodingBound(std::min(proving, suggested), width, height);
  // VP9's chroma is noisier than its luma suggests.
  bound.colour = reported.colour;
  bound.chromaPatch = reported.chromaPatch;
  const Deviation patch = encodingBound(std::min(proving, kFinestPatch), width, height);
  bound.lumaPatch = std::max(bound.lumaPatch, patch.lumaPatch);
  const double smallest =
      encodingBound(std::min(proving, kFinestSuggested), width, height).worstBlock;
  bound.worstBlock = std::min(bound.worstBlock, std::max(kWorstOverNoise * *noise, smallest));
  return bound;
}

Deviation provingBound(const PictureCheck& check, const CodedWith& coding,
                       std::optional<double> noise, const video::Planes& drawn) {
  Deviation bound = boundOfMean(check.quantiser, noise, drawn.width, drawn.height);
  const double coarsest = std::min(coding.coarsest.value_or(0), kCoarsestBlock);
  const Deviation block = encodingBound(coarsest, drawn.width, drawn.height);
  bound.worstBlock = std::max(bound.worstBlock, block.worstBlock);
  bound.detail = std::max(bound.detail, block.detail);
  bound.shift *= roomOfShift(drawn);
  return bound;
}

bool mayBeCopied(const PictureCheck& check) {
  return check.measured.worstBlock < kCopiedShare * check.bound.worstBlock;
}

}  // namespace

Deviation encodingBound(double quantiser, int width, int height) {
  const double fine = std::min(quantiser, kCoarsestProof) - 20;
  const double coarse = std::max(quantiser - kCoarsestProof, 0.0) / kCoarseDoubling;
  const double size = std::pow(kCalibratedPixels / (1.0 * width * height), 0.25);
  Deviation bound;
  for (const BoundRow& row : kBounds) {
    const double noise = row.noise * std::exp2(fine / row.doubling + coarse);
    const double value = std::clamp(noise, row.smallest, row.largest);
    bound.*row.value = row.averages ? value * size : value;
  }
  return bound;
}

PictureCheck compareWith(const video::Planes& drawn, std::int64_t frame,
                         const video::Planes& picture, const CodedWith& coding) {
  PictureCheck check{.frame = frame,
                     .quantiser = coding.quantiser.value_or(kUnreportedQuantiser),
                     .measured = deviation(picture, drawn)};
  check.bound = provingBound(check, coding, codingNoise(picture, drawn), drawn);
  if (mayBeCopied(check)) check.measured.shift = 0;
  return check;
}

PictureComparison::PictureComparison(const scene::Scene& scene, picture::FrameDrawer& drawer,
                                     std::int64_t frames)
    : drawer_(&drawer),
      frames_(frames),
      transparent_(scene::isTransparent(scene)),
      picture_(drawer.makePicture()) {}

PictureCheck PictureComparison::compare(std::int64_t frame, const video::Planes& picture,
                                        const CodedWith& coding) {
  // Forget frames that ascending comparisons don't need again
  drawn_.erase(drawn_.begin(), drawn_.lower_bound(frame - kReach));
  PictureCheck check = compareWith(drawn(frame), frame, picture, coding);
  const double rms = check.measured.rms;
  if (check.passed() && mayBeCopied(check)) return check;
  check.closerTo = closerFrame(frame, picture, rms, kReach);
  if (!check.passed()) check.closerTo = closerFrame(frame, picture, rms, kFarReach);
  return check;
}

std::optional<std::int64_t> PictureComparison::closerFrame(std::int64_t frame,
                                                           const video::Planes& picture, double rms,
                                                           std::int64_t reach) {
  std::optional<std::int64_t> found;
  double smallest = kCloserRatio * rms;
  const std::int64_t last = std::min(frame + reach, frames_ - 1);
  for (std::int64_t other = std::max<std::int64_t>(frame - reach, 0); other <= last; ++other) {
    const double distance = video::distance(picture, drawn(other)).rms;
    if (distance >= smallest) continue;
    smallest = distance;
    found = other;
  }
  return found;
}

const video::Planes& PictureComparison::drawn(std::int64_t frame) {
  const auto known = drawn_.find(frame);
  if (known != drawn_.end()) return known->second;
  drawer_->draw(frame, picture_);
  return drawn_[frame] = video::planesToEncode(picture_.view(), transparent_);
}

}  // namespace rotatebook::pipeline
