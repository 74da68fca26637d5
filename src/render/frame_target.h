// Where frames are drawn: a multisampled buffer, resolved and read back a rectangle at a time.
#pragma once

#include <span>

#include "image/image.h"
#include "render/gl_handles.h"
#include "render/hull_bands.h"

namespace rotatebook::render {

/// An off-screen sRGB frame buffer whose first row is the picture's top (see Projection).
class FrameTarget {
 public:
  /// Draws `supersample` (1 or 2) times as wide and high as the picture. Throws InputError if that
  /// is over the driver's limit, MachineError if `samples` are not to be had.
  FrameTarget(int width, int height, int samples, int supersample);

  /// Directs drawing here, where colour and depth are left from before and to be overwritten first.
  void begin() const;
  /// Keeps what is drawn from now on within `area`.
  void confineTo(const PixelRect& area) const;
  /// Resolves `areas`, mixing in linear light, and copies each to the same place of `picture`
  /// (Rgba8, of the width and height given).
  void readBack(std::span<const PixelRect> areas, image::Image& picture);

 private:
  int width_;
  int height_;
  int supersample_;
  GlRenderbuffer sampledColour_, sampledDepth_, resolvedColour_, pictureColour_;
  GlFramebuffer sampled_, resolved_, picture_;  // `picture_` only where it differs in size
};

}  // namespace rotatebook::render
