// Layers with text. Inside the room only.
#pragma once

#include <vector>

#include "image/layer.h"
#include "overlay/box.h"

namespace rotatebook::overlay {

using image::Layer;
using image::LayerView;

/// A layer that is the same in each frame, and the boxes of the text on it.
struct CachedLayer {
  Layer layer;
  std::vector<Box> texts;
};

}  // namespace rotatebook::overlay
