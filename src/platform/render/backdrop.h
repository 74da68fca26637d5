// Draws what is behind the bodies. Inside the room only.
#pragma once

#include <optional>

#include <Eigen/Core>

#include "image/image.h"
#include "render/gl/frame_target.h"
#include "render/gl/shader_program.h"
#include "render/render_settings.h"

namespace rotatebook::render {

/// The background of pictures: the studio's wall, the night sky, one colour, or nothing.
class Backdrop {
 public:
  /// Needs a current OpenGL context, also for draw().
  explicit Backdrop(const RenderSettings& settings);

  /// Returns whether it looks otherwise to a camera that turns.
  bool hasDirections() const { return shaders_.has_value(); }
  /// Draws over all of `picture` (Rgba8), by way of `target`, both as large as the drawing.
  /// `skyFromPicture` is geometry::skyFromPicture(), 0 for a camera that doesn't turn.
  void draw(const FrameTarget& target, const Eigen::Matrix4f& skyFromPicture,
            image::Image& picture) const;

 private:
  const RenderSettings& settings_;
  std::optional<ShaderProgram> shaders_;  // Of the wall or the sky.
};

}  // namespace rotatebook::render
