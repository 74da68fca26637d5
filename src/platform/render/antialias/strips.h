// Finds a body's narrow strips on the screen, and holds their colours. Inside the room only.
#pragma once

#include <array>
#include <vector>

#include <Eigen/Core>

#include "body/cuboid.h"
#include "geometry/mesh.h"
#include "image/image.h"

namespace rotatebook::render {

/// A MeshStrip projected onto a picture.
struct ScreenStrip {
  /// True if the strip is too narrow throughout for pixels to show it well, lies in front of the
  /// camera and has a front face. The other members are set only then.
  bool narrow = false;
  Eigen::Vector2f from{0, 0};  ///< One end of its middle line. [pixels]
  /// From there to the other end, divided by its squared length. [1/pixels]
  Eigen::Vector2f direction{0, 0};
  /// Distances of both ends from the camera, up to a common factor.
  std::array<float, 2> distances{1, 1};
  float columns = 0;  ///< Number of columns of DrawnStrips::colours that show the strip.

  /// Returns how far along the strip the point beside `position` [pixels] is. [0 to 1]
  float shareAt(const Eigen::Vector2f& position) const;
};

/// Strips whose colours were drawn apart from the body, one per row, from end to end. Where a strip
/// is narrower than a pixel, the pixels that happen to show it in the drawn body show a part of it
/// that changes from pixel to pixel.
struct DrawnStrips {
  static constexpr int kColumns = 48;  ///< Columns of a strip as long as the body is high.

  std::vector<ScreenStrip> onScreen;  ///< By strip number.
  image::Image colours;  ///< Rgba8, a row per strip; only those of narrow strips are drawn.
};

/// Finds the strips that are narrow on the screen.
class StripFinder {
 public:
  explicit StripFinder(const geometry::Mesh& mesh);

  std::size_t count() const { return strips_.size(); }
  /// Sets `onScreen` to all strips of the body in this cage, in a picture of this size. [pixels]
  /// `winding`: from frontFaceWinding().
  void find(const body::Cage& cage, const Eigen::Matrix4d& clipFromWorld, int winding,
            const Eigen::Vector2i& size, std::vector<ScreenStrip>& onScreen) const;

 private:
  using Weights = Eigen::Matrix<float, 8, 1>;  // Of the cage's corners.
  struct Strip {
    std::vector<std::array<Weights, 2>> lines;  // Both ends of lines across it.
    float columns;                              // ScreenStrip::columns
    float maxNarrowWidth;                       // Narrow if less wide than that. [pixels]
  };

  std::vector<Strip> strips_;
};

}  // namespace rotatebook::render
