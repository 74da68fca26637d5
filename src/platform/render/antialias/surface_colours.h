// Finds colours of surfaces that few pixels show, or none. Inside the room only.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "geometry/mesh.h"
#include "image/image.h"
#include "render/antialias/edge_pixels.h"

namespace rotatebook::render {

/// By surface, one of those of its material; 0 for numbers that no surface has.
using AlikeSurfaces = std::array<std::uint8_t, 256>;
AlikeSurfaces alikeSurfacesOf(const geometry::Mesh& mesh);

/// The colours of surfaces in one drawn picture.
class SurfaceColours {
 public:
  /// `drawn`: as in EdgeSamples::resolve(). All three are to outlive this.
  SurfaceColours(const AlikeSurfaces& alike, const EdgePixels& pixels, const image::Image& drawn)
      : alike_(alike), pixels_(pixels), drawn_(drawn) {}

  /// Returns the surface that was drawn at a pixel; 0 for none, and outside the picture.
  std::uint8_t surfaceAt(int x, int y) const {
    const bool within = x >= 0 && x < drawn_.width() && y >= 0 && y < drawn_.height();
    return within ? std::min(drawn_.row(y)[4 * x + 3], kHighest) : std::uint8_t{0};
  }

  /// Returns the colour of the nearest pixel that shows a surface, with any alpha. If none does
  /// close by, returns the surface's mean colour along edges; if no edge shows it, that of surfaces
  /// of its material; then the nearest of another material, the mean of the body, or null.
  const std::uint8_t* at(int x, int y, std::uint8_t surface);

 private:
  using Colour = std::array<std::uint8_t, 4>;  // Alpha 0 for none.

  const std::uint8_t* pixelAt(int x, int y) const {
    return drawn_.row(y) + 4 * static_cast<std::ptrdiff_t>(x);
  }

  /// Returns at() of a surface that no pixel shows.
  const std::uint8_t* ofAnother(int x, int y, std::uint8_t surface) const;
  void computeMeans();

  static constexpr std::uint8_t kHighest = geometry::kMaxSurfaceId;

  const AlikeSurfaces& alike_;
  const EdgePixels& pixels_;
  const image::Image& drawn_;
  bool hasMeans_ = false;  // Computed when first needed: seldom.
  // By surface, and by AlikeSurfaces, whose 0 is all of the body.
  std::array<Colour, kHighest + 1> means_{}, alikeMeans_{};
};

}  // namespace rotatebook::render
