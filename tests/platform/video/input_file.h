// A video file, opened for reading by FFmpeg.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>

#include "video/ffmpeg.h"

namespace rotatebook::video::testing {

struct InputCloser {
  void operator()(AVFormatContext* context) const noexcept { avformat_close_input(&context); }
};
using InputFile = std::unique_ptr<AVFormatContext, InputCloser>;

/// Throws std::runtime_error if it has not exactly one stream, MachineError if it can't be read.
InputFile openFile(const std::filesystem::path& path);

/// Decodes all of the file: calls `ofPacket` with each packet and `ofFrame` with each frame, as
/// they come. Throws MachineError at any flaw of the stream.
void decode(const InputFile& file, const std::function<void(const AVPacket&)>& ofPacket,
            const std::function<void(const AVFrame&)>& ofFrame);

}  // namespace rotatebook::video::testing
