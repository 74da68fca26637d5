#include "pipeline/render_output.h"

#include <algorithm>

#include "scene/scene.h"

namespace rotatebook::pipeline {

RenderOutput pngOutput(int threads) {
  const auto open = [](const SinkContext& context) {
    return std::make_shared<PngSequenceSink>(context.checksums,
                                             scene::isTransparent(context.scene));
  };
  return {.open = open, .threads = threads, .png = true};
}

RenderOutput videoOutput(video::VideoFormat format) {
  const auto open = [format](const SinkContext& context) {
    return std::make_shared<VideoSink>(format, context.files.video(format), context.video);
  };
  return {.open = open, .format = format};
}

RenderOutput sinkOutput(FrameSink& sink, int threads) {
  const std::shared_ptr<FrameSink> borrowed(std::shared_ptr<FrameSink>(), &sink);
  return {.open = [borrowed](const SinkContext&) { return borrowed; }, .threads = threads};
}

std::vector<RenderOutput> outputsOf(bool png, const std::vector<video::VideoFormat>& formats) {
  std::vector<RenderOutput> outputs;
  if (png) outputs.push_back(pngOutput());
  for (const video::VideoFormat format : formats) outputs.push_back(videoOutput(format));
  return outputs;
}

bool hasPng(const std::vector<RenderOutput>& outputs) {
  return std::ranges::any_of(outputs, &RenderOutput::png);
}

std::vector<video::VideoFormat> formatsOf(const std::vector<RenderOutput>& outputs) {
  std::vector<video::VideoFormat> formats;
  for (const RenderOutput& output : outputs) {
    if (output.format) formats.push_back(*output.format);
  }
  return formats;
}

// Compressing PNGs is the only stage that several threads can share; drawing, finishing and
// encoding need a core, too.
int pngThreads(int cores) {
  return std::clamp(cores - 1, 1, 6);
}

}  // namespace rotatebook::pipeline
