// Smooth edges for a picture that was drawn with one sample a pixel. Inside the room only.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "image/image.h"
#include "render/antialias/edge_pixels.h"
#include "render/antialias/strips.h"
#include "render/book/book_mesh.h"

namespace rotatebook::render {

/// A triangle as a picture has it.
struct ScreenTriangle {
  std::array<Eigen::Vector3f, 3> corners;  ///< x and y in pixels, and a depth linear in them.
  /// BookVertex::surfaceId; of a narrow strip kMaxSurfaceId + 1 + its number.
  float surfaceId = 0;
};

/// Samples along edges only: finds what kSamples places of each of some pixels show, and mixes the
/// light of those surfaces as it was drawn there or close by.
class EdgeSamples {
 public:
  static constexpr int kSamples = 16;  ///< A pixel.

  /// `drawn`: Rgba8, alpha is the number of the surface, 0 where nothing was drawn. `picture`, of
  /// the same size, Rgba8, alpha straight, shows it over `background`, which is likewise; its
  /// `pixels` get their mean colours.
  void resolve(const EdgePixels& pixels, std::span<const ScreenTriangle> triangles,
               const image::Image& drawn, const DrawnStrips& strips, const image::Image& background,
               image::Image& picture);

 private:
  // Arithmetic with four values at once is one instruction.
  using Four [[gnu::vector_size(4 * sizeof(float))]] = float;
  using Samples = std::array<Four, kSamples / 4>;

  void cover(const EdgePixels& pixels, const ScreenTriangle& triangle);
  /// Whether all samples of a pixel show one surface.
  static bool isOne(const Samples& surfaces);

  std::vector<Samples> depths_, surfaces_;  // by the pixels' numbers
};

}  // namespace rotatebook::render
