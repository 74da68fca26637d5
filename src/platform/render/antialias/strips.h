// The book's narrow strips: where they are seen, and their colours. Inside the room only.
#pragma once

#include <array>
#include <vector>

#include <Eigen/Core>

#include "image/image.h"
#include "physics/cuboid.h"
#include "render/book/book_mesh.h"

namespace rotatebook::render {

/// A BookStrip as a picture has it.
struct ScreenStrip {
  /// So narrow, throughout, that pixels don't show it well; before the camera, and not looking away
  /// from it.
  bool narrow = false;
  Eigen::Vector2f from{0, 0};  ///< One end of its middle. [pixels]
  Eigen::Vector2f way{0, 0};   ///< To the other end, divided by its squared length. [1/pixels]
  std::array<float, 2> distances{1,
                                 1};  ///< Of both ends from the camera, as a multiple of something.
  float columns = 0;                  ///< Of DrawnStrips::colours, that show the strip.

  /// The share of the strip, from its start, that ends beside this place. [pixels]
  float shareAt(const Eigen::Vector2f& place) const;
};

/// Strips whose colours were drawn apart from the book, one a row, from end to end: where a strip
/// is narrower than a pixel, those pixels that show it as the book is drawn show a part of it that
/// changes from pixel to pixel.
struct DrawnStrips {
  static constexpr int kColumns = 48;  ///< For a strip as long as the book is high.

  std::vector<ScreenStrip> seen;  ///< By the strips' numbers.
  image::Image colours;           ///< Rgba8; rows of strips that aren't narrow are of no use.
};

/// Finds which strips are narrow.
class StripFinder {
 public:
  explicit StripFinder(const BookMesh& mesh);

  std::size_t count() const { return strips_.size(); }
  /// All strips of the book in this cage in a picture of this size. `winding`: as
  /// windingOf() has it.
  void find(const physics::Cage& cage, const Eigen::Matrix4d& clipFromWorld, int winding,
            const Eigen::Vector2i& size, std::vector<ScreenStrip>& seen) const;

 private:
  using Shares = Eigen::Matrix<float, 8, 1>;
  struct Strip {
    std::vector<std::array<Shares, 2>> lines;  // Across it; ends on both sides.
    float columns, narrow;                     // narrow: what is less than that. [pixels]
  };

  std::vector<Strip> strips_;
};

}  // namespace rotatebook::render
