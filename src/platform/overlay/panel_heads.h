// Draws the heads of a clip's panels: their labels, and what is counted of their motions.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "image/image.h"
#include "overlay/box.h"
#include "physics/trajectory.h"
#include "scene/scene.h"

namespace rotatebook::overlay {

/// The panels of a picture.
struct PanelCells {
  int width = 0;                 ///< Of each panel, its head included, > 0. [pixels]
  int height = 0;                ///< Likewise. [pixels]
  std::vector<Point> corners{};  ///< The top left of each.
  double letters = 0;            ///< Smallest letter size. [pixels]
};

/// Writes above the picture of each panel its label, the overlays at scene::Placement::TopLeft and,
/// once its motion has ended, the notice of its divergence, so that none of them lies on a body.
/// Texts of one kind stand at the same place in all panels. The books of a grid have no labels.
/// Grids, and pictures of fewer than 360 rows, have smaller letters where that is needed, and are
/// without texts that have no room in half of a panel even so. Use it on one thread.
class PanelHeads {
 public:
  /// `motions` are those of the scene's panels, in their order, and must outlive this. Throws
  /// InputError, with the line of the scene, if its font isn't installed or lacks a letter, or if a
  /// label takes more than a fifth of its panel, or all texts take more than half, in a picture of
  /// 360 rows or more.
  PanelHeads(const scene::Scene& scene, const std::vector<physics::Trajectory>& motions,
             const PanelCells& cells);
  ~PanelHeads();
  PanelHeads(PanelHeads&&) noexcept;
  PanelHeads& operator=(PanelHeads&&) noexcept;

  /// Returns how many rows the head takes at the top of each panel, up to half of them. [pixels]
  int rows() const;
  /// Draws over `picture`, of the clip's size, which shows frame `frame` >= 0.
  void draw(std::int64_t frame, image::Image& picture);

  /// Returns a box for each text that the last draw() drew. [pixels]
  const std::vector<Box>& texts() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace rotatebook::overlay
