// The interface for drawing a clip's frame in two steps.
#pragma once

#include <cstdint>
#include <vector>

#include "image/image.h"
#include "render/drawn_body.h"

namespace rotatebook::picture {

/// A frame's bodies as OpenGL drew them: one, or one in each panel.
struct Exposure {
  std::int64_t frame = 0;
  std::vector<render::DrawnBody> bodies;
  std::vector<image::Image> blurred;  ///< Replaces `bodies` if there is motion blur.
};

/// Paints frame n of a clip in two steps: one that needs OpenGL, and the rest, which another thread
/// may do while this one exposes the next frame.
class FramePainter {
 public:
  FramePainter() = default;
  FramePainter(const FramePainter&) = delete;
  FramePainter& operator=(const FramePainter&) = delete;
  virtual ~FramePainter() = default;

  /// Returns a picture of the right size and format for compose().
  virtual image::Image makePicture() const = 0;
  /// Returns an exposure for expose().
  virtual Exposure makeExposure() const = 0;

  /// Does the first step for frame `frame`, replacing all of `exposure`.
  virtual void expose(std::int64_t frame, Exposure& exposure) = 0;
  /// Does the second step, painting over all of `picture`.
  virtual void compose(const Exposure& exposure, image::Image& picture) = 0;
};

}  // namespace rotatebook::picture
