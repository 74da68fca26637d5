// Outputs that a caller asks a render for. Inside the room only.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "pipeline/frame_sink.h"
#include "scene/scene.h"
#include "store/clip_files.h"
#include "store/frame_checksums.h"
#include "video/video_format.h"

namespace rotatebook::pipeline {

/// The render for which a sink is opened.
struct SinkContext {
  const scene::Scene& scene;
  const store::ClipFiles& files;
  const video::VideoSettings& video;
  store::FrameChecksums& checksums;  ///< Of the frames' folder; outlives the sink.
};

/// A sink that a render opens, and the files that it leaves.
struct RenderOutput {
  /// Opens the sink; called while the clip's folder is locked. Throws Error.
  std::function<std::shared_ptr<FrameSink>(const SinkContext&)> open;
  /// The number of threads that write: more than 1 only if the sink allows concurrent writes;
  /// 0 means pngThreads() of the machine's cores. The files don't depend on it.
  int threads = 1;
  bool png = false;                            ///< Set if it writes PNGs to the frames' folder.
  std::optional<video::VideoFormat> format{};  ///< Set if it writes ClipFiles::video().
};

/// Returns an output of PNG frames, of which a render may have at most one.
RenderOutput pngOutput(int threads = 0);
/// Returns an output of one video.
RenderOutput videoOutput(video::VideoFormat format);
/// Returns an output to the caller's own sink, which must outlive the render and must not write to
/// the render's files.
RenderOutput sinkOutput(FrameSink& sink, int threads = 1);

/// Returns an output for each of `formats`, after one of PNG frames if `png`.
std::vector<RenderOutput> outputsOf(bool png, const std::vector<video::VideoFormat>& formats);

/// Returns whether one of `outputs` is of PNG frames.
bool hasPng(const std::vector<RenderOutput>& outputs);
/// Returns the formats of the videos among `outputs`.
std::vector<video::VideoFormat> formatsOf(const std::vector<RenderOutput>& outputs);

/// Returns how many threads compress PNGs on a machine with `cores` cores.
int pngThreads(int cores);

}  // namespace rotatebook::pipeline
