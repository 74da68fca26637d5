#include "overlay/drawn_overlay.h"

namespace rotatebook::overlay {

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
