// Where frames are drawn: a multisampled buffer, resolved and read back a rectangle at a time.
#pragma once

#include "image/image.h"
#include "render/camera.h"
#include "render/gl_handles.h"

namespace rotatebook::render {

/// An off-screen sRGB frame buffer whose first row is the picture's top (see Projection).
class FrameTarget {
 public:
  /// Draws `supersample` (1 or 2) times as wide and high as the picture. Throws InputError if that
  /// is over the driver's limit, MachineError if `samples` are not to be had.
  FrameTarget(int width, int height, int samples, int supersample);

  /// Directs drawing to the pixels of `area`, whose colour and depth are to be overwritten first.
  void begin(const PixelRect& area);
  /// Resolves `area`, mixing in linear light, and copies it to the same place of `picture` (Rgba8,
  /// of the width and height given).
  void readBack(const PixelRect& area, image::Image& picture);

 private:
  int width_;
  int height_;
  int supersample_;
  GlRenderbuffer sampledColour_, sampledDepth_, resolvedColour_, pictureColour_;
  GlFramebuffer sampled_, resolved_, picture_;  // `picture_` only where it differs in size
};

}  // namespace rotatebook::render
