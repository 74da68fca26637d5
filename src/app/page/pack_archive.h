// Archives of pages for the web. Inside the room only.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace rotatebook::page {

/// Makes the ZIP archive `file` of the mark and the files `names` in `folder`, which aren't
/// compressed, as pictures and clips can't be, in the order of their names and without their times,
/// so that the same files make the same archive. Throws MachineError.
void writeZip(const std::filesystem::path& folder, std::vector<std::string> names,
              const std::filesystem::path& file);

/// Throws InputError if there is something at `file` that isn't an archive as --pack made it: one
/// with a mark, no files but those that the mark lists, with their checksums, and nothing else.
void requirePackArchive(const std::filesystem::path& file);

}  // namespace rotatebook::page
