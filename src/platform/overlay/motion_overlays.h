// Draws the overlays of one motion.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include <Eigen/Core>

#include "image/image.h"
#include "overlay/box.h"
#include "physics/trajectory.h"
#include "scene/scene.h"

namespace rotatebook::overlay {

class ArrowLabels;

/// The picture on which a motion's overlays are drawn: a whole one, or a panel's.
struct Viewport {
  int width = 0;   ///< > 0 [pixels]
  int height = 0;  ///< > 0 [pixels]
  /// The box of other text at its top left corner, see CaptionAndClock::corner(). [pixels]
  Box corner{};
  int bottomRows = 0;  ///< Rows at its bottom that other text takes. [pixels]
  /// True if PanelHeads draws what else is at the top left, and the notice of a divergence.
  bool hasHead = false;
  /// Smallest letter size, so that the letters of a small panel match the whole picture's. [pixels]
  double letters = 0;
  /// Smallest upper end of the energy chart: the highest energyChartTop() of all motions, so that
  /// charts side by side have one scale. The chart of the angle to the exact motion always ends at
  /// 180°.
  double energyTop = 0;
  int x = 0, y = 0;  ///< Of a panel's top left pixel in the whole picture. [pixels]
};

/// Returns where the energy chart of this motion alone ends, as a share of the initial total
/// energy.
double energyChartTop(const physics::Trajectory& trajectory);

/// Draws the overlays that overlay.show asks for on pictures of one motion, all but caption and
/// clock, which CaptionAndClock draws, and what PanelHeads draws. Overlays that don't exist for the
/// scene's model are left out. Frames after the end of a motion that diverged show its last sample
/// with a notice of the time. Use it on one thread.
class MotionOverlays {
 public:
  /// `trajectory` is the motion of `scene` and must outlive this. Throws InputError like
  /// CaptionAndClock.
  MotionOverlays(const scene::Scene& scene, const physics::Trajectory& trajectory,
                 const Viewport& viewport);
  ~MotionOverlays();
  MotionOverlays(MotionOverlays&&) noexcept;
  MotionOverlays& operator=(MotionOverlays&&) noexcept;

  /// Returns how many rows at the picture's bottom text and charts take, the viewport's included;
  /// the book is drawn above them. From 0 to two thirds of all. [pixels]
  int bottomRows() const;
  /// Returns the overlays that overlay.show asks for and for which there is no room.
  const std::vector<scene::Overlay>& leftOut() const;
  /// Draws over the viewport in `picture`, which shows frame `frame` >= 0 in the camera's frame of
  /// reference. `clipFromWorld` is its projection, y down.
  void draw(std::int64_t frame, const Eigen::Matrix4d& clipFromWorld, image::Image& picture);

  // The steps of draw().
  /// Sets what insets show in many frames to that of `frame`; returns whether it was another.
  bool setStill(std::int64_t frame);
  /// Draws what is on and around the body.
  void drawAroundBody(std::int64_t frame, const Eigen::Matrix4d& clipFromWorld,
                      image::Image& picture);
  /// Draws what setStill() has set over those tiles that were touched since Image::beginOn().
  void drawStill(image::Image& picture);
  /// Draws the rest of the insets, and letters.
  void drawInsets(std::int64_t frame, const Eigen::Matrix4d& clipFromWorld, image::Image& picture);

  /// Returns a box for each text that the last draw() drew. [pixels]
  const std::vector<Box>& texts() const;
  /// Places the letters of arrows as draw() does, and draws nothing.
  const ArrowLabels& placeLetters(std::int64_t frame, const Eigen::Matrix4d& clipFromWorld);

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace rotatebook::overlay
