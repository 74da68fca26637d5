// The pictures of a clip, in any order.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "image/image.h"
#include "overlay/overlays.h"
#include "pipeline/clip_motion.h"
#include "render/renderer.h"
#include "scene/scene.h"

namespace rotatebook::pipeline {

/// Draws frame n of a scene: the book, and what is written over it. Owns an OpenGL context; see
/// render::Renderer.
class FrameDrawer {
 public:
  /// `motion`, the scene's, must outlive this. Throws as loadTextures(),
  /// overlay::Overlays and render::Renderer do.
  FrameDrawer(const scene::Scene& scene, const ClipMotion& motion);

  /// A picture of the right size and format for draw().
  image::Image makePicture() const { return renderer_.makePicture(); }
  /// Draws over all of `picture`; `frame` is 0 to below motion.frameCount().
  void draw(std::int64_t frame, image::Image& picture);
  /// render::Renderer::description()
  const std::string& description() const { return renderer_.description(); }

 private:
  const ClipMotion* motion_;
  std::optional<overlay::Overlays> overlays_;
  render::Renderer renderer_;
};

}  // namespace rotatebook::pipeline
