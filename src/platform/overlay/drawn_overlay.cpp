#include "overlay/drawn_overlay.h"

#include <algorithm>

namespace rotatebook::overlay {

std::vector<std::size_t> freeStarts(const OverlayContext& context) {
  std::vector<std::size_t> starts{0};
  const auto& samples = context.trajectory.samples;
  for (const physics::Nudge& nudge : context.scene.motions[0].nudges) {
    const auto after = std::ranges::lower_bound(samples, nudge.at, {}, &physics::Sample::time);
    const auto start = static_cast<std::size_t>(after - samples.begin());
    if (after != samples.end() && start > starts.back()) starts.push_back(start);
  }
  return starts;
}

std::unique_ptr<DrawnOverlay> makeOverlay(scene::Overlay overlay, const OverlayContext& context,
                                          const Box& box) {
  switch (overlay) {
#define ROTATEBOOK_OVERLAY(enumerator, word, models, placement)                 \
  case scene::Overlay::enumerator:                                              \
    if constexpr (scene::Placement::placement != scene::Placement::WholeClip) { \
      return make##enumerator(context, box);                                    \
    }                                                                           \
    break;
#include "scene/overlay_list.inc"
#undef ROTATEBOOK_OVERLAY
  }
  return nullptr;
}

}  // namespace rotatebook::overlay
