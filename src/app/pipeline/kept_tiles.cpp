#include "pipeline/kept_tiles.h"

#include <fmt/core.h>

#include "base/error.h"
#include "system/atomic_file.h"

namespace rotatebook::pipeline {

void requireMayGoOn(const store::MapTiles& kept, const MapOptions& options, const std::string& work,
                    std::string (*parts)(std::size_t count)) {
  const store::MapTiles::Count tiles = kept.count();
  if (tiles.other > 0) {
    throw InputError(
        fmt::format("{} holds {} of an unfinished {} with other settings, or another build of this "
                    "program; discard them with --overwrite, or name another folder with -o",
                    kept.folder().string(), parts(tiles.other), work));
  }
  if (tiles.same > 0 && !options.resume && !options.part) {
    throw InputError(
        fmt::format("{} holds {} of this {}, which isn't finished; go on with --resume, or begin "
                    "anew with --overwrite",
                    kept.folder().string(), parts(tiles.same), work));
  }
}

void makeRoom(const store::MapTiles& kept, const MapOptions& options) {
  if (options.overwrite && (!options.resume || kept.count().other > 0)) kept.remove();
  system::createFolders(kept.folder());
}

}  // namespace rotatebook::pipeline
