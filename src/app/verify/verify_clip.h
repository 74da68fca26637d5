// Whether a clip shows what it says it was made from.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "pipeline/draw_frames.h"
#include "render/device/device.h"
#include "store/clip_record.h"
#include "verify/clip_check.h"

namespace rotatebook::verify {

/// What to verify, and with what.
struct VerifyOptions {
  store::TextureLookup textures{};
  /// Frames of the whole clip whose pictures are compared; none: one of each sixth of the clip,
  /// chosen by the motion's checksum.
  std::vector<std::int64_t> frames{};
  bool allFrames = false;
  render::DeviceChoice device{};
  /// Told after each picture that was decoded. May be empty.
  std::function<void(pipeline::RenderProgress)> progress{};
};

/// What was found.
struct Verification {
  store::ClipRecord record;
  store::FrameRange range;      ///< The clip's frames.
  std::int64_t wholeCount = 0;  ///< Frames of the whole clip.
  /// What made the clip and isn't here, so that pixels may differ. Empty if none were compared.
  std::vector<std::string> toolsDiffer{};
  std::vector<ClipCheck> checks{};
  /// None if the stream isn't what it should be.
  std::vector<PictureCheck> pictures{};

  /// How many checks failed, those of pictures among them.
  std::int64_t failures() const;
  bool proved() const { return failures() == 0; }
};

/// Reads the record of `clip`, an MP4 or WebM, simulates and draws its scene again, and compares.
/// Throws InputError as video::requireWholeFile(), readRecordedClip() and video::ClipReader do, and
/// for frames that the clip hasn't; MachineError if nothing can be drawn.
Verification verifyClip(const std::filesystem::path& clip, const VerifyOptions& options);

}  // namespace rotatebook::verify
