// Composes a clip's picture from its bodies and overlays. Inside the room only.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "geometry/camera.h"
#include "image/image.h"
#include "overlay/caption_and_clock.h"
#include "overlay/motion_overlays.h"
#include "overlay/panel_heads.h"
#include "plot/grid_margins.h"
#include "plot/panel_grid.h"
#include "scene/scene.h"
#include "timeline/clip_motion.h"

namespace rotatebook::picture {

/// Draws the body of motion `motion` at its sample `sample` into `picture`, whose screen() from
/// `place` on shows the background, touching what it draws over; returns the projection, world to
/// clip space, y down.
using DrawBody =
    std::function<Eigen::Matrix4d(std::size_t motion, std::size_t sample,
                                  const plot::PanelGrid::Position& place, image::Image& picture)>;

/// Makes the text over the pictures of all motions together. Throws like overlay::CaptionAndClock.
overlay::CaptionAndClock captionAndClockOf(const scene::Scene& scene);

/// Composes the pictures of a clip: arranges the panels, draws overlays over each body, and text
/// over the whole. Use it on one thread.
class Composition {
 public:
  /// `motion`, the scene's, must outlive this. Throws InputError if the picture has no room for the
  /// panels, and like overlay::CaptionAndClock.
  Composition(const scene::Scene& scene, const timeline::ClipMotion& motion);

  /// Returns the screen on which each body is drawn: the whole picture, or a panel.
  const geometry::Screen& screen() const { return screen_; }
  /// Returns the overlays that overlay.show asks for and for which a motion's picture has no room,
  /// in the order of scene::Overlay.
  std::vector<scene::Overlay> leftOut() const;
  /// Returns overlay::CaptionAndClock::longCues().
  const std::vector<std::size_t>& longCues() const { return captionAndClock_.longCues(); }
  /// Sets the background of bodies, a picture of screen()'s size that must outlive this.
  void setBackground(const image::Image& ofBody);
  /// Returns a picture of the clip's size and format.
  image::Image makePicture() const {
    return {ground().width(), ground().height(), ground().format()};
  }
  /// Draws over all of `picture`; `frame` is 0 to below motion.frameCount().
  void draw(std::int64_t frame, const DrawBody& drawBody, image::Image& picture);

 private:
  /// Returns the background of all bodies, and what is between panels.
  const image::Image& ground() const { return ofOnlyBody_ ? *ofOnlyBody_ : background_; }
  /// Sets withInsets_ and still_ to what they are at `frame`.
  void setStill(std::int64_t frame);

  const timeline::ClipMotion* motion_;
  overlay::CaptionAndClock captionAndClock_;
  std::optional<plot::GridMargins> margins_;
  std::optional<overlay::PanelHeads> heads_;
  plot::PanelGrid grid_;                           // of the bodies' pictures
  std::vector<overlay::MotionOverlays> overlays_;  // of each motion
  geometry::Screen screen_;
  const image::Image* ofOnlyBody_ = nullptr;  // Replaces the next.
  image::Image background_;
  image::Image withInsets_;  // ground() with what is still in the overlays' insets.
  image::Image still_;       // The same with the caption; marked. Empty at first.
};

}  // namespace rotatebook::picture
