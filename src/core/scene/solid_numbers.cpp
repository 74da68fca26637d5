#include "scene/solid_numbers.h"

#include <cmath>
#include <vector>

#include "base/elementary.h"
#include "base/error.h"
#include "body/closed_surface.h"
#include "body/shape.h"
#include "rigid/inertia.h"

namespace rotatebook::scene {
namespace {

using body::MassProperties;
using body::TriangleMesh;
using Eigen::Matrix3d;
using Eigen::Vector3d;

/// A box around all points that are added.
struct Box {
  Vector3d low{0, 0, 0}, high{0, 0, 0};
  bool isEmpty = true;

  void add(const TriangleMesh& mesh) {
    for (const Vector3d& point : mesh.points) {
      low = isEmpty ? point : low.cwiseMin(point);
      high = isEmpty ? point : high.cwiseMax(point);
      isEmpty = false;
    }
  }
  Vector3d size() const { return high - low; }
};

Matrix3d rotationOf(const Turn& turn) {
  const double c = cosine(turn.angle), s = sine(turn.angle);
  const int i = (turn.axis + 1) % 3, j = (turn.axis + 2) % 3;
  Matrix3d rotation = Matrix3d::Identity();
  rotation(i, i) = rotation(j, j) = c;
  rotation(j, i) = s;
  rotation(i, j) = -s;
  return rotation;
}

MassProperties multiplied(MassProperties properties, double factor) {
  properties.mass *= factor;
  properties.inertia *= factor;
  return properties;
}

SolidNumbers numbersOfParts(const std::vector<BodyPart>& parts) {
  // Take away last, so that all sums before are bodies
  std::vector<MassProperties> added, taken;
  Box box;
  for (const BodyPart& part : parts) {
    const body::SolidPiece piece = placed(part);
    const double density = part.density.value_or(body::findShape(part.shape)->density);
    MassProperties one = multiplied(piece.properties, density);
    if (density > 0) box.add(piece.surface);
    if (density < 0) one.volume = -one.volume;
    (density < 0 ? taken : added).push_back(one);
  }
  if (added.empty())
    throw InputError("all parts have negative densities; what they take away needs a body");
  MassProperties sum = added.front();
  for (std::size_t i = 1; i < added.size(); ++i) sum = sumOf(sum, added[i]);
  for (const MassProperties& one : taken) sum = sumOf(sum, one);
  return {sum, box.size()};
}

/// Sets products of inertia that rounding alone makes to 0, so that a spin about an axis of a
/// symmetric body is exactly about it.
void clearRounding(Matrix3d& inertia) {
  constexpr double kRounding = 1e-15;  // Of the largest moment; measured 2e-16.
  const double least = kRounding * inertia.diagonal().maxCoeff();
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      if (i != j && std::fabs(inertia(i, j)) < least) inertia(i, j) = 0;
    }
  }
}

SolidNumbers numbersOfMesh(const MeshFile& mesh, double density) {
  const double u = mesh.unit, cubed = u * u * u;
  return {multiplied({mesh.volume * cubed, mesh.volume * cubed, Vector3d::Zero(),
                      mesh.inertia * (cubed * (u * u))},
                     density),
          mesh.size * u};
}

}  // namespace

body::SolidPiece placed(const BodyPart& part) {
  const body::Shape* shape = body::findShape(part.shape);
  if (shape == nullptr || part.lengths.size() != shape->lengths.size())
    throw InputError("a part needs a known shape, and each of its lengths");
  body::SolidPiece piece = shape->solid(part.lengths);
  const Matrix3d rotation = part.turn ? rotationOf(*part.turn) : Matrix3d::Identity();
  for (Vector3d& point : piece.surface.points) point = rotation * point + part.place;
  piece.properties = moved(piece.properties, rotation, part.place);
  return piece;
}

SolidNumbers numbersOf(const Solid& solid) {
  SolidNumbers numbers = solid.mesh.name.empty()
                             ? numbersOfParts(solid.parts)
                             : numbersOfMesh(solid.mesh, solid.density.value_or(1));
  MassProperties& properties = numbers.properties;
  if (solid.mass) properties = multiplied(properties, *solid.mass / properties.mass);
  clearRounding(properties.inertia);
  rigid::checkInertia(properties.inertia);
  return numbers;
}

MeshFile meshFileOf(const std::string& name, const TriangleMesh& mesh) {
  body::requireClosed(mesh);
  const MassProperties properties = body::massPropertiesOf(mesh, 1);
  Box box;
  box.add(mesh);
  return {name, 1, properties.volume, box.size(), properties.inertia};
}

}  // namespace rotatebook::scene
