#include "physics/free_motion.h"

#include <algorithm>

namespace rotatebook::physics {

Eigen::Vector3d momentumAlong(const rigid::PrincipalAxes& axes, const Sample& sample) {
  return axes.bodyFromPrincipal.transpose() *
         (sample.attitude.conjugate() * sample.angularMomentum);
}

std::vector<std::size_t> freeStarts(std::span<const Sample> samples,
                                    std::span<const Nudge> nudges) {
  std::vector<std::size_t> starts{0};
  for (const Nudge& nudge : nudges) {
    const auto after = std::ranges::lower_bound(samples, nudge.at, {}, &Sample::time);
    const auto start = static_cast<std::size_t>(after - samples.begin());
    if (after != samples.end() && start > starts.back()) starts.push_back(start);
  }
  return starts;
}

}  // namespace rotatebook::physics
