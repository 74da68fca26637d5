// Where frames are drawn: a multisampled buffer, resolved and read back a rectangle at a time.
#pragma once

#include "image/image.h"
#include "render/camera.h"
#include "render/gl_handles.h"

namespace rotatebook::render {

/// An off-screen sRGB frame buffer whose first row is the picture's top (see Projection).
class FrameTarget {
 public:
  /// Throws InputError if the size is over the driver's limit, MachineError if `samples` are not to
  /// be had.
  FrameTarget(int width, int height, int samples);

  /// Directs drawing to the pixels of `area`, whose colour and depth are to be overwritten first.
  void begin(const PixelRect& area);
  /// Resolves `area` and copies it to the same place of `picture` (Rgba8, this target's size).
  void readBack(const PixelRect& area, image::Image& picture);

  int width() const { return width_; }
  int height() const { return height_; }

 private:
  int width_;
  int height_;
  GlRenderbuffer sampledColour_, sampledDepth_, resolvedColour_;
  GlFramebuffer sampled_, resolved_;
};

}  // namespace rotatebook::render
