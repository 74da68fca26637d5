// The page for the web: smaller files of its figures, in a folder or an archive.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "page/figure.h"

namespace rotatebook::page {

/// Rate factor of clips for the web, see docs/page.md for how it was chosen.
inline constexpr int kPackCrf = 33;

/// Called before each file that takes long, with its name.
using PackProgress = std::function<void(const std::string& file)>;

/// Writes what `figures`, which were read as packed from `folder`, show to `target`, an existing
/// folder: clips coded anew at `crf`, which keep their records, pictures of books as WebP, and the
/// rest as it is. Throws InputError and MachineError.
void packFiles(const std::vector<Figure>& figures, const std::filesystem::path& folder,
               const std::filesystem::path& target, int crf, const PackProgress& progress = {});

/// Makes the ZIP archive `file` of the files in `folder`, which aren't compressed, as pictures and
/// clips can't be, in the order of their names and without their times, so that the same files make
/// the same archive. Throws MachineError.
void writeZip(const std::filesystem::path& folder, const std::filesystem::path& file);

}  // namespace rotatebook::page
