// What a clip's container tells, beside what its scene asks for. Inside the room only.
#pragma once

#include <cstdint>
#include <vector>

#include "scene/scene.h"
#include "verify/clip_check.h"
#include "video/clip_reader.h"

namespace rotatebook::verify {

/// Checks without which pictures can't be compared.
inline constexpr const char* kSizeCheck = "size";
inline constexpr const char* kCodecCheck = "codec";

/// Size, codec and colours, and how players are told to show the pictures.
std::vector<ClipCheck> checkStream(const video::ClipFacts& facts, const scene::Scene& scene);

/// Takes the times of a clip's pictures, in their order.
class TimeCheck {
 public:
  /// The clip should have `frames` pictures.
  TimeCheck(const video::ClipFacts& facts, FrameRate rate, std::int64_t frames);

  /// The next picture is shown at `time` [s], or not a number.
  void add(double time);
  /// Number of frames, time stamps, duration and, of an MP4, speed; after the last picture.
  std::vector<ClipCheck> checks() const;

 private:
  double timeOf(std::int64_t frame) const;

  video::ClipFacts facts_;
  FrameRate rate_;
  std::int64_t frames_;
  std::int64_t count_ = 0;
  double farthest_ = 0;  // [s]
  bool allHaveTimes_ = true;
};

}  // namespace rotatebook::verify
