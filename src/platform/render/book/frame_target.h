// Where frames are drawn, and from where they are read back a rectangle at a time. Inside the room
// only.
#pragma once

#include <span>

#include "image/image.h"
#include "render/antialias/hull_bands.h"
#include "render/book/gl_handles.h"

namespace rotatebook::render {

/// An off-screen sRGB frame buffer whose first row is the picture's top (see Projection).
class FrameTarget {
 public:
  /// Throws InputError if the size is over the driver's limit. [pixels]
  FrameTarget(int width, int height);

  /// Directs drawing to `area`, where it clears colour, alpha and depth.
  void begin(const PixelRect& area) const;
  /// Copies `areas` to the same places of `picture` (Rgba8, of the width and height given).
  void readBack(std::span<const PixelRect> areas, image::Image& picture) const;
  /// Of one pixel, 0 to 255.
  int alphaAt(int x, int y) const;

 private:
  int width_;
  int height_;
  GlRenderbuffer colour_, depth_;
  GlFramebuffer buffer_;
};

}  // namespace rotatebook::render
