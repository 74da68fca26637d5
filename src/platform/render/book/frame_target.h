// A frame buffer to draw frames in and read them back from, by rectangles. Inside the room only.
#pragma once

#include <span>

#include "geometry/hull_bands.h"
#include "image/image.h"
#include "render/book/gl_handles.h"

namespace rotatebook::render {

/// An off-screen sRGB frame buffer. Its first row is the picture's top (see Projection).
class FrameTarget {
 public:
  /// Throws InputError if the size is over the driver's limit, and MachineError if OpenGL refuses
  /// the frame buffer. [pixels]
  FrameTarget(int width, int height);

  /// Binds the frame buffer, restricts drawing to `area` and clears its colour, alpha and depth.
  void begin(const geometry::PixelRect& area) const;
  /// Copies `areas` to the same positions in `picture` (Rgba8, of the frame buffer's size).
  void readBack(std::span<const geometry::PixelRect> areas, image::Image& picture) const;
  /// Returns the alpha of one pixel, 0 to 255.
  int alphaAt(int x, int y) const;

 private:
  int width_;
  int height_;
  GlRenderbuffer colour_, depth_;
  GlFramebuffer buffer_;
};

}  // namespace rotatebook::render
