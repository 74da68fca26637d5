#include "pipeline/frame_sink.h"

#include <utility>

#include "base/checksum.h"
#include "store/clip_files.h"

namespace rotatebook::pipeline {

PngSequenceSink::PngSequenceSink(store::FrameChecksums& checksums, bool transparent)
    : checksums_(&checksums), transparent_(transparent) {}

void PngSequenceSink::write(std::int64_t index, image::ImageView picture) {
  image::PngWriter writer = takeWriter();
  checksums_->add(index, writer.write(checksums_->folder() / store::frameName(index), picture));
  const std::lock_guard lock(mutex_);
  idleWriters_.push_back(std::move(writer));
}

image::PngWriter PngSequenceSink::takeWriter() {
  const std::lock_guard lock(mutex_);
  if (idleWriters_.empty()) return image::PngWriter(transparent_);
  image::PngWriter writer = std::move(idleWriters_.back());
  idleWriters_.pop_back();
  return writer;
}

VideoSink::VideoSink(video::VideoFormat format, const std::filesystem::path& path,
                     const video::VideoSettings& settings)
    : file_(path), writer_(format, file_.temporaryPath(), settings) {}

void VideoSink::write(std::int64_t, image::ImageView picture) {
  writer_.write(picture);
}

void VideoSink::finish() {
  finishAs(file_.finalPath());
}

void VideoSink::finishAs(const std::filesystem::path& path) {
  writer_.finish();
  file_.commitAs(path);
}

void HashSink::write(std::int64_t index, image::ImageView picture) {
  const auto size = static_cast<std::size_t>(picture.width * image::bytesPerPixel(picture.format));
  Checksum pixels;
  for (int y = 0; y < picture.height; ++y) {
    pixels.add({reinterpret_cast<const char*>(picture.row(y)), size});
  }
  const std::lock_guard lock(mutex_);
  checksums_[index] = pixels.text();
}

}  // namespace rotatebook::pipeline
