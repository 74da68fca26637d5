// Text about one motion: a panel's label, the notice of divergence. Inside the room only.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "overlay/drawn_overlay.h"

namespace rotatebook::overlay {

/// Sets a panel's `label`, no wider than `width`, with a halo. [pixels] Throws InputError if the
/// font lacks a letter, or if the label takes too much of the panel.
Layer labelLayer(const OverlayContext& context, const std::string& label, double width);

enum class DivergenceText {
  Whole,  ///< "Diverged at t = 22.53 s"
  Brief,  ///< "Diverged at 22.53 s", in smaller letters.
};

/// Sets the notice of a divergence, no wider than `width`, with a halo. [pixels]
Layer divergenceLayer(const OverlayContext& context, double time, double width,
                      DivergenceText text);

/// Sets it in a dark box at the top left, below what is `taken` there; nothing if the picture
/// is too small for it.
std::optional<CachedLayer> divergenceNotice(const OverlayContext& context, double time,
                                            const std::vector<Box>& taken);

}  // namespace rotatebook::overlay
