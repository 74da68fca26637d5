#include "timeline/free_pieces.h"

#include <algorithm>

namespace rotatebook::timeline {

std::vector<std::span<const physics::Sample>> freePieces(const physics::Trajectory& trajectory,
                                                         std::span<const physics::Nudge> nudges) {
  std::vector<std::span<const physics::Sample>> pieces;
  auto start = trajectory.samples.begin();
  const auto addUpTo = [&](auto end) {
    if (end != start) pieces.push_back({start, end});
    start = end;
  };
  for (const physics::Nudge& nudge : nudges) {
    addUpTo(std::ranges::lower_bound(start, trajectory.samples.end(), nudge.at, {},
                                     &physics::Sample::time));
  }
  addUpTo(trajectory.samples.end());
  return pieces;
}

}  // namespace rotatebook::timeline
