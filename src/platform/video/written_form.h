// Comparison of a clip's file with what the program's own muxers and encoders write.
#pragma once

#include <filesystem>
#include <string>

#include "video/clip_form.h"

namespace rotatebook::video {

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
