// Composes a drawn body and the background into a picture. Inside the room only.
#pragma once

#include <optional>
#include <vector>

#include "geometry/hull_bands.h"
#include "geometry/mesh.h"
#include "image/area.h"
#include "image/image.h"
#include "render/antialias/body_edges.h"
#include "render/antialias/edge_pixels.h"
#include "render/antialias/edge_samples.h"
#include "render/drawn_body.h"

namespace rotatebook::render {

/// Composes drawn bodies over a background, with antialiased edges. Needs no OpenGL; one thread at
/// a time.
class Compositor {
 public:
  /// `background`: Rgba8, straight alpha, of the pictures' size or twice as wide and high. Must
  /// outlive this.
  Compositor(const image::Image& background, bool isTwice, const geometry::Mesh& mesh);

  /// Composes a body, drawn in the background's size, with its top left at (x, y) of `picture`,
  /// which shows the background there, touching it alone. One with a background of its own replaces
  /// that, too.
  void compose(const DrawnBody& body, int x, int y, image::Image& picture);

 private:
  /// Composes a body over `picture`, which shows the background where the body may be.
  void composeOver(const image::Image& background, const DrawnBody& body,
                   const image::Pixels& picture);
  /// Copies what was drawn; adds meetings to edgePixels_.
  void copyDrawn(const DrawnBody& body, const image::Pixels& picture);
  void composeLarge(const image::Image& background, const std::vector<image::Area>& areas,
                    const DrawnBody& body, const image::Pixels& picture);

  const image::Image& background_;
  BodyEdges edges_;
  EdgePixels edgePixels_;
  std::vector<ScreenTriangle> triangles_;
  AlikeSurfaces alike_;
  EdgeSamples samples_;
  std::optional<image::Image> large_;  // The picture before it is halved, where the body may be.
};

}  // namespace rotatebook::render
