// MP4s whose stream has players change the pictures.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "video/video_format.h"

namespace rotatebook::video::testing {

/// Writes a few pictures, encoded with `x264Params` ("tff=1" marks them as interlaced) and passed
/// through FFmpeg's `filter` of packets: "null", or one that adds messages; from the second key
/// frame on through `laterFilter`, if there is one. Throws MachineError.
void writeForgedStream(const std::filesystem::path& path, const std::string& x264Params,
                       const std::string& filter, const std::string& laterFilter = "");

/// Returns the parameters of such a stream, as an MP4 holds them. Throws MachineError.
std::string forgedParameters(const std::string& x264Params, const std::string& filter);

/// Writes a few pictures in `format` as VideoWriter does, each packet's bytes changed by `change`,
/// which gets their index. Throws MachineError.
void writeChangedStream(const std::filesystem::path& path, VideoFormat format,
                        const std::function<void(std::string& packet, int index)>& change);

}  // namespace rotatebook::video::testing
