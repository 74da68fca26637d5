// A video file that is opened for reading. Inside the room only.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>

#include "base/clip_limits.h"
#include "video/ffmpeg.h"
#include "video/video_format.h"

namespace rotatebook::video {

/// Largest picture that is decoded: the largest clip's, whose sides are whole macroblocks of 16
/// pixels in the stream. [pixels]
inline constexpr std::int64_t kMaxDecodedPixels = kMaxPicturePixels + 2 * 15 * kMaxPictureSide;

/// FFmpeg's names of the decoders of our formats that have metadata.
inline constexpr const char* kDecoders = "h264,vp9,libvpx-vp9";

/// A file of one of our formats. Anybody may have made it: only their demuxers and
/// decoders read it, which open no other file.
class ClipInput {
 public:
  /// Throws InputError if the file can't be opened, or isn't of such a format.
  explicit ClipInput(const std::filesystem::path& path);
  /// From memory that outlives this; `name` names it in messages.
  ClipInput(std::span<const std::uint8_t> bytes, std::string name);
  ClipInput(const ClipInput&) = delete;
  ClipInput& operator=(const ClipInput&) = delete;

  VideoFormat format() const;
  /// The only stream, which must be of pictures. Throws InputError.
  AVStream& stream() const;
  /// Looks into the stream for what the container doesn't tell. Throws InputError.
  void probe();

  const std::string& name() const { return name_; }
  AVFormatContext& context() const { return *context_; }

 private:
  /// What is left of the memory to read.
  struct Memory {
    std::span<const std::uint8_t> bytes;
    std::size_t at = 0;
  };
  struct IoDeleter {
    void operator()(AVIOContext* io) const noexcept;
  };
  struct InputCloser {
    void operator()(AVFormatContext* context) const noexcept { avformat_close_input(&context); }
  };

  static int readMemory(void* memory, std::uint8_t* buffer, int size);
  static std::int64_t seekMemory(void* memory, std::int64_t offset, int whence);
  void open(AVFormatContext* context, const std::string& url);

  std::string name_;
  Memory memory_;
  std::unique_ptr<AVIOContext, IoDeleter> io_;
  std::unique_ptr<AVFormatContext, InputCloser> context_;
};

}  // namespace rotatebook::video
