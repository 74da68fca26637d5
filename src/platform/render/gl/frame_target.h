// A frame buffer to draw frames in and read them back from, by rectangles. Inside the room only.
#pragma once

#include <span>
#include <string>

#include "geometry/hull_bands.h"
#include "image/image.h"
#include "render/gl/gl_handles.h"

namespace rotatebook::render {

/// An off-screen frame buffer. Its first row is the picture's top (see Projection).
class FrameTarget {
 public:
  /// The kinds of pixels: those of pictures, sRGB and alpha of 8 bits each, or the shaders' own
  /// values as floats.
  enum class Pixels { Picture, Exact };

  /// Throws InputError if the size is over the driver's limit, and MachineError if OpenGL refuses
  /// the frame buffer. [pixels]
  FrameTarget(int width, int height, Pixels pixels = Pixels::Picture);

  /// Binds the frame buffer, restricts drawing to `area` and clears its colour, alpha and depth.
  void begin(const geometry::PixelRect& area) const;
  /// Copies `areas` of `cell` to the same positions in `picture` (Rgba8, of the cell's size).
  void readBack(std::span<const geometry::PixelRect> areas, const geometry::PixelRect& cell,
                image::Image& picture) const;
  /// Likewise of the whole frame buffer.
  void readBack(std::span<const geometry::PixelRect> areas, image::Image& picture) const;
  /// Returns the alpha of one pixel, 0 to 255.
  int alphaAt(int x, int y) const;
  /// Returns the bytes of all pixels, 4 or, if they are Exact, 16 each.
  std::string bytes() const;

 private:
  int width_;
  int height_;
  Pixels pixels_;
  GlRenderbuffer colour_, depth_;
  GlFramebuffer buffer_;
};

}  // namespace rotatebook::render
