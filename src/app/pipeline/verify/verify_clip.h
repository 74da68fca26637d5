// Verification that a clip shows the scene in its record.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "picture/device_choice.h"
#include "pipeline/draw_frames.h"
#include "pipeline/verify/clip_check.h"
#include "store/clip_record.h"

namespace rotatebook::pipeline {

/// Options of a verification.
struct VerifyOptions {
  store::TextureLookup textures{};
  /// Frames to compare, as indices in the whole clip. If empty, one from each sixth of the clip,
  /// chosen by the motion's checksum.
  std::vector<std::int64_t> frames{};
  bool allFrames = false;  ///< Compare every frame of the clip.
  picture::DeviceChoice device{};
  /// Called after each decoded picture. May be empty.
  std::function<void(pipeline::RenderProgress)> progress{};
};

/// The conclusion of a verification.
enum class Verdict {
  Proved,
  Coarse,  ///< Nothing fails, but the stream is coded too coarsely to prove the pictures.
  Motion,  ///< Nothing fails, but the pictures are a browser's, which aren't compared.
  NotProved,
};

/// The result of a verification.
struct Verification {
  store::ClipRecord record;
  store::FrameRange range;      ///< The frames in the clip.
  std::int64_t wholeCount = 0;  ///< The number of frames of the whole clip.
  /// Differences between the tools that made the clip and those here, which may change pixels.
  /// Empty if no pictures were compared.
  std::vector<std::string> toolsDiffer{};
  std::vector<ClipCheck> checks{};
  /// Empty if size or codec are wrong, or the pictures are a browser's.
  std::vector<PictureCheck> pictures{};
  /// Mean quantiser of all pictures of the stream, see video::PictureFacts; none if the decoder
  /// reports none, or there are no `pictures`.
  std::optional<double> quantiser{};

  /// Returns how many checks failed, including those of pictures.
  std::int64_t failures() const;
  Verdict verdict() const;
  /// Returns the loosest bounds that pictures were held to: smaller changes go unnoticed.
  Deviation unnoticed() const;
};

/// Reads the record of `clip`, an MP4 or WebM, simulates and draws its scene again, and compares
/// the clip with that. Of one that a browser made, pictures and coding aren't compared. Throws
/// InputError where video::requireWholeFile(), store::readRecordedClip() and video::ClipReader do,
/// and for frames that the clip doesn't have; MachineError if nothing can be drawn.
Verification verifyClip(const std::filesystem::path& clip, const VerifyOptions& options);

}  // namespace rotatebook::pipeline
