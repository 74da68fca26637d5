// Checks of a clip's container and stream against its scene. Inside the room only.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "pipeline/verify/clip_check.h"
#include "scene/scene.h"
#include "video/clip_reader.h"
#include "video/written_form.h"

namespace rotatebook::pipeline {

/// Names of the checks that must pass before pictures can be compared.
inline constexpr const char* kSizeCheck = "size";
inline constexpr const char* kCodecCheck = "codec";

/// Checks size, codec, colours, pixel aspect ratio, display transformation and title.
std::vector<ClipCheck> checkStream(const video::ClipFacts& facts, const scene::Scene& scene);

/// Checks of these what doesn't depend on the encoder: size, display transformation and title.
std::vector<ClipCheck> checkBrowserStream(const video::ClipFacts& facts, const scene::Scene& scene);

/// Checks that the file has the parts and units that rotatebook writes, and no others.
std::vector<ClipCheck> checkForm(const video::FormDifferences& found);

/// Checks what the stream has players do with its pictures.
class DisplayCheck {
 public:
  /// If not `transparent`, the pictures may have no alpha.
  explicit DisplayCheck(bool transparent) : transparent_(transparent) {}

  /// Adds the next picture's facts.
  void add(const video::PictureFacts& picture);
  /// Returns the checks of tags, alpha, scan, coded crop and messages, each of the first picture
  /// that fails it. Call it after the last picture.
  std::vector<ClipCheck> checks(const video::ClipFacts& facts) const;

 private:
  bool transparent_;
  std::int64_t count_ = 0;
  std::string tags_, alpha_, interlaced_, cropped_, messages_;  // Empty as long as there are none.
};

/// Checks the times at which a clip's pictures are shown.
class TimeCheck {
 public:
  /// `frames` is the number of pictures that the clip should have.
  TimeCheck(const video::ClipFacts& facts, FrameRate rate, std::int64_t frames);

  /// Adds the next picture's `time` [s]; not a number if it has none.
  void add(double time);
  /// Returns the checks of frame count, time stamps and duration. Call it after the last picture.
  std::vector<ClipCheck> checks() const;

 private:
  double timeOf(std::int64_t frame) const;

  video::ClipFacts facts_;
  FrameRate rate_;
  std::int64_t frames_;
  std::int64_t count_ = 0;
  double largestError_ = 0;  // Of the times so far. [s]
  bool allHaveTimes_ = true;
};

}  // namespace rotatebook::pipeline
