// What every overlay of a motion has in common. Inside the room only.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include <Eigen/Core>

#include "overlay/arrow_labels.h"
#include "overlay/box.h"
#include "overlay/canvas.h"
#include "overlay/palette.h"
#include "overlay/projector.h"
#include "overlay/text.h"
#include "physics/trajectory.h"
#include "scene/reference_frame.h"
#include "scene/scene.h"

namespace rotatebook::overlay {

/// What overlays are made from; all of it outlives them.
struct OverlayContext {
  const scene::Scene& scene;
  const physics::Trajectory& trajectory;
  const Typesetter& type;
  Scale scale;
  double energyTop = 0;  ///< Viewport::energyTop
};

/// One picture that overlays are drawn on.
struct View {
  std::int64_t frame = 0;         ///< Of the trajectory's samples.
  const physics::Sample& sample;  ///< The same as it is shown, in the camera's frame.
  Projector projector;
  Canvas& canvas;
  image::Image& picture;
  bool ended = false;  ///< The motion has diverged before; `frame` is its last.
};

/// An arrow in the camera's frame, and its letter.
struct Arrow {
  Eigen::Vector3d from, to;  ///< [m]
  Pen pen;
  const Layer* letter;
  LetterWish wish;
};

/// Something that is drawn over each picture of a motion.
class DrawnOverlay {
 public:
  DrawnOverlay() = default;
  DrawnOverlay(const DrawnOverlay&) = delete;
  DrawnOverlay& operator=(const DrawnOverlay&) = delete;
  virtual ~DrawnOverlay() = default;

  virtual void draw(const View& view) = 0;
  /// What it takes beside the book, where it says so itself; else empty. [pixels]
  virtual Box box() const { return {}; }
  /// Those that draw() draws of `sample`, as the camera's frame has it, in whatever frame as many.
  virtual std::vector<Arrow> arrows(const physics::Sample& /*sample*/) const { return {}; }
};

}  // namespace rotatebook::overlay
