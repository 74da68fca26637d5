// Rendering of a scene into its files.
#pragma once

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "picture/device_choice.h"
#include "picture/looks.h"
#include "pipeline/draw_frames.h"
#include "pipeline/render_output.h"
#include "scene/scene.h"
#include "store/clip_files.h"
#include "store/clip_settings.h"
#include "store/disk_space.h"
#include "timeline/clip_motion.h"
#include "timeline/motion_summary.h"

namespace rotatebook::pipeline {

/// The outputs of a render, their folder and the device that draws.
struct RenderOptions {
  std::filesystem::path folder = "out";  ///< Created if it doesn't exist.
  /// The files to write and the sinks to feed, each video format at most once, besides tables and
  /// poster, which every render of a whole clip leaves.
  std::vector<RenderOutput> outputs;
  std::optional<store::FrameRange> frames{};  ///< Only these; all by default.
  /// Only this part, of which a render leaves PNGs alone, for others to be joined with; excludes
  /// `frames` and videos.
  std::optional<store::ClipPart> part{};
  store::EarlierFrames earlier{};
  /// Set by others, such as a signal handler, to stop after the current frame. May be null.
  const std::atomic<bool>* stop = nullptr;
  picture::DeviceChoice device{};

  /// Returns whether only some frames are drawn.
  bool isPart() const { return frames || part; }
};

/// The state of a render before its first frame.
struct RenderStart {
  std::string renderer;  ///< render::Renderer::description()
  std::string encoders;  ///< "libx264, gif"
  int pngThreads = 0;    ///< 0 if there are no PNGs.
  store::DiskSpace space{};
};

/// Callbacks during a render, on the caller's thread. Each may be empty.
struct RenderListener {
  std::function<void(const RenderStart&)> started;
  std::function<void(RenderProgress)> progress;
};

/// The result of a render.
struct RenderResult {
  store::ClipFiles files;
  std::vector<std::filesystem::path> csvs;  ///< The tables; none are written if interrupted.
  std::filesystem::path captions{};         ///< NAME.vtt, if the scene has cues.
  std::int64_t framesWritten = 0;           ///< Including those kept.
  std::int64_t framesKept = 0;              ///< From an earlier run.
  std::vector<std::string> others;          ///< ClipFolder::keptOfOtherSettings()
  std::vector<std::string> replaced;        ///< ClipFolder::replacedOfOtherSettings()
  std::string remainder;                    ///< ClipFolder::remainder()
  bool wasDone = false;  ///< An earlier run had completed everything: nothing was written.
  /// RenderOptions::stop was set: frames are in NAME.partial/ (those of a part in NAME/), videos
  /// are NAME.partial.mp4 and so on, and the files of an earlier render are unchanged.
  bool interrupted = false;
};

/// Returns `wanted`, or all frames of the clip by default. Throws InputError, naming the frames
/// that exist, if `wanted` is empty or has others.
store::FrameRange framesToRender(const timeline::ClipMotion& motion,
                                 std::optional<store::FrameRange> wanted);

/// Draws `motion`, the scene's, into the outputs, and writes the tables and, for a whole clip, the
/// poster; nothing, if it is a part without frames. A resumed render leaves the same files as one
/// that was never interrupted. Throws Error; then, too, files with a final name are complete, and
/// finished frames are kept. See store::ClipFolder for the folders. `textures` are the scene's as
/// far as they were read already, `summaries` those of `motion`, which are computed if there are
/// none.
RenderResult renderClip(const scene::Scene& scene, const timeline::ClipMotion& motion,
                        const RenderOptions& options, const RenderListener& listener,
                        const picture::TextureFiles& textures = {},
                        const std::vector<timeline::MotionSummary>& summaries = {});

}  // namespace rotatebook::pipeline
