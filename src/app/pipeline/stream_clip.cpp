#include "pipeline/stream_clip.h"

#include <cstddef>
#include <memory>
#include <string>
#include <utility>

#include "base/error.h"
#include "image/png_file.h"
#include "picture/frame_drawer.h"
#include "pipeline/frame_sink.h"
#include "pipeline/render_clip.h"
#include "video/y4m_stream.h"

namespace rotatebook::pipeline {
namespace {

/// Writes pictures to a file that is open, by the functions of one format. write() is for one
/// thread at a time.
class StreamSink : public FrameSink {
 public:
  /// Returns a picture's bytes, valid until the next call.
  using Encode = std::function<const std::string&(image::ImageView)>;

  StreamSink(const system::FileDescriptor& output, const std::filesystem::path& name, Encode encode)
      : output_(output), name_(name), encode_(std::move(encode)) {}

  void write(std::int64_t /*index*/, image::ImageView picture) override {
    writeAll(output_, encode_(picture), name_);
  }
  void finish() override {}

 private:
  const system::FileDescriptor& output_;
  const std::filesystem::path& name_;
  Encode encode_;
};

/// Returns the bytes of a picture's rows, with alpha if `transparent`.
std::string rowsOf(image::ImageView picture, bool transparent) {
  const auto from = static_cast<std::size_t>(bytesPerPixel(picture.format));
  const std::size_t to = transparent ? from : 3;
  const auto width = static_cast<std::size_t>(picture.width);
  std::string bytes;
  bytes.reserve(width * to * static_cast<std::size_t>(picture.height));
  for (int y = 0; y < picture.height; ++y) {
    const auto* row = reinterpret_cast<const char*>(picture.row(y));
    if (from == to) {
      bytes.append(row, width * to);
      continue;
    }
    for (std::size_t x = 0; x < width; ++x) bytes.append(row + x * from, to);
  }
  return bytes;
}

/// Throws InputError if the format can't hold the scene's pictures.
StreamSink::Encode y4mEncoder(const scene::Scene& scene) {
  if (scene::isTransparent(scene)) {
    throw InputError(scene.name +
                     ": y4m can't hold the transparent background of look.background; use png or "
                     "raw as --format");
  }
  video::VideoSettings settings;
  settings.width = scene.clip.width;
  settings.height = scene.clip.height;
  settings.frameRate = scene.clip.frameRate;
  return [stream = std::make_shared<video::Y4mStream>(settings)](
             image::ImageView picture) -> const std::string& { return stream->next(picture); };
}

StreamSink::Encode pngEncoder(const scene::Scene& scene, const std::filesystem::path& name) {
  return [writer = std::make_shared<image::PngWriter>(scene::isTransparent(scene)),
          name](image::ImageView picture) -> const std::string& {
    return writer->encode(picture, name.string());
  };
}

StreamSink::Encode rawEncoder(const scene::Scene& scene) {
  return [rows = std::string(), transparent = scene::isTransparent(scene)](
             image::ImageView picture) mutable -> const std::string& {
    return rows = rowsOf(picture, transparent);
  };
}

StreamSink::Encode encoderOf(const scene::Scene& scene, StreamFormat format,
                             const std::filesystem::path& name) {
  if (format == StreamFormat::Y4m) return y4mEncoder(scene);
  return format == StreamFormat::Png ? pngEncoder(scene, name) : rawEncoder(scene);
}

}  // namespace

std::int64_t streamClip(const scene::Scene& scene, const timeline::ClipMotion& motion,
                        const StreamOptions& options, const system::FileDescriptor& output,
                        const std::filesystem::path& name,
                        const std::function<void(RenderProgress)>& progress,
                        const picture::TextureFiles& textures) {
  const store::FrameRange range = framesToRender(motion, options.frames);
  StreamSink sink(output, name, encoderOf(scene, options.format, name));
  picture::FrameDrawer drawer(scene, motion, options.device, textures);
  return drawFrames(drawer, {.range = range}, {{sink}}, progress).total();
}

}  // namespace rotatebook::pipeline
