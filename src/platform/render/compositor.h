// From a drawn book to a picture of it. Inside the room only.
#pragma once

#include <vector>

#include "image/image.h"
#include "render/antialias/body_edges.h"
#include "render/antialias/edge_pixels.h"
#include "render/antialias/edge_samples.h"
#include "render/book/book_mesh.h"
#include "render/drawn_body.h"

namespace rotatebook::render {

/// Lays drawn books over a background, with smooth edges. Needs no OpenGL; one thread at a time.
class Compositor {
 public:
  /// `background`: Rgba8, alpha straight, `supersample` (1 or 2) times as wide and high as pictures
  /// are to be.
  Compositor(image::Image background, int supersample, const BookMesh& mesh);

  /// A picture of the right size and format for compose().
  image::Image makePicture() const;
  /// Over all of `picture`, from makePicture(). `body` is of the background's size.
  void compose(const DrawnBody& body, image::Image& picture);

 private:
  void composeLarge(const DrawnBody& body, image::Image& picture);

  image::Image background_;
  int supersample_;
  BodyEdges edges_;
  EdgePixels edgePixels_;
  std::vector<ScreenTriangle> triangles_;
  EdgeSamples samples_;
  image::Image large_;  // before it is made smaller, if it is
};

}  // namespace rotatebook::render
