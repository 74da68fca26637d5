// The pictures of a clip, in any order.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "image/image.h"
#include "overlay/overlays.h"
#include "physics/trajectory.h"
#include "render/renderer.h"
#include "scene/scene.h"

namespace rotatebook::pipeline {

/// Draws frame n of a scene: the book, and what is written over it. Owns an OpenGL context; see
/// render::Renderer.
class FrameDrawer {
 public:
  /// `trajectory`, the scene's motion, must outlive this. Throws as loadTextures(),
  /// overlay::Overlays and render::Renderer do.
  FrameDrawer(const scene::Scene& scene, const physics::Trajectory& trajectory);

  /// A picture of the right size and format for draw().
  image::Image makePicture() const { return renderer_.makePicture(); }
  /// Draws over all of `picture`; `frame` is one of the trajectory's samples.
  void draw(std::int64_t frame, image::Image& picture);
  /// render::Renderer::description()
  const std::string& description() const { return renderer_.description(); }

 private:
  const physics::Trajectory* trajectory_;
  std::optional<overlay::Overlays> overlays_;
  render::Renderer renderer_;
};

}  // namespace rotatebook::pipeline
