// How a clip's picture is put together around its books. Inside the room only.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include <Eigen/Core>

#include "image/image.h"
#include "overlay/caption_and_clock.h"
#include "overlay/motion_overlays.h"
#include "picture/panel_grid.h"
#include "render/camera.h"
#include "scene/scene.h"
#include "timeline/clip_motion.h"

namespace rotatebook::picture {

/// Draws sample `sample` of motion `motion` over all of a picture of its own; returns the
/// projection, world to clip space, y down.
using DrawBook =
    std::function<Eigen::Matrix4d(std::size_t motion, std::size_t sample, image::Image& picture)>;

/// What is written over the pictures of all motions together. Throws as overlay::CaptionAndClock
/// does.
overlay::CaptionAndClock captionAndClockOf(const scene::Scene& scene);

/// Everything in the pictures of a clip but the books: overlays over each, the panels' places, and
/// words over the whole. Use it on one thread.
class Composition {
 public:
  /// `motion`, the scene's, must outlive this. Throws InputError for more panels than the picture
  /// has room for, and as overlay::CaptionAndClock does.
  Composition(const scene::Scene& scene, const timeline::ClipMotion& motion);

  /// What the picture of each book is drawn on: the whole, or a panel.
  const render::Screen& screen() const { return screen_; }
  /// A picture of the clip's size.
  image::Image makePicture() const { return background_; }
  /// Draws over all of `picture`, from makePicture(); `frame` is 0 to below motion.frameCount().
  void draw(std::int64_t frame, const DrawBook& drawBook, image::Image& picture);

 private:
  void drawMotion(std::size_t motion, std::int64_t frame, const DrawBook& drawBook,
                  image::Image& picture);

  const timeline::ClipMotion* motion_;
  overlay::CaptionAndClock captionAndClock_;
  PanelGrid grid_;
  std::vector<overlay::MotionOverlays> overlays_;  // of each motion
  render::Screen screen_;
  image::Image background_;  // what shows between panels
  image::Image panel_;
};

}  // namespace rotatebook::picture
