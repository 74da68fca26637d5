// A video file that is open for reading. Inside the room only.
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

/// Largest picture that is decoded: the largest clip's, whose sides are rounded up to macroblocks
/// of 16 pixels in the stream. [pixels]
inline constexpr std::int64_t kMaxDecodedPixels = kMaxPicturePixels + 2 * 15 * kMaxPictureSide;

/// A file in one of our formats. Anybody may have made it, so only the demuxers and decoders of
/// these formats read it, which open no other file.
class ClipInput {
 public:
  /// Opens the file. Throws InputError if it can't be opened or isn't in such a format; the message
  /// lists those that have the property `wanted`, or all.
  explicit ClipInput(const std::filesystem::path& path,
                     bool FormatRow::*wanted = &FormatRow::holdsRecord);
  /// Reads memory, which must outlive this object; `name` is for messages.
  ClipInput(std::span<const std::uint8_t> bytes, std::string name);
  ClipInput(const ClipInput&) = delete;
  ClipInput& operator=(const ClipInput&) = delete;

  VideoFormat format() const;
  /// Returns the only stream. Throws InputError unless there is exactly one, of video.
  AVStream& stream() const;
  /// Reads from the stream what the container doesn't state. Throws InputError.
  void probe();

  const std::string& name() const { return name_; }
  AVFormatContext& context() const { return *context_; }

 private:
  /// The memory to read, and the position in it.
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
  void open(AVFormatContext* context, const std::string& url, bool FormatRow::*wanted);
  bool beginsAsClip() const;

  std::string name_;
  Memory memory_;
  std::unique_ptr<AVIOContext, IoDeleter> io_;
  std::unique_ptr<AVFormatContext, InputCloser> context_;
};

}  // namespace rotatebook::video
