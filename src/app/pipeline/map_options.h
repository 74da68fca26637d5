// Options of the making of maps and of their films.
#pragma once

#include <optional>

#include "store/clip_files.h"
#include "system/parallel_runs.h"

namespace rotatebook::pipeline {

/// Options of makeMap() and makeFilm().
struct MapOptions {
  /// Threads, stop, and progress in tiles.
  system::RunOptions execution{};
  bool resume = false;     ///< Go on with tiles, or keep values, that the same settings left.
  bool overwrite = false;  ///< Discard those of other settings; without `resume`, all.
  /// Only this part of the tiles, which goes on with what is there: others may be made elsewhere at
  /// the same time. Excludes `overwrite`.
  std::optional<store::ClipPart> part{};
};

}  // namespace rotatebook::pipeline
