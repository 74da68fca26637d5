// The overlays of one motion: their interface and their factories. Inside the room only.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include <Eigen/Core>

#include "overlay/arrow_labels.h"
#include "overlay/box.h"
#include "overlay/canvas.h"
#include "overlay/layer.h"
#include "overlay/palette.h"
#include "overlay/projector.h"
#include "overlay/text.h"
#include "physics/trajectory.h"
#include "scene/overlays.h"
#include "scene/reference_frame.h"
#include "scene/scene.h"

namespace rotatebook::overlay {

/// The data that overlays are made from; all of it outlives them.
struct OverlayContext {
  const scene::Scene& scene;
  const physics::Trajectory& trajectory;
  const Typesetter& type;
  Scale scale;
  double energyTop = 0;                                    ///< See Viewport::energyTop.
  scene::MotionFrame frame{scene::ReferenceFrame::World};  ///< Of the camera.

  /// Returns an empty canvas of the picture's size.
  Canvas canvas() const { return Canvas(scale.width, scale.height, Ink(scene)); }
};

/// A picture that overlays are drawn on.
struct View {
  std::int64_t frame = 0;         ///< Index of the trajectory's sample.
  const physics::Sample& sample;  ///< The sample in the camera's frame of reference.
  Projector projector;
  Canvas& canvas;
  image::Image& picture;
  bool ended = false;  ///< True if the motion diverged earlier; `frame` is then its last.
};

/// An arrow in the camera's frame of reference, and its letter.
struct Arrow {
  Eigen::Vector3d from, to;  ///< [m]
  Pen pen;
  const Layer* letter;
  LetterWish wish;
};

/// An overlay that is drawn over each picture of a motion.
class DrawnOverlay {
 public:
  DrawnOverlay() = default;
  DrawnOverlay(const DrawnOverlay&) = delete;
  DrawnOverlay& operator=(const DrawnOverlay&) = delete;
  virtual ~DrawnOverlay() = default;

  virtual void draw(const View& view) = 0;
  /// Returns what is below all that draw() draws, and the same in many frames; null if nothing is.
  virtual const CachedLayer* still(std::int64_t /*frame*/) const { return nullptr; }
  /// Returns the area that it takes, if it is at scene::Placement::TopLeft; else empty. [pixels]
  virtual Box box() const { return {}; }
  /// Returns the arrows that draw() draws for `sample`, which is in the camera's frame of
  /// reference: equally many for each sample.
  virtual std::vector<Arrow> arrows(const physics::Sample& /*sample*/) const { return {}; }
};

/// Makes the overlay of that name; each is defined in its overlay's file.
#define ROTATEBOOK_OVERLAY(enumerator, ...) \
  std::unique_ptr<DrawnOverlay> make##enumerator(const OverlayContext& context, const Box& box);
#include "scene/overlay_list.inc"
#undef ROTATEBOOK_OVERLAY

/// Makes `overlay` in a box, if its placement has one. Returns null for Placement::WholeClip.
std::unique_ptr<DrawnOverlay> makeOverlay(scene::Overlay overlay, const OverlayContext& context,
                                          const Box& box);

}  // namespace rotatebook::overlay
