#include <array>
#include <cstddef>
#include <memory>
#include <vector>

#include "overlay/drawn_overlay.h"
#include "physics/motion_start.h"
#include "scene/reference_frame.h"

namespace rotatebook::overlay {
namespace {

constexpr std::size_t kSides = 6;

/// Returns the corners around a side of a box, as columns of body::Cage. Sides 2 i and 2 i + 1
/// are the lower and the upper one across axis i.
std::array<Eigen::Index, 4> cornersOf(std::size_t side) {
  const auto axis = static_cast<Eigen::Index>(side / 2);
  const Eigen::Index a = 1 << ((axis + 1) % 3), b = 1 << ((axis + 2) % 3);
  const Eigen::Index base = side % 2 == 1 ? 1 << axis : 0;
  return {base, base | a, base | a | b, base | b};
}

/// A box on the picture.
struct ProjectedBox {
  std::vector<Point> corners;          // those in front of the camera
  std::array<bool, kSides> isFront{};  // whether the camera sees the side's outside

  ProjectedBox(const body::Cage& box, const Projector& projector) {
    const Eigen::Vector3d eye = projector.eye();
    for (std::size_t side = 0; side < kSides; ++side) {
      const Eigen::Vector3d corner = box.col(cornersOf(side)[0]);
      const Eigen::Vector3d outward = corner - box.col(cornersOf(side ^ 1)[0]);
      isFront[side] = outward.dot(eye - corner) > 0;
    }
    for (Eigen::Index i = 0; i < 8; ++i) {
      const auto point = projector(box.col(i));
      if (point) corners.push_back(*point);
    }
  }

  std::vector<Point> outline(std::size_t side) const {
    std::vector<Point> points;
    for (const Eigen::Index corner : cornersOf(side)) {
      points.push_back(corners[static_cast<std::size_t>(corner)]);
    }
    return points;
  }

  /// Returns the ends of the edges that have a front side, or of the others.
  std::vector<Point> edges(bool front) const {
    std::vector<Point> ends;
    for (std::size_t corner = 0; corner < 8; ++corner) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::size_t other = corner | (std::size_t{1} << axis);
        if (other == corner || hasFront(corner, axis) != front) continue;
        ends.push_back(corners[corner]);
        ends.push_back(corners[other]);
      }
    }
    return ends;
  }

 private:
  /// Returns whether the edge from `corner` along `axis`, in which two sides across the other axes
  /// meet, has a front side.
  bool hasFront(std::size_t corner, std::size_t axis) const {
    const auto isFrontAcross = [&](std::size_t other) {
      return isFront[2 * other + ((corner >> other) & 1)];
    };
    return isFrontAcross((axis + 1) % 3) || isFrontAcross((axis + 2) % 3);
  }
};

/// The body in the exact motion from the same start, as a translucent outline.
class Ghost final : public DrawnOverlay {
 public:
  explicit Ghost(const OverlayContext& context);
  void draw(const View& view) override;

 private:
  OverlayContext context_;
  physics::NudgedRotation exact_;
};

Ghost::Ghost(const OverlayContext& context)
    : context_(context), exact_(physics::exactRotation(context.scene.motions[0])) {}

void Ghost::draw(const View& view) {
  const auto& samples = context_.trajectory.samples;
  const physics::Sample& sample = samples[static_cast<std::size_t>(view.frame)];
  const Eigen::Matrix3d frameFromBody =
      context_.frame.fromWorld(sample) * exact_.at(sample.time).worldFromBody;
  const ProjectedBox box(frameFromBody * context_.scene.motions[0].body.corners(), view.projector);
  if (box.corners.size() < 8) return;
  for (std::size_t side = 0; side < kSides; ++side) {
    if (box.isFront[side]) view.canvas.area(box.outline(side), {kGhostColour, 0.09});
  }
  const Scale& scale = context_.scale;
  view.canvas.lines(box.edges(false), {kGhostColour, 0.45 * scale.line, 0.45, 0});
  view.canvas.lines(box.edges(true), {kGhostColour, 0.8 * scale.line, 0.95, 0.8 * scale.halo});
}

}  // namespace

std::unique_ptr<DrawnOverlay> makeGhost(const OverlayContext& context, const Box&) {
  return std::make_unique<Ghost>(context);
}

}  // namespace rotatebook::overlay
