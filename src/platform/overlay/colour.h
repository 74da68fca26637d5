// Colours of overlays. Inside the room only.
#pragma once

namespace rotatebook::overlay {

/// An opaque colour, sRGB, each channel from 0 to 1.
struct Colour {
  double red = 1, green = 1, blue = 1;
};

}  // namespace rotatebook::overlay
