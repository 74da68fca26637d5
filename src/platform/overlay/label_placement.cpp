#include "overlay/label_placement.h"

#include <algorithm>
#include <array>

#include <Eigen/Geometry>

namespace rotatebook::overlay {
namespace {

// Turns from the best direction that are tried, nearest first. [rad]
constexpr std::array<double, 7> kTurns{0, 0.7, -0.7, 1.4, -1.4, 2.1, -2.1};
constexpr std::array<double, 3> kDistances{1, 1.5, 2.1};
constexpr double kGap = 1;  // between words [pixels]

}  // namespace

void LabelPlacement::add(const Layer& words, const Point& tip, const Point& direction,
                         double distance) {
  const Point away = direction.norm() > 1e-9 ? Point(direction.normalized()) : Point(0, -1);
  labels_.push_back({&words, tip, away, distance});
}

void LabelPlacement::write(Canvas& canvas, const Box& picture, std::vector<Box> taken) {
  const auto place = [&](const Label& label) {
    const Box size = boxOf(*label.words, Point(0, 0));
    const Point half(size.width / 2, size.height / 2);
    for (const double distance : kDistances) {
      for (const double turn : kTurns) {
        const Point middle =
            label.tip + Eigen::Rotation2Dd(turn) * label.direction * distance * label.distance;
        const Box box = boxOf(*label.words, middle - half);
        const auto meets = [&](const Box& other) { return other.grown(kGap).meets(box); };
        if (!picture.holds(box) || std::ranges::any_of(taken, meets)) continue;
        canvas.write(*label.words, middle - half);
        taken.push_back(box);
        return;
      }
    }
  };
  for (const Label& label : labels_) place(label);
  labels_.clear();
}

}  // namespace rotatebook::overlay
