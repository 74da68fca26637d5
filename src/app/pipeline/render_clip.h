// From a scene to its files.
#pragma once

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "pipeline/draw_frames.h"
#include "pipeline/render_output.h"
#include "render/device/device.h"
#include "scene/scene.h"
#include "store/clip_files.h"
#include "store/clip_folder.h"
#include "store/disk_space.h"
#include "timeline/clip_motion.h"

namespace rotatebook::pipeline {

/// What to write, and where.
struct RenderOptions {
  std::filesystem::path folder = "out";  ///< Made if it isn't there.
  /// Each format at most once.
  std::vector<RenderOutput> outputs = outputsOf(true, {video::VideoFormat::Mp4});
  std::optional<store::FrameRange> frames{};  ///< Only these; all by default.
  store::EarlierFrames earlier{};
  /// Set from outside, e.g. by a signal handler, to stop after the frame in hand. May be null.
  const std::atomic<bool>* stop = nullptr;
  render::DeviceChoice device{};
};

/// With what a render begins.
struct RenderStart {
  std::string renderer;
  std::string encoders;  ///< "libx264, gif"
  int pngThreads = 0;    ///< 0 if there are no PNGs.
  store::DiskSpace space{};
};

/// Hears of a render while it goes on; called on the caller's thread.
struct RenderListener {
  std::function<void(const RenderStart&)> started;
  std::function<void(RenderProgress)> progress;
};

/// What a render left.
struct RenderResult {
  store::ClipFiles files;
  std::vector<std::filesystem::path> csvs;  ///< The tables; none are written if interrupted.
  std::int64_t framesWritten = 0;           ///< Those kept among them.
  std::int64_t framesKept = 0;              ///< Of an earlier run.
  std::vector<std::string> others;          ///< ClipFolder::keptOfOtherSettings()
  bool wasDone = false;  ///< An earlier run left all of it as it should be: nothing was written.
  /// Stopped from outside: frames are in NAME.partial/ (those of a part in NAME/), videos are
  /// NAME.partial.mp4 and so on, and the files of an earlier render are as they were.
  bool interrupted = false;
};

/// The frames of the clip that `wanted` means; all of them by default. Throws InputError,
/// naming the frames that exist.
store::FrameRange framesToRender(const timeline::ClipMotion& motion,
                                 std::optional<store::FrameRange> wanted);

/// Draws `motion`, that of `scene`, into the outputs, and writes CSV and, of a whole clip, poster,
/// where ClipFolder has their frames; the files of a render that went on with an earlier one's are
/// those of one that was never interrupted. Throws Error; files under a final name are whole then,
/// too, and frames that were finished are kept.
RenderResult renderClip(const scene::Scene& scene, const timeline::ClipMotion& motion,
                        const RenderOptions& options, const RenderListener& listener);

}  // namespace rotatebook::pipeline
