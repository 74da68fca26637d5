// Composes a drawn body and the background into a picture. Inside the room only.
#pragma once

#include <vector>

#include "geometry/hull_bands.h"
#include "geometry/mesh.h"
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
  /// `background`: Rgba8, straight alpha, `supersample` (1 or 2) times as wide and high as the
  /// pictures. Must outlive this.
  Compositor(const image::Image& background, int supersample, const geometry::Mesh& mesh);

  /// Returns a picture of the right size and format for compose().
  image::Image makePicture() const;
  /// Overwrites all of `picture`; one of another size or format becomes makePicture()'s. `body` has
  /// the background's size.
  void compose(const DrawnBody& body, image::Image& picture);

 private:
  geometry::PixelRect wholePicture() const {
    return {0, 0, background_.width(), background_.height()};
  }
  /// Composes a body over a background, which it `copies` to `picture`, unless that shows it
  /// already where the body may be.
  void composeOver(const image::Image& background, const DrawnBody& body, bool copies,
                   image::Image& picture);
  /// Copies the background, if there is one, and what was drawn; adds meetings to edgePixels_.
  void copyRows(const image::Image* background, const DrawnBody& body, image::Image& picture);

  const image::Image& background_;
  int supersample_;
  BodyEdges edges_;
  EdgePixels edgePixels_;
  std::vector<ScreenTriangle> triangles_;
  AlikeSurfaces alike_;
  EdgeSamples samples_;
  // If supersampled:
  image::Image large_;   // The picture before it is halved, where the body may be.
  image::Image halved_;  // The background.
};

}  // namespace rotatebook::render
