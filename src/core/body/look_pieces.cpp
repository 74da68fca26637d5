#include "body/look_pieces.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "base/srgb.h"
#include "body/solid_pieces.h"

namespace rotatebook::body {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr int kBevelSteps = 4;

float linearOf(std::uint32_t byte) {
  return static_cast<float>(decodedSrgb(byte / 255.0));
}

/// Returns the size of grains that are long along one axis. [m]
Vector3d streaks(int axis, double along, double across) {
  Vector3d size = Vector3d::Constant(across);
  size[axis] = along;
  return size;
}

}  // namespace

Material materialOfColour(std::uint32_t colour, float metalness, float roughness,
                          const Grain& grain) {
  Material material{.metalness = metalness, .roughness = roughness, .grain = grain};
  for (int i = 0; i < 3; ++i) material.baseColour[i] = linearOf(colour >> (16 - 8 * i) & 0xff);
  return material;
}

Material aluminium(int axis) {
  return materialOfColour(0xe3e4e6, 1, 0.34F, {streaks(axis, 0.03, 0.0006), 0.10F, 4e-6F});
}

Material brass(int axis) {
  return materialOfColour(0xe0b566, 1, 0.30F, {streaks(axis, 0.012, 0.0004), 0.08F, 3e-6F});
}

Material wood(std::uint32_t colour, int axis) {
  return materialOfColour(colour, 0, 0.42F, {streaks(axis, 0.12, 0.0035), 0.45F, 1e-5F});
}

std::vector<Vector2d> roundRectangle(const Vector2d& size, double corner) {
  constexpr int kSteps = 8;
  const Vector2d inner = size / 2 - Vector2d::Constant(corner);
  std::vector<Vector2d> outline;
  for (int quarter = 0; quarter < 4; ++quarter) {
    const Vector2d middle(quarter == 0 || quarter == 3 ? inner.x() : -inner.x(),
                          quarter < 2 ? inner.y() : -inner.y());
    for (int i = 0; i <= kSteps; ++i)
      outline.push_back(middle + corner * onCircle(quarter * kSteps + i, 4 * kSteps));
  }
  return outline;
}

std::vector<Layer> roundedLayers(double height, double radius) {
  std::vector<Layer> layers;
  for (int i = 0; i <= 2 * kBevelSteps + 1; ++i) {
    const bool isUpper = i > kBevelSteps;
    const Vector2d arc = onCircle(isUpper ? i - kBevelSteps - 1 : kBevelSteps - i, 4 * kBevelSteps);
    const double up = height / 2 - radius * (1 - arc.y());
    layers.push_back({isUpper ? up : -up, radius - radius * arc.x()});
  }
  return layers;
}

TriangleMesh plateOf(const Vector2d& size, double corner, std::span<const Layer> layers,
                     bool bottom, bool top) {
  TriangleMesh mesh;
  for (const auto& [z, inset] : layers) {
    const Vector2d smaller = size - Vector2d::Constant(2 * inset);
    for (const Vector2d& point : roundRectangle(smaller, corner - inset))
      mesh.points.emplace_back(point.x(), point.y(), z);
  }
  const auto rings = static_cast<std::uint32_t>(layers.size());
  const auto sides = static_cast<std::uint32_t>(mesh.points.size()) / rings;
  for (std::uint32_t ring = 0; ring + 1 < rings; ++ring) {
    for (std::uint32_t i = 0; i < sides; ++i) {
      const std::uint32_t a = ring * sides + i, b = ring * sides + (i + 1) % sides;
      mesh.triangles.push_back({a, b, b + sides});
      mesh.triangles.push_back({a, b + sides, a + sides});
    }
  }
  for (std::uint32_t i = 1; i + 1 < sides; ++i) {
    const std::uint32_t last = (rings - 1) * sides;
    if (bottom) mesh.triangles.push_back({0, i + 1, i});
    if (top) mesh.triangles.push_back({last, last + i, last + i + 1});
  }
  return mesh;
}

TriangleMesh roundedCylinder(double radius, double height, double most) {
  const double edge = std::min({most, radius / 2, height / 4});
  std::vector<Vector2d> outline{{0, -height / 2}};
  for (const auto& [z, inset] : roundedLayers(height, edge))
    outline.emplace_back(radius - inset, z);
  outline.emplace_back(0, height / 2);
  return turnedRound(outline);
}

Surface surfaceOf(TriangleMesh mesh, const Material& material) {
  return {.mesh = std::move(mesh), .materials = {material}};
}

TriangleMesh movedBy(TriangleMesh mesh, const Vector3d& place) {
  for (Vector3d& point : mesh.points) point += place;
  return mesh;
}

}  // namespace rotatebook::body
