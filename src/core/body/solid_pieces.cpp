#include "body/solid_pieces.h"

#include <cmath>
#include <vector>

#include "base/elementary.h"

namespace rotatebook::body {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

/// Returns sqrt(x / sin x) for the angle of one of `sides`.
double growthOf(int sides) {
  const double angle = 2 * kPi.high / sides;
  return std::sqrt(angle / sine(angle));
}

/// Returns point `i` of a circle of radius 1, exactly mirrored in both axes.
Vector2d onCircle(int i, int sides) {
  const int quarter = sides / 4, within = i % quarter;
  const double angle = 2 * kPi.high * within / sides;
  const double c = cosine(angle), s = sine(angle);
  switch (i / quarter % 4) {
    case 0:
      return {c, s};
    case 1:
      return {-s, c};
    case 2:
      return {-c, -s};
    default:
      return {s, -c};
  }
}

std::uint32_t addPoint(const Vector3d& point, TriangleMesh& mesh) {
  mesh.points.push_back(point);
  return static_cast<std::uint32_t>(mesh.points.size() - 1);
}

/// Joins two rings of points, or a ring and a pole, which has one point.
void joinRings(const std::vector<std::uint32_t>& from, const std::vector<std::uint32_t>& to,
               TriangleMesh& mesh) {
  for (std::size_t i = 0; i < kSides; ++i) {
    const std::size_t next = (i + 1) % kSides;
    const auto at = [](const auto& ring, std::size_t k) {
      return ring.size() > 1 ? ring[k] : ring[0];
    };
    if (from.size() > 1) mesh.triangles.push_back({at(from, i), at(from, next), at(to, i)});
    if (to.size() > 1) mesh.triangles.push_back({at(from, next), at(to, next), at(to, i)});
  }
}

}  // namespace

TriangleMesh prismOf(std::span<const Vector2d> outline, double height) {
  TriangleMesh mesh;
  const std::uint32_t bottom = addPoint({0, 0, -height / 2}, mesh);
  const std::uint32_t top = addPoint({0, 0, height / 2}, mesh);
  for (const Vector2d& point : outline) {
    addPoint({point.x(), point.y(), -height / 2}, mesh);
    addPoint({point.x(), point.y(), height / 2}, mesh);
  }
  const auto count = static_cast<std::uint32_t>(outline.size());
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t low = 2 + 2 * i, nextLow = 2 + 2 * ((i + 1) % count);
    mesh.triangles.push_back({bottom, nextLow, low});
    mesh.triangles.push_back({top, low + 1, nextLow + 1});
    mesh.triangles.push_back({low, nextLow, nextLow + 1});
    mesh.triangles.push_back({low, nextLow + 1, low + 1});
  }
  return mesh;
}

TriangleMesh cuboidOf(const Vector3d& size) {
  const double x = size.x() / 2, y = size.y() / 2;
  const Vector2d outline[] = {{x, -y}, {x, y}, {-x, y}, {-x, -y}};
  return prismOf(outline, size.z());
}

TriangleMesh turnedRound(std::span<const Vector2d> outline) {
  TriangleMesh mesh;
  const double growth = growthOf(kSides);
  std::vector<std::vector<std::uint32_t>> rings;
  for (const Vector2d& point : outline) {
    auto& ring = rings.emplace_back();
    if (point.x() == 0) {
      ring.push_back(addPoint({0, 0, point.y()}, mesh));
      continue;
    }
    for (int i = 0; i < kSides; ++i) {
      const Vector2d around = onCircle(i, kSides) * (point.x() * growth);
      ring.push_back(addPoint({around.x(), around.y(), point.y()}, mesh));
    }
  }
  for (std::size_t i = 0; i < rings.size(); ++i) {
    const auto &from = rings[i], &to = rings[(i + 1) % rings.size()];
    if (from.size() > 1 || to.size() > 1) joinRings(from, to, mesh);
  }
  return mesh;
}

TriangleMesh cylinderOf(double radius, double height) {
  const Vector2d outline[] = {
      {0, -height / 2}, {radius, -height / 2}, {radius, height / 2}, {0, height / 2}};
  return turnedRound(outline);
}

TriangleMesh ringOf(double radius, double sectionRadius) {
  constexpr int kSection = 64;
  std::vector<Vector2d> outline;
  for (int i = 0; i < kSection; ++i) {
    outline.emplace_back(Vector2d(radius, 0) +
                         onCircle(i, kSection) * (sectionRadius * growthOf(kSection)));
  }
  return turnedRound(outline);
}

TriangleMesh ellipsoidOf(const Vector3d& size) {
  // The polygon of a half circle, turned round, has a volume short of the ball's: the cones between
  // heights z, w and radii r, s have (w - z) (r^2 + r s + s^2) / 3 of pi.
  std::vector<Vector2d> outline;
  double thirds = 0;
  for (int i = -kSides / 4; i <= kSides / 4; ++i) {
    outline.push_back(onCircle((i + kSides) % kSides, kSides));
    if (i == -kSides / 4 || i == kSides / 4) outline.back().x() = 0;
    if (outline.size() < 2) continue;
    const Vector2d &a = outline[outline.size() - 2], &b = outline.back();
    thirds += (b.y() - a.y()) * (a.x() * a.x() + a.x() * b.x() + b.x() * b.x());
  }
  const double larger = exponential(logarithm(4 / thirds) / 3);
  TriangleMesh mesh = turnedRound(outline);
  for (Vector3d& point : mesh.points) point = (point * larger).cwiseProduct(size) / 2;
  return mesh;
}

void addMoved(const TriangleMesh& piece, const Vector3d& place, TriangleMesh& into) {
  const auto first = static_cast<std::uint32_t>(into.points.size());
  for (const Vector3d& point : piece.points) into.points.push_back(point + place);
  for (const auto& [a, b, c] : piece.triangles)
    into.triangles.push_back({first + a, first + b, first + c});
}

TriangleMesh alongAxis(TriangleMesh piece, int thirds) {
  for (Vector3d& point : piece.points) {
    for (int i = 0; i < thirds; ++i) point = Vector3d(point.z(), point.x(), point.y());
  }
  return piece;
}

}  // namespace rotatebook::body
