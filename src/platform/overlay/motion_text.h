// Text about one motion: a panel's label, the notice of divergence. Inside the room only.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "overlay/drawn_overlay.h"

namespace rotatebook::overlay {

/// Sets `label` at `position`, no wider than `width`, with a halo. [pixels] Throws InputError if
/// the font lacks a letter, or if the label leaves too little of the picture.
CachedLayer labelLayer(const OverlayContext& context, const std::string& label,
                       const Point& position, double width);

/// Sets "Diverged at t = 22.53 s" in a dark box, centred at the top, below what is `taken` there;
/// nothing if the picture is too small for it.
std::optional<CachedLayer> divergenceNotice(const OverlayContext& context, double time,
                                            const std::vector<Box>& taken);

}  // namespace rotatebook::overlay
