#include "timeline/free_pieces.h"

#include <algorithm>
#include <cstddef>

namespace rotatebook::timeline {

std::vector<std::span<const physics::Sample>> freePieces(const physics::Trajectory& trajectory,
                                                         std::span<const physics::Nudge> nudges) {
  std::vector<std::span<const physics::Sample>> pieces;
  std::span<const physics::Sample> rest = trajectory.samples;
  for (const physics::Nudge& nudge : nudges) {
    const auto end = std::ranges::lower_bound(rest, nudge.at, {}, &physics::Sample::time);
    const auto count = static_cast<std::size_t>(end - rest.begin());
    if (count > 0) pieces.push_back(rest.first(count));
    rest = rest.subspan(count);
  }
  if (!rest.empty()) pieces.push_back(rest);
  return pieces;
}

}  // namespace rotatebook::timeline
