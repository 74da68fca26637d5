// The book drawn with several samples a pixel by OpenGL alone, to compare the renderer's with.
#pragma once

#include <memory>
#include <vector>

#include "render/renderer.h"

namespace rotatebook::render::testing {

/// Draws what a Renderer of the same settings (without supersampling) and textures does, with its
/// shaders, mesh and projection. Owns an OpenGL context: only one of both at a time.
class SampledBook {
 public:
  SampledBook(const RenderSettings& settings, const BookTextures& textures);
  ~SampledBook();

  /// Returns the colours of OpenGL's four samples a pixel; alpha is 0 where the book isn't. A
  /// triangle is shaded once a pixel for all of the samples that it covers.
  std::vector<image::Image> multisampled(const body::Cage& corners);
  /// One sample a pixel, likewise.
  image::Image drawn(const body::Cage& corners);

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

/// The mean light of samples over a background, which is opaque.
image::Image meanLight(const std::vector<image::Image>& samples, const image::Image& background);

}  // namespace rotatebook::render::testing
