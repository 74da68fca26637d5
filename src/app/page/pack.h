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

/// A page for the web.
struct Pack {
  std::filesystem::path results{};  ///< The folder with the figures' files.
  /// The folder, or, if it ends in .zip, the archive to write.
  std::filesystem::path target{};
  int crf = kPackCrf;
};

/// Returns all files that packing `figures` writes, removes or replaces.
std::vector<std::filesystem::path> filesOfPack(const std::vector<Figure>& figures,
                                               const Pack& pack);

/// Throws InputError if something would be replaced that isn't as an earlier pack left it, or the
/// target is the folder with the results. Changes nothing.
void requirePackable(const std::vector<Figure>& figures, const Pack& pack);

/// Writes what `figures`, which were read as packed, show: clips coded anew, which keep their
/// records, pictures of books as WebP, the rest as it is, and at last the page `html`. Clips that
/// an interrupted run has left are kept. Throws InputError, as requirePackable() does and for clips
/// that can't be read, and MachineError.
void writePack(const std::vector<Figure>& figures, const std::string& html, const Pack& pack,
               const PackProgress& progress = {});

}  // namespace rotatebook::page
