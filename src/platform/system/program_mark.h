// The mark by which pictures without a record are known as the program's.
#pragma once

#include <filesystem>
#include <string>

namespace rotatebook::system {

/// Adds the mark to the bytes of a complete PNG, APNG, GIF, SVG or PDF: before its end a chunk
/// "Software: rotatebook" (PNG specification, 11.3.4.3), or a comment (GIF89a, 24). Throws
/// std::logic_error if they end otherwise.
void addProgramMark(std::string& bytes);
/// Adds it to such a file in place. Throws MachineError if it can't be read or written.
void addProgramMark(const std::filesystem::path& file);
/// Adds it to a complete MP4 or MOV in place: at its end a box `free` (ISO/IEC 14496-12, 8.1.2).
/// Throws MachineError if it can't be written.
void addProgramBox(const std::filesystem::path& file);
/// Adds the mark to the bytes, and writes them by writeFileAtomically().
void writeMarked(const std::filesystem::path& file, std::string bytes);

/// Returns whether a file ends with the mark, or did before a few bytes were added.
bool hasProgramMark(const std::filesystem::path& file);

}  // namespace rotatebook::system
