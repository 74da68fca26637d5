// Whether a video file is all there.
#pragma once

#include <filesystem>
#include <istream>
#include <string>

namespace rotatebook::video {

/// What to do about a clip that isn't as it was written, after the words that say so.
inline constexpr const char* kCopyRemedy = "; copy it again, or render it again";

/// Throws InputError for an MP4 or WebM that is shorter than its header tells, as a copy that was
/// broken off is. Says nothing of other files, nor of what can't be read.
void requireWholeFile(const std::filesystem::path& path);
/// The same of `file`'s bytes, be they what they may; `name` names it in messages.
void requireWholeFile(std::istream& file, const std::string& name);

}  // namespace rotatebook::video
