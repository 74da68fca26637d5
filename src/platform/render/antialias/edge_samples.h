// Antialiases the edges of a picture drawn with one sample a pixel. Inside the room only.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "geometry/mesh.h"
#include "image/image.h"
#include "render/antialias/edge_pixels.h"
#include "render/antialias/strips.h"
#include "render/antialias/surface_colours.h"

namespace rotatebook::render {

/// A triangle projected onto a picture.
struct ScreenTriangle {
  std::array<Eigen::Vector3f, 3> corners;  ///< x and y [pixels], and a depth linear in them.
  /// MeshVertex::surfaceId, or kMaxSurfaceId + 1 + the strip's number for a narrow strip.
  float surfaceId = 0;
};

/// Multisamples the pixels along edges only: finds the surface that each of kSamples points of a
/// pixel shows, and mixes those surfaces' linear light as it was drawn there or close by.
class EdgeSamples {
 public:
  static constexpr int kSamples = 16;  ///< Per pixel.
  using Samples = std::array<float, kSamples>;
  using Surfaces = std::array<std::int32_t, kSamples>;

  /// Depths of a pixel's samples, and the surfaces that they show, 0 for none.
  struct PixelSamples {
    Samples depths;
    Surfaces surfaces;
  };

  /// `alike`: of the body's surfaces.
  explicit EdgeSamples(const AlikeSurfaces& alike) : alike_(alike) {}

  /// Replaces those of `picture`'s pixels that are among `pixels` by the mean of their samples.
  /// `drawn`: Rgba8, alpha is the surface's number, 0 where nothing was drawn. `picture` shows it
  /// over `background`, which has its size; both are Rgba8 with straight alpha.
  void resolve(const EdgePixels& pixels, std::span<const ScreenTriangle> triangles,
               const image::Image& drawn, const DrawnStrips& strips, const image::Image& background,
               const image::Pixels& picture);

 private:
  void rasterise(const EdgePixels& pixels, const ScreenTriangle& triangle);

  AlikeSurfaces alike_;
  std::vector<PixelSamples> pixels_;  // By their numbers.
};

}  // namespace rotatebook::render
