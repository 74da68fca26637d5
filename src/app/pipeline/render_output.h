// What a render is to make of its frames, as its caller hands it in. Inside the room only.
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

/// What a sink is opened for.
struct SinkPlace {
  const scene::Scene& scene;
  const store::ClipFiles& files;
  const video::VideoSettings& video;
  store::FrameChecksums& sums;  ///< Of the folder of the clip's frames; outlives the sink.
};

/// A sink that a render opens, and what it leaves on the disk.
struct RenderOutput {
  /// Opens the sink, once nobody else renders there. Throws Error.
  std::function<std::shared_ptr<FrameSink>(const SinkPlace&)> open;
  /// How many write at once: more than one only into a sink that allows it. 0: pngThreads() of the
  /// machine's cores. The files are the same.
  int threads = 1;
  bool png = false;                            ///< It writes PNGs into the folder of the frames.
  std::optional<video::VideoFormat> format{};  ///< It writes ClipFiles::video() of that format.
};

/// PNG frames, beside which a render's outputs may have no others.
RenderOutput pngOutput(int threads = 0);
RenderOutput videoOutput(video::VideoFormat format);
/// The caller's own sink, which must outlive the render, and writes nothing where a render does.
RenderOutput sinkOutput(FrameSink& sink, int threads = 1);

/// PNG frames, if `png`, and the videos.
std::vector<RenderOutput> outputsOf(bool png, const std::vector<video::VideoFormat>& formats);

/// Whether there are PNG frames among them.
bool hasPng(const std::vector<RenderOutput>& outputs);
/// Of the videos among them.
std::vector<video::VideoFormat> formatsOf(const std::vector<RenderOutput>& outputs);

/// How many threads pack PNGs where a render has so many cores.
int pngThreads(int cores);

}  // namespace rotatebook::pipeline
