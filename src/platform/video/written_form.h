// Comparison of a clip's file with what the program's own muxers and encoders write.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "base/frame_rate.h"

namespace rotatebook::video {

/// The settings that the file of a clip follows from, beside its coded pictures, title and comment.
struct WrittenForm {
  int width = 0;   ///< [pixels]
  int height = 0;  ///< [pixels]
  FrameRate frameRate{};
  std::int64_t frames = 0;   ///< The number of pictures.
  bool transparent = false;  ///< The pictures have alpha.
};

/// The coded pictures of a file.
struct Payload {
  std::size_t count = 0;            ///< The number of packets.
  std::uint64_t size = 0;           ///< Of all packets. [bytes]
  std::vector<std::size_t> keys{};  ///< Indices of those that are key frames, ascending.
};

/// The first differences of a file from what VideoWriter writes; empty if there are none.
struct FormDifferences {
  std::string container{};  ///< "moov/trak/tkhd differs", "Segment holds one Tracks too many"
  std::string stream{};     ///< "picture 3 holds a NAL unit of type 9"
};

/// Compares the MP4 or WebM `clip` with what VideoWriter writes for `form`: with its boxes or
/// elements, each as often as it writes them and with all fields, and with the units that its
/// encoder codes pictures in. Other muxers and encoders than FFmpeg's, libx264 and libvpx may have
/// players do what FFmpeg doesn't report. Throws InputError if the file can't be read.
FormDifferences differencesFromWritten(const std::filesystem::path& clip, const WrittenForm& form);

}  // namespace rotatebook::video
