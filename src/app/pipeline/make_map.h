// Makes maps: tile by tile, on threads, and on from where an earlier run stopped.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "pipeline/map_options.h"
#include "scene/scene.h"
#include "store/map_files.h"
#include "study/map_result.h"

namespace rotatebook::pipeline {

/// The outcome of makeMap().
struct MadeMap {
  study::MapResult result;
  bool isWhole = true;       ///< False after a stop: some values are missing, but kept as tiles.
  std::size_t tiles = 0;     ///< All of them, or of the part.
  std::size_t found = 0;     ///< Of these, the number that was left by an earlier run.
  std::size_t finished = 0;  ///< Of these, the number that is done.
};

/// Throws InputError if the folder holds what must not be lost: tiles of an unfinished map, or the
/// values of other settings. Changes nothing.
void requireMayReplaceMap(const scene::Scene& scene, const store::MapFiles& files,
                          const MapOptions& options);

/// Makes all runs of a scene's map, or those of a part. Each tile is on the disk once it is done.
/// Throws like requireMayReplaceMap(), and MachineError.
MadeMap makeMap(const scene::Scene& scene, const study::MapRuns& runs, const store::MapFiles& files,
                const MapOptions& options);

/// Writes the pictures, the values and their axes, and removes the tiles. Returns the files that
/// were written. Takes so many threads; 0 for one per core. Throws MachineError.
std::vector<std::string> writeMap(const scene::Scene& scene, const study::MapRuns& runs,
                                  const study::MapResult& result, const store::MapFiles& files,
                                  int threads = 0);

}  // namespace rotatebook::pipeline
