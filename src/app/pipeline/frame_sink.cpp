#include "pipeline/frame_sink.h"

#include <utility>

#include "store/clip_files.h"

namespace rotatebook::pipeline {

PngSequenceSink::PngSequenceSink(store::FrameSums& sums, bool transparent)
    : sums_(&sums), transparent_(transparent) {}

void PngSequenceSink::write(std::int64_t index, image::ImageView picture) {
  image::PngWriter writer = takeWriter();
  sums_->add(index, writer.write(sums_->folder() / store::frameName(index), picture));
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
    : format_(format), file_(path), writer_(format, file_.temporaryPath(), settings) {}

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

}  // namespace rotatebook::pipeline
