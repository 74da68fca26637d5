#include "overlay/ghost.h"

#include <array>
#include <cstddef>
#include <vector>

#include "physics/reference_frame.h"
#include "physics/simulator.h"

namespace rotatebook::overlay {
namespace {

/// A side of the box: across `axis`, at its lower or upper end.
struct Side {
  int axis;
  bool upper;

  /// Its corners in a circle, as numbers of physics::Corners.
  std::array<Eigen::Index, 4> corners() const {
    const int a = 1 << ((axis + 1) % 3), b = 1 << ((axis + 2) % 3);
    const int base = upper ? 1 << axis : 0;
    return {base, base | a, base | a | b, base | b};
  }
};

/// Whether a camera at `eye` sees the outside of `side`.
bool faces(const physics::Corners& box, const Side& side, const Eigen::Vector3d& eye) {
  const int other = side.upper ? 0 : 1 << side.axis;
  const Eigen::Vector3d corner = box.col(side.corners()[0]);
  const Eigen::Vector3d outward = corner - box.col(other);
  return outward.dot(eye - corner) > 0;
}

}  // namespace

Ghost::Ghost(const MarkContext& context)
    : context_(context),
      exact_(physics::modelInertia(context.scene.motion()),
             physics::initialAngularVelocity(context.scene.motion())) {}

void Ghost::draw(const View& view) {
  const physics::Sample& sample = context_.trajectory.samples[static_cast<std::size_t>(view.frame)];
  const Eigen::Matrix3d turn = physics::frameFromWorld(context_.scene.camera.frame, sample) *
                               exact_.at(sample.time).worldFromBody;
  const physics::Corners box = turn * context_.scene.body.corners();
  const Eigen::Vector3d eye = view.projector.eye();
  std::array<bool, 6> seen{};
  for (std::size_t i = 0; i < 6; ++i) {
    seen[i] = faces(box, {static_cast<int>(i / 2), i % 2 == 1}, eye);
  }
  std::vector<Point> corners;
  for (Eigen::Index i = 0; i < 8; ++i) {
    const auto point = view.projector(box.col(i));
    if (!point) return;
    corners.push_back(*point);
  }

  std::vector<Point> front, back;
  for (std::size_t i = 0; i < 6; ++i) {
    const Side side{static_cast<int>(i / 2), i % 2 == 1};
    if (!seen[i]) continue;
    std::vector<Point> outline;
    for (const Eigen::Index corner : side.corners()) {
      outline.push_back(corners[static_cast<std::size_t>(corner)]);
    }
    view.canvas.area(outline, {kGhostColour, 0.09});
  }
  for (std::size_t corner = 0; corner < 8; ++corner) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::size_t bit = std::size_t{1} << axis;
      if ((corner & bit) != 0) continue;
      // The two sides that meet in this edge are across the other two axes.
      const auto sideAt = [&](std::size_t other) {
        return seen[2 * other + ((corner >> other) & 1)];
      };
      const bool shows = sideAt((axis + 1) % 3) || sideAt((axis + 2) % 3);
      std::vector<Point>& edges = shows ? front : back;
      edges.push_back(corners[corner]);
      edges.push_back(corners[corner | bit]);
    }
  }
  const Scale& scale = context_.scale;
  view.canvas.lines(back, {kGhostColour, 0.45 * scale.line, 0.45, 0});
  view.canvas.lines(front, {kGhostColour, 0.8 * scale.line, 0.95, 0.8 * scale.halo});
}

}  // namespace rotatebook::overlay
