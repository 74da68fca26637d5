#include "geometry/book_profile.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rotatebook::geometry {
namespace {

using Eigen::Vector2f;

// Rounds the 50 mm wide spine by 3 mm, within the cage.
constexpr float kSpineRadius = 100;           // [mm]
constexpr float kShoulderRadius = 2;          // Between boards and spine. [mm]
constexpr float kHingeHalfWidth = 2.6F;       // [mm]
constexpr float kHingeDepth = 1.4F;           // [mm]
constexpr float kHingeSkyVisibility = 0.88F;  // At the groove's bottom.
constexpr float kPi = std::numbers::pi_v<float>;

/// Returns the centre of the shoulder's arc, which is tangent to the board's plane and the spine's
/// arc.
Vector2f shoulderCentre(const BookDimensions& book) {
  const float z = book.thickness - kShoulderRadius, up = z - book.thickness / 2;
  const float reach = kSpineRadius - kShoulderRadius;
  return {kSpineRadius - std::sqrt(reach * reach - up * up), z};
}

/// Returns the angle of the spine's arc from its middle to the shoulder. [rad]
float spineHalfAngle(const BookDimensions& book) {
  const Vector2f centre = shoulderCentre(book);
  return static_cast<float>(arcTangent(centre.y() - book.thickness / 2, kSpineRadius - centre.x()));
}

/// Returns a point of the spine's inner side, clamped to the boards' flat inner sides.
Vector2f spineInside(const BookDimensions& book, float angle) {
  const float reach = kSpineRadius - book.board;
  const float z = book.thickness / 2 + reach * sineOf(angle);
  return {kSpineRadius - reach * cosineOf(angle),
          std::clamp(z, book.board, book.thickness - book.board)};
}

/// Adds the board's rim and its rounded outer edge; the opposite points lie on the inner side.
void addForeEdge(const BookDimensions& book, const ProfileSteps& steps,
                 std::vector<ProfilePoint>& points) {
  const float inner = book.thickness - book.board, r = book.edgeRadius;
  const Vector2f corner(book.width, inner), centre(book.width - r, book.thickness - r);
  points.push_back({corner, corner, {1, 0}, 1, true});
  for (int i = 0; i <= steps.arc; ++i) {
    const float angle = kPi / 2 * static_cast<float>(i) / static_cast<float>(steps.arc);
    const Vector2f normal(cosineOf(angle), sineOf(angle));
    const float across = book.width - r * static_cast<float>(i + 1);
    points.push_back({centre + r * normal, {across, inner}, normal});
  }
}

void addBoard(const BookDimensions& book, const ProfileSteps& steps,
              std::vector<ProfilePoint>& points) {
  const float from = points.back().inside.x(), to = book.hinge + kHingeHalfWidth;
  for (int i = 1; i < steps.board; ++i) {
    const float x = from + (to - from) * static_cast<float>(i) / static_cast<float>(steps.board);
    points.push_back({{x, book.thickness}, {x, book.thickness - book.board}, {0, 1}});
  }
}

void addHinge(const BookDimensions& book, const ProfileSteps& steps,
              std::vector<ProfilePoint>& points) {
  const Vector2f end = spineInside(book, spineHalfAngle(book));
  for (int i = 0; i <= steps.hinge; ++i) {
    const float t = 1 - 2 * static_cast<float>(i) / static_cast<float>(steps.hinge);
    const float depth = kHingeDepth * (0.5F + 0.5F * cosineOf(kPi * t));
    const float slope = kHingeDepth * 0.5F * kPi / kHingeHalfWidth * sineOf(kPi * t);
    // The shoulder's inner points take the rest of the distance to the inner spine.
    const float rest = 0.55F + 0.45F * t;
    const float across = end.x() + rest * (book.hinge + kHingeHalfWidth - end.x());
    points.push_back({{book.hinge + kHingeHalfWidth * t, book.thickness - depth},
                      {across, book.thickness - book.board},
                      Vector2f(-slope, 1).normalized(),
                      1 - (1 - kHingeSkyVisibility) * depth / kHingeDepth});
  }
}

void addShoulder(const BookDimensions& book, const ProfileSteps& steps,
                 std::vector<ProfilePoint>& points) {
  const Vector2f centre = shoulderCentre(book), from = points.back().inside;
  const Vector2f to = spineInside(book, spineHalfAngle(book));
  const float turn = kPi / 2 - spineHalfAngle(book);
  for (int i = 1; i <= steps.arc; ++i) {
    const float share = static_cast<float>(i) / static_cast<float>(steps.arc), angle = turn * share;
    const Vector2f normal(-sineOf(angle), cosineOf(angle));
    points.push_back({centre + kShoulderRadius * normal, from + share * (to - from), normal});
  }
}

}  // namespace

std::vector<ProfilePoint> frontProfile(const BookDimensions& book, const ProfileSteps& steps) {
  std::vector<ProfilePoint> points;
  addForeEdge(book, steps, points);
  addBoard(book, steps, points);
  addHinge(book, steps, points);
  addShoulder(book, steps, points);
  return points;
}

std::vector<ProfilePoint> spineProfile(const BookDimensions& book, const ProfileSteps& steps) {
  std::vector<ProfilePoint> points;
  const float half = spineHalfAngle(book);
  for (int i = 0; i <= steps.spine; ++i) {
    const float angle = half * (1 - 2 * static_cast<float>(i) / static_cast<float>(steps.spine));
    const Vector2f normal(-cosineOf(angle), sineOf(angle));
    points.push_back({Vector2f(kSpineRadius, book.thickness / 2) + kSpineRadius * normal,
                      spineInside(book, angle), normal});
  }
  return points;
}

std::vector<ProfilePoint> backProfile(const BookDimensions& book, const ProfileSteps& steps) {
  std::vector<ProfilePoint> points = frontProfile(book, steps);
  std::reverse(points.begin(), points.end());
  for (ProfilePoint& point : points) {
    point.outside.y() = book.thickness - point.outside.y();
    point.inside.y() = book.thickness - point.inside.y();
    point.normal.y() = -point.normal.y();
  }
  return points;
}

}  // namespace rotatebook::geometry
