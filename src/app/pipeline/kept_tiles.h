// Tiles that an earlier run left of a map, or of a film of it. Inside the room only.
#pragma once

#include <cstddef>
#include <string>

#include "pipeline/map_options.h"
#include "store/map_tiles.h"

namespace rotatebook::pipeline {

/// Throws InputError if there are tiles that must not be lost: of other settings, or without
/// MapOptions::resume or part. `work` is "map" or "film", and `parts` names so many tiles.
void requireMayGoOn(const store::MapTiles& kept, const MapOptions& options, const std::string& work,
                    std::string (*parts)(std::size_t count));

/// Discards what MapOptions::overwrite says, and makes the folder.
void makeRoom(const store::MapTiles& kept, const MapOptions& options);

}  // namespace rotatebook::pipeline
