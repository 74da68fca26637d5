#include "overlay/body_box.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace rotatebook::overlay {
namespace {

constexpr double kHiddenOpacity = 0.38;
constexpr double kHeadLength = 4.2, kHeadWidth = 3.4;  // of an arrow [line widths]
constexpr double kMaxHead = 0.6;                       // share of the arrow's length

Pen hiddenPen(Pen pen) {
  pen.opacity *= kHiddenOpacity;
  pen.halo = 0;
  return pen;
}

/// Returns the point between `low` and `high`, one of them hidden, at which hiding begins or ends.
template <typename Hides>
double edgeBetween(double low, double high, const Hides& hides) {
  constexpr int kHalvings = 7;
  const bool first = hides(low);
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = (low + high) / 2;
    (hides(middle) == first ? low : high) = middle;
  }
  return (low + high) / 2;
}

/// A part of a line, within 0 to 1 of its length.
struct Part {
  double from, to;
  bool hidden;
};

template <typename Hides>
std::vector<Part> partsOf(const Hides& hides) {
  constexpr int kSteps = 12;
  std::vector<Part> parts{{0, 1, hides(0)}};
  for (int i = 1; i <= kSteps; ++i) {
    const double t = static_cast<double>(i) / kSteps;
    if (hides(t) == parts.back().hidden) continue;
    const double edge = edgeBetween(t - 1.0 / kSteps, t, hides);
    const bool hidden = !parts.back().hidden;
    parts.back().to = edge;
    parts.push_back({edge, 1, hidden});
  }
  return parts;
}

void drawHead(Canvas& canvas, const Point& tip, const Point& along, double length, const Pen& pen) {
  const Point base = tip - length * along;
  const Point across = Point(-along.y(), along.x()) * length * kHeadWidth / kHeadLength / 2;
  const std::array<Point, 4> outline{tip, base + across, base - across, tip};
  if (pen.halo > 0) canvas.line(outline, {kDark, 2 * pen.halo, 0.55 * pen.opacity, 0});
  canvas.area(outline, {pen.colour, pen.opacity});
}

/// Draws a straight line in the world, faint where the body hides it; parts that have an end behind
/// the camera are left out.
void drawLine(const View& view, const BodyBox& box, const Eigen::Vector3d& from,
              const Eigen::Vector3d& to, const Pen& pen) {
  const Eigen::Vector3d eye = view.projector.eye();
  const auto at = [&](double t) { return Eigen::Vector3d(from + t * (to - from)); };
  const auto parts = partsOf([&](double t) { return box.hides(at(t), eye); });
  for (const bool hidden : {true, false}) {
    for (const Part& part : parts) {
      if (part.hidden != hidden) continue;
      const auto a = view.projector(at(part.from)), b = view.projector(at(part.to));
      if (a && b) view.canvas.line(std::array{*a, *b}, hidden ? hiddenPen(pen) : pen);
    }
  }
}

}  // namespace

BodyBox::BodyBox(const body::Cuboid& body, const body::Cage& cage)
    : centre_(cage.rowwise().mean()) {
  const body::Cage rest = body.corners();
  const Eigen::Vector3d half = body.size / 2;
  const Eigen::Vector3d inverseSquares = half.cwiseAbs2().cwiseInverse() / 8;
  map_ = (cage.colwise() - centre_) * rest.transpose() * inverseSquares.asDiagonal();
  worldFromBox_ = map_ * half.asDiagonal();
  boxFromWorld_ = worldFromBox_.inverse();
}

bool BodyBox::hides(const Eigen::Vector3d& point, const Eigen::Vector3d& eye) const {
  const Eigen::Array3d start = boxFromWorld_ * (eye - centre_);
  const Eigen::Array3d ray = boxFromWorld_ * (point - eye);
  const Eigen::Array3d a = (-1 - start) / ray, b = (1 - start) / ray;
  const double enters = a.min(b).maxCoeff(), leaves = a.max(b).minCoeff();
  constexpr double kTouching = 1e-6;
  return enters > 0 && enters < leaves && enters < 1 - kTouching;
}

std::vector<std::vector<Eigen::Vector3d>> BodyBox::sidesFacing(const Eigen::Vector3d& eye) const {
  const Eigen::Vector3d start = boxFromWorld_ * (eye - centre_);
  std::vector<std::vector<Eigen::Vector3d>> sides;
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    if (!(std::abs(start[axis]) > 1)) continue;
    std::vector<Eigen::Vector3d>& side = sides.emplace_back();
    for (const auto& [a, b] : {std::pair{1, 1}, {-1, 1}, {-1, -1}, {1, -1}}) {
      Eigen::Vector3d corner;
      corner[axis] = std::copysign(1, start[axis]);
      corner[(axis + 1) % 3] = a;
      corner[(axis + 2) % 3] = b;
      side.emplace_back(centre_ + worldFromBox_ * corner);
    }
  }
  return sides;
}

std::optional<ArrowShape> arrowShape(const Projector& projector, const BodyBox& box,
                                     const Arrow& arrow) {
  const auto a = projector(arrow.from), b = projector(arrow.to);
  if (!a || !b) return std::nullopt;
  const Eigen::Vector3d eye = projector.eye(), along = arrow.to - arrow.from;
  // The body hides nothing of the arrow beyond the point at which it comes out.
  const Part last =
      partsOf([&](double t) { return box.hides(arrow.from + t * along, eye); }).back();
  const auto visible = last.hidden ? std::nullopt : projector(arrow.from + last.from * along);
  const double head = std::min(kHeadLength * arrow.pen.width, kMaxHead * (*b - *a).norm());
  return ArrowShape{*a, *b, visible, arrow.pen.width, head, head * kHeadWidth / kHeadLength};
}

void drawArrow(const View& view, const BodyBox& box, const Arrow& arrow) {
  const auto shape = arrowShape(view.projector, box, arrow);
  if (!shape || shape->headLength < 0.5) return;
  const double length = (shape->tip - shape->from).norm(), head = shape->headLength;
  // The line ends within the head, whose tip is sharp.
  const double share = 1 - 0.8 * head / length;
  drawLine(view, box, arrow.from, arrow.from + share * (arrow.to - arrow.from), arrow.pen);
  const bool hidden = box.hides(arrow.to, view.projector.eye());
  drawHead(view.canvas, shape->tip, (shape->tip - shape->from) / length, head,
           hidden ? hiddenPen(arrow.pen) : arrow.pen);
}

}  // namespace rotatebook::overlay
