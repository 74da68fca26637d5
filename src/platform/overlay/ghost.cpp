#include "overlay/ghost.h"

#include <array>
#include <cstddef>
#include <vector>

#include "physics/motion_start.h"
#include "scene/reference_frame.h"

namespace rotatebook::overlay {
namespace {

/// A side of the box: across `axis`, at its lower or upper end.
struct Side {
  int axis;
  bool upper;

  /// Its corners in a circle, as numbers of physics::Cage.
  std::array<Eigen::Index, 4> corners() const {
    const int a = 1 << ((axis + 1) % 3), b = 1 << ((axis + 2) % 3);
    const int base = upper ? 1 << axis : 0;
    return {base, base | a, base | a | b, base | b};
  }
};

constexpr std::array<Side, 6> kSides{
    {{0, false}, {0, true}, {1, false}, {1, true}, {2, false}, {2, true}}};

/// A box on the picture, and which of its sides are seen from outside.
struct SeenBox {
  std::vector<Point> corners;  // those in front of the camera
  std::array<bool, 6> faces{};

  SeenBox(const physics::Cage& box, const Projector& projector) {
    const Eigen::Vector3d eye = projector.eye();
    for (std::size_t i = 0; i < kSides.size(); ++i) faces[i] = isOutside(box, kSides[i], eye);
    for (Eigen::Index i = 0; i < 8; ++i) {
      const auto point = projector(box.col(i));
      if (point) corners.push_back(*point);
    }
  }

  std::vector<Point> outline(const Side& side) const {
    std::vector<Point> points;
    for (const Eigen::Index corner : side.corners()) {
      points.push_back(corners[static_cast<std::size_t>(corner)]);
    }
    return points;
  }

  /// The ends of all edges of at least one side that is seen, or of the others.
  std::vector<Point> edges(bool seen) const {
    std::vector<Point> ends;
    for (std::size_t corner = 0; corner < 8; ++corner) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::size_t other = corner | (std::size_t{1} << axis);
        if (other == corner || edgeIsSeen(corner, axis) != seen) continue;
        ends.push_back(corners[corner]);
        ends.push_back(corners[other]);
      }
    }
    return ends;
  }

 private:
  /// Whether a camera at `eye` sees the outside of `side`.
  static bool isOutside(const physics::Cage& box, const Side& side, const Eigen::Vector3d& eye) {
    const Eigen::Vector3d corner = box.col(side.corners()[0]);
    const Eigen::Vector3d outward = corner - box.col(side.upper ? 0 : 1 << side.axis);
    return outward.dot(eye - corner) > 0;
  }

  /// Of the edge from `corner` along `axis`: the two sides that meet in it are across the others.
  bool edgeIsSeen(std::size_t corner, std::size_t axis) const {
    const auto faceAcross = [&](std::size_t other) {
      return faces[2 * other + ((corner >> other) & 1)];
    };
    return faceAcross((axis + 1) % 3) || faceAcross((axis + 2) % 3);
  }
};

}  // namespace

Ghost::Ghost(const OverlayContext& context)
    : context_(context),
      exact_(physics::modelInertia(context.scene.motion()),
             physics::initialAngularVelocity(context.scene.motion())) {}

void Ghost::draw(const View& view) {
  const auto& samples = context_.trajectory.samples;
  const physics::Sample& sample = samples[static_cast<std::size_t>(view.frame)];
  const Eigen::Matrix3d turn = scene::frameFromWorld(context_.scene.camera.frame, sample) *
                               exact_.at(sample.time).worldFromBody;
  const SeenBox box(turn * context_.scene.body.corners(), view.projector);
  if (box.corners.size() < 8) return;
  for (std::size_t i = 0; i < kSides.size(); ++i) {
    if (box.faces[i]) view.canvas.area(box.outline(kSides[i]), {kGhostColour, 0.09});
  }
  const Scale& scale = context_.scale;
  view.canvas.lines(box.edges(false), {kGhostColour, 0.45 * scale.line, 0.45, 0});
  view.canvas.lines(box.edges(true), {kGhostColour, 0.8 * scale.line, 0.95, 0.8 * scale.halo});
}

}  // namespace rotatebook::overlay
