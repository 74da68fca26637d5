// A video file, opened for reading by FFmpeg.
#pragma once

#include <filesystem>
#include <memory>

#include "video/ffmpeg.h"

namespace rotatebook::video::testing {

struct InputCloser {
  void operator()(AVFormatContext* context) const noexcept { avformat_close_input(&context); }
};
using InputFile = std::unique_ptr<AVFormatContext, InputCloser>;

/// Throws std::runtime_error if it has not exactly one stream, MachineError if it can't be read.
InputFile openFile(const std::filesystem::path& path);

/// One that takes any flaw of the stream for an error.
Handle<AVCodecContext> openDecoder(const AVCodecParameters& parameters);

}  // namespace rotatebook::video::testing
