#include "timeline/free_pieces.h"

#include <cstddef>

#include "physics/free_motion.h"

namespace rotatebook::timeline {

std::vector<std::span<const physics::Sample>> freePieces(const physics::Trajectory& trajectory,
                                                         std::span<const physics::Nudge> nudges) {
  std::vector<std::span<const physics::Sample>> pieces;
  const std::span<const physics::Sample> all = trajectory.samples;
  std::vector<std::size_t> bounds = physics::freeStarts(all, nudges);
  bounds.push_back(all.size());
  for (std::size_t i = 1; i < bounds.size(); ++i) {
    if (bounds[i] > bounds[i - 1])
      pieces.push_back(all.subspan(bounds[i - 1], bounds[i] - bounds[i - 1]));
  }
  return pieces;
}

}  // namespace rotatebook::timeline
