// MP4s whose stream has players change the pictures.
#pragma once

#include <filesystem>
#include <string>

namespace rotatebook::video::testing {

/// Writes a few pictures, encoded with `x264Params` ("tff=1" marks them as interlaced) and passed
/// through FFmpeg's `filter` of packets: "null", or one that adds messages. Throws MachineError.
void writeForgedStream(const std::filesystem::path& path, const std::string& x264Params,
                       const std::string& filter);

}  // namespace rotatebook::video::testing
