// Verifies that a video file isn't truncated.
#pragma once

#include <filesystem>
#include <istream>
#include <string>

namespace rotatebook::video {

/// Remedy for a clip that isn't as it was written, the end of a message.
inline constexpr const char* kCopyRemedy = "; copy it again, or render it again";

/// Throws InputError for an MP4 or WebM that is shorter than its header states, as an interrupted
/// copy is. Ignores other files, and those that can't be read.
void requireWholeFile(const std::filesystem::path& path);
/// Like requireWholeFile(path), for a stream whose bytes may be anything; `name` is for messages.
void requireWholeFile(std::istream& file, const std::string& name);

}  // namespace rotatebook::video
