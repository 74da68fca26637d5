// Where finished frames go.
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

/// Takes frames. Without finish() nothing of a sink's unfinished file stays.
class FrameSink {
 public:
  virtual ~FrameSink() = default;

  /// Takes frame `index`; the picture is only borrowed. Throws Error.
  virtual void write(std::int64_t index, image::ImageView picture) = 0;
  /// Completes what was written. Throws Error on a failed flush, trailer, close or rename.
  virtual void finish() = 0;
  /// Completes what was written so far as `partial`, instead of finish(), where a render is
  /// interrupted. A sink without a file of its own leaves what it has.
  virtual void finishAs(const std::filesystem::path& /*partial*/) {}
  /// The encoder in use, for example "libx264"; empty if there is none.
  virtual std::string encoderName() const { return ""; }
};

/// Writes each frame to its own PNG in one folder, and its checksum beside it. write() may be
/// called from several threads at once, in any order.
class PngSequenceSink : public FrameSink {
 public:
  /// `sums`, of the folder, must outlive this.
  PngSequenceSink(store::FrameChecksums& sums, bool transparent);

  void write(std::int64_t index, image::ImageView picture) override;
  void finish() override {}

 private:
  image::PngWriter takeWriter();

  store::FrameChecksums* sums_;
  bool transparent_;
  std::mutex mutex_;
  /// As many as threads have written at once.
  std::vector<image::PngWriter> idleWriters_;
};

/// Writes all frames, in order, to a video.
class VideoSink : public FrameSink {
 public:
  /// Throws Error if the file or the encoder can't be opened.
  VideoSink(video::VideoFormat format, const std::filesystem::path& path,
            const video::VideoSettings& settings);

  void write(std::int64_t index, image::ImageView picture) override;
  void finish() override;
  /// The clip of the frames so far is playable.
  void finishAs(const std::filesystem::path& path) override;
  std::string encoderName() const override { return writer_.encoderName(); }

 private:
  system::AtomicFile file_;
  video::VideoWriter writer_;
};

/// Takes frames and keeps nothing: what drawing alone takes.
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

  /// By frame; to be asked once the writers are done.
  const std::map<std::int64_t, std::string>& checksums() const { return checksums_; }

 private:
  std::mutex mutex_;
  std::map<std::int64_t, std::string> checksums_;
};

}  // namespace rotatebook::pipeline
