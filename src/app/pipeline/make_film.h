// Makes films of maps: frame by frame, on threads, and on from where an earlier run stopped.
#pragma once

#include <cstddef>

#include "pipeline/make_map.h"
#include "scene/scene.h"
#include "store/map_files.h"

namespace rotatebook::pipeline {

/// The outcome of makeFilm().
struct MadeFilm {
  std::size_t frames = 0;    ///< All of them.
  std::size_t found = 0;     ///< Of these, the number that was left by an earlier run.
  std::size_t finished = 0;  ///< Of these, the number that is done.
  bool isWhole = false;      ///< The video is there.
  bool wasDone = false;      ///< It was there: nothing was written.
};

/// Throws InputError if the scene has no film, or the folder holds another one, or frames of an
/// unfinished one, that must not be lost. Changes nothing.
void requireMayReplaceFilm(const scene::Scene& scene, const store::MapFiles& files,
                           const MapOptions& options);

/// Makes the film of a scene's map as an MP4. Each frame is on the disk once it is done, until all
/// are. The bytes are the same for any number of threads. Throws like requireMayReplaceFilm(), and
/// MachineError.
MadeFilm makeFilm(const scene::Scene& scene, const store::MapFiles& files,
                  const MapOptions& options);

}  // namespace rotatebook::pipeline
