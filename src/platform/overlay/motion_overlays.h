// What is drawn over the pictures of one motion.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "image/image.h"
#include "overlay/box.h"
#include "physics/trajectory.h"
#include "scene/scene.h"

namespace rotatebook::overlay {

class ArrowLabels;

/// The picture that a motion's overlays are drawn on: a whole one, or a panel's.
struct Viewport {
  int width = 0;   ///< > 0 [pixels]
  int height = 0;  ///< > 0 [pixels]
  /// Where other words are at its top left corner, as CaptionAndClock::corner() has it. [pixels]
  Box corner{};
  int bottomRows = 0;   ///< Rows at its bottom that other words take. [pixels]
  std::string label{};  ///< Written at its top; may be empty.
  /// Letters are never smaller than this, so that those of a small panel go with the whole
  /// picture's. [pixels]
  double letters = 0;
  std::string labelKey{};  ///< By which scene::locationOf() knows the label.
  /// Where the energy's chart ends at least, so that charts beside each other have one scale: the
  /// highest energyChartTop() of all. That of the angle to the exact motion ends at 180° in any
  /// case.
  double energyTop = 0;
};

/// Where an energy chart of this motion alone ends, as a share of the start's total energy.
double energyChartTop(const physics::Trajectory& trajectory);

/// Draws what the scene's overlay.show asks for on pictures of one motion: the viewport's label,
/// and all but caption and clock, which are CaptionAndClock'. A overlay that the scene's model
/// doesn't have is left out. Frames past the end of a motion that diverged show its last sample
/// with a notice that says when. Use it on one thread.
class MotionOverlays {
 public:
  /// `trajectory` is the motion of `scene` and must outlive this. Throws InputError as
  /// CaptionAndClock does.
  MotionOverlays(const scene::Scene& scene, const physics::Trajectory& trajectory,
                 const Viewport& viewport);
  ~MotionOverlays();
  MotionOverlays(MotionOverlays&&) noexcept;
  MotionOverlays& operator=(MotionOverlays&&) noexcept;

  /// Rows at the picture's bottom that words and charts take, the viewport's included; the camera's
  /// picture ends above them. From 0 to two thirds of all. [pixels]
  int bottomRows() const;
  /// Draws over `picture`, of the viewport's size, which shows frame `frame` >= 0 as the camera's
  /// frame has it. `clipFromWorld` is what its renderer projects with, y down.
  void draw(std::int64_t frame, const Eigen::Matrix4d& clipFromWorld, image::Image& picture);

  /// Where the last draw() has put words, each a box of its own. [pixels]
  const std::vector<Box>& texts() const;
  /// The arrows that it has drawn, and their letters.
  const ArrowLabels& labels() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace rotatebook::overlay
