// Sinks, which take a clip's finished frames: PNG files, videos, checksums. Inside the room only.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <mutex>
#include <string>
#include <vector>

#include "image/image.h"
#include "image/png_file.h"
#include "store/frame_checksums.h"
#include "system/atomic_file.h"
#include "video/video_writer.h"

namespace rotatebook::pipeline {

/// Takes frames. A sink that is destroyed without finish() removes its unfinished file.
class FrameSink {
 public:
  virtual ~FrameSink() = default;

  /// Takes frame `index`; `picture` is valid during the call only. Throws Error.
  virtual void write(std::int64_t index, image::ImageView picture) = 0;
  /// Completes what was written. Throws Error on a failed flush, trailer, close or rename.
  virtual void finish() = 0;
  /// Completes the file of an interrupted render under the name `partial`, instead of finish(). By
  /// default does nothing, for sinks without a file of their own.
  virtual void finishAs(const std::filesystem::path& /*partial*/) {}
  /// Returns the encoder in use, for example "libx264"; empty if there is none.
  virtual std::string encoderName() const { return ""; }
};

/// Writes each frame to a PNG of its own in one folder, and its checksum beside it. write() may be
/// called from several threads at once, in any order.
class PngSequenceSink : public FrameSink {
 public:
  /// Writes into the folder of `checksums`, which must outlive this.
  PngSequenceSink(store::FrameChecksums& checksums, bool transparent);

  void write(std::int64_t index, image::ImageView picture) override;
  void finish() override {}

 private:
  image::PngWriter takeWriter();

  store::FrameChecksums* checksums_;
  bool transparent_;
  std::mutex mutex_;
  /// Grows to the largest number of threads that wrote at once.
  std::vector<image::PngWriter> idleWriters_;
};

/// Writes frames to a video, in the order of write().
class VideoSink : public FrameSink {
 public:
  /// Throws Error if the file or the encoder can't be opened.
  VideoSink(video::VideoFormat format, const std::filesystem::path& path,
            const video::VideoSettings& settings);

  void write(std::int64_t index, image::ImageView picture) override;
  void finish() override;
  /// Leaves a playable video of the frames so far.
  void finishAs(const std::filesystem::path& path) override;
  std::string encoderName() const override { return writer_.encoderName(); }

 private:
  system::AtomicFile file_;
  video::VideoWriter writer_;
};

/// Discards frames, to measure drawing alone.
class NullSink : public FrameSink {
 public:
  void write(std::int64_t /*index*/, image::ImageView /*picture*/) override {}
  void finish() override {}
};

/// Keeps a checksum of each frame's pixels. write() may be called from several threads at once, in
/// any order.
class HashSink : public FrameSink {
 public:
  void write(std::int64_t index, image::ImageView picture) override;
  void finish() override {}

  /// Returns the checksums by frame. Call it once all writers are done.
  const std::map<std::int64_t, std::string>& checksums() const { return checksums_; }

 private:
  std::mutex mutex_;
  std::map<std::int64_t, std::string> checksums_;
};

}  // namespace rotatebook::pipeline
