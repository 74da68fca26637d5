// The two steps in which a clip's frame is drawn.
#pragma once

#include <cstdint>
#include <vector>

#include "image/image.h"
#include "render/drawn_body.h"

namespace rotatebook::picture {

/// A frame's books as OpenGL drew them: one, or one in each panel.
struct Exposure {
  std::int64_t frame = 0;
  std::vector<render::DrawnBody> books;
  std::vector<image::Image> blurred;  ///< Instead of `books`, where a shutter is open for a while.
};

/// Paints frame n of a clip in two steps: what needs OpenGL, and the rest, which may be done on
/// another thread while this one exposes the next frame.
class FramePainter {
 public:
  FramePainter() = default;
  FramePainter(const FramePainter&) = delete;
  FramePainter& operator=(const FramePainter&) = delete;
  virtual ~FramePainter() = default;

  /// A picture of the right size and format for finish().
  virtual image::Image makePicture() const = 0;
  /// An exposure for expose().
  virtual Exposure makeExposure() const = 0;

  /// Takes the first step of frame `frame`, replacing all of `exposure`.
  virtual void expose(std::int64_t frame, Exposure& exposure) = 0;
  /// Takes the second, painting over all of `picture`.
  virtual void finish(const Exposure& exposure, image::Image& picture) = 0;
};

}  // namespace rotatebook::picture
