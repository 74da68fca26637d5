#include "body/solid_pieces.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "base/elementary.h"

namespace rotatebook::body {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

/// z becomes x, x becomes y.
const Eigen::Matrix3d kThird = (Eigen::Matrix3d() << 0, 0, 1, 1, 0, 0, 0, 1, 0).finished();

/// Returns sqrt(x / sin x) for the angle of one of `sides`.
double growthOf(int sides) {
  const double angle = 2 * kPi.high / sides;
  return std::sqrt(angle / sine(angle));
}

std::uint32_t addPoint(const Vector3d& point, TriangleMesh& mesh) {
  mesh.points.push_back(point);
  return static_cast<std::uint32_t>(mesh.points.size() - 1);
}

/// Joins two rings of points, or a ring and a pole, which has one point.
void joinRings(const std::vector<std::uint32_t>& from, const std::vector<std::uint32_t>& to,
               TriangleMesh& mesh) {
  const std::size_t sides = std::max(from.size(), to.size());
  for (std::size_t i = 0; i < sides; ++i) {
    const std::size_t next = (i + 1) % sides;
    const auto at = [](const auto& ring, std::size_t k) {
      return ring.size() > 1 ? ring[k] : ring[0];
    };
    if (from.size() > 1) mesh.triangles.push_back({at(from, i), at(from, next), at(to, i)});
    if (to.size() > 1) mesh.triangles.push_back({at(from, next), at(to, next), at(to, i)});
  }
}

/// Returns the mass properties of a body around the origin, by its volume [m^3] and the mean
/// squares of its coordinates [m^2].
MassProperties around(double volume, const Vector3d& squares) {
  MassProperties body{volume, volume};
  body.inertia = (volume * (Vector3d::Constant(squares.sum()) - squares)).asDiagonal();
  return body;
}

MassProperties cylinder(double radius, double height) {
  const double square = radius * radius;
  return around(kPi.high * square * height, {square / 4, square / 4, height * height / 12});
}

}  // namespace

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

TriangleMesh turnedRound(std::span<const Vector2d> outline, int sides) {
  TriangleMesh mesh;
  const double growth = growthOf(sides);
  std::vector<std::vector<std::uint32_t>> rings;
  for (const Vector2d& point : outline) {
    auto& ring = rings.emplace_back();
    if (point.x() == 0) {
      ring.push_back(addPoint({0, 0, point.y()}, mesh));
      continue;
    }
    for (int i = 0; i < sides; ++i) {
      const Vector2d around = onCircle(i, sides) * (point.x() * growth);
      ring.push_back(addPoint({around.x(), around.y(), point.y()}, mesh));
    }
  }
  for (std::size_t i = 0; i < rings.size(); ++i) {
    const auto &from = rings[i], &to = rings[(i + 1) % rings.size()];
    if (from.size() > 1 || to.size() > 1) joinRings(from, to, mesh);
  }
  return mesh;
}

SolidPiece prismOf(std::span<const Vector2d> outline, double height) {
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
  return {mesh, massPropertiesOf(mesh, 1)};
}

SolidPiece cuboidOf(const Vector3d& size) {
  const double x = size.x() / 2, y = size.y() / 2;
  const Vector2d outline[] = {{x, -y}, {x, y}, {-x, y}, {-x, -y}};
  return {prismOf(outline, size.z()).surface, around(size.prod(), size.cwiseAbs2() / 12)};
}

SolidPiece cylinderOf(double radius, double height) {
  const Vector2d outline[] = {
      {0, -height / 2}, {radius, -height / 2}, {radius, height / 2}, {0, height / 2}};
  return {turnedRound(outline), cylinder(radius, height)};
}

SolidPiece tubeOf(double radius, double bore, double height) {
  const Vector2d outline[] = {
      {bore, -height / 2}, {radius, -height / 2}, {radius, height / 2}, {bore, height / 2}};
  MassProperties hole = cylinder(bore, height);
  for (double* number : {&hole.volume, &hole.mass}) *number = -*number;
  hole.inertia = -hole.inertia;
  return {turnedRound(outline), sumOf(cylinder(radius, height), hole)};
}

SolidPiece ringOf(double radius, double sectionRadius) {
  constexpr int kSection = 64;
  std::vector<Vector2d> outline;
  for (int i = 0; i < kSection; ++i) {
    outline.emplace_back(Vector2d(radius, 0) +
                         onCircle(i, kSection) * (sectionRadius * growthOf(kSection)));
  }
  // V = 2 pi^2 R r^2, I_z / m = R^2 + 3/4 r^2, I_x / m = R^2 / 2 + 5/8 r^2
  const double circle = radius * radius, section = sectionRadius * sectionRadius;
  const double across = (circle + 0.75 * section) / 2;
  return {turnedRound(outline),
          around(2 * kPi.high * kPi.high * radius * section, {across, across, section / 4})};
}

SolidPiece ellipsoidOf(const Vector3d& size, int sides) {
  // The polygon of a half circle, turned round, has a volume short of the ball's: the cones between
  // heights z, w and radii r, s have (w - z) (r^2 + r s + s^2) / 3 of pi.
  std::vector<Vector2d> outline;
  double thirds = 0;
  for (int i = -sides / 4; i <= sides / 4; ++i) {
    outline.push_back(onCircle((i + sides) % sides, sides));
    if (i == -sides / 4 || i == sides / 4) outline.back().x() = 0;
    if (outline.size() < 2) continue;
    const Vector2d &a = outline[outline.size() - 2], &b = outline.back();
    thirds += (b.y() - a.y()) * (a.x() * a.x() + a.x() * b.x() + b.x() * b.x());
  }
  const double larger = exponential(logarithm(4 / thirds) / 3);
  TriangleMesh mesh = turnedRound(outline, sides);
  for (Vector3d& point : mesh.points) point = (point * larger).cwiseProduct(size) / 2;
  return {mesh, around(kPi.high / 6 * size.prod(), size.cwiseAbs2() / 20)};
}

void addMoved(const SolidPiece& piece, const Vector3d& place, SolidPiece& into) {
  const MassProperties placed = moved(piece.properties, Eigen::Matrix3d::Identity(), place);
  TriangleMesh& all = into.surface;
  into.properties = all.points.empty() ? placed : sumOf(into.properties, placed);
  const std::size_t first = all.points.size();
  append(piece.surface, all);
  for (std::size_t i = first; i < all.points.size(); ++i) all.points[i] += place;
}

TriangleMesh alongAxis(TriangleMesh mesh, int thirds) {
  for (int i = 0; i < thirds; ++i) {
    for (Vector3d& point : mesh.points) point = kThird * point;
  }
  return mesh;
}

SolidPiece alongAxis(SolidPiece piece, int thirds) {
  piece.surface = alongAxis(std::move(piece.surface), thirds);
  for (int i = 0; i < thirds; ++i) piece.properties = moved(piece.properties, kThird, {0, 0, 0});
  return piece;
}

}  // namespace rotatebook::body
