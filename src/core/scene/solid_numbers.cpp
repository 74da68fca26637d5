#include "scene/solid_numbers.h"

#include <cmath>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "base/checksum.h"
#include "base/elementary.h"
#include "base/error.h"
#include "base/text.h"
#include "body/shape.h"
#include "meshes/mesh_readers.h"
#include "rigid/inertia.h"

namespace rotatebook::scene {
namespace {

using body::MassProperties;
using body::TriangleMesh;
using Eigen::Matrix3d;
using Eigen::Vector3d;

/// Returns the box around meshes whose middle is `centre`: the centre of mass.
Vector3d boxAround(const Vector3d& centre, std::span<const TriangleMesh> meshes) {
  Vector3d half = Vector3d::Zero();
  for (const TriangleMesh& mesh : meshes) {
    for (const Vector3d& point : mesh.points) half = half.cwiseMax((point - centre).cwiseAbs());
  }
  return 2 * half;
}

Matrix3d rotationOf(const BodyPart& part) {
  if (!part.turn) return Matrix3d::Identity();
  const physics::Tilt& turn = *part.turn;
  const double c = cosine(turn.angle), s = sine(turn.angle);
  const int i = (turn.axis + 1) % 3, j = (turn.axis + 2) % 3;
  Matrix3d rotation = Matrix3d::Identity();
  rotation(i, i) = rotation(j, j) = c;
  rotation(j, i) = s;
  rotation(i, j) = -s;
  return rotation;
}

/// Turns a part's surface and moves it.
void putInPlace(const BodyPart& part, TriangleMesh& surface) {
  const Matrix3d rotation = rotationOf(part);
  for (Vector3d& point : surface.points) point = rotation * point + part.place;
}

/// The numbers of a solid, of which may be no body.
struct Sum {
  MassProperties properties;
  Vector3d size;
};

MassProperties multiplied(MassProperties properties, double factor) {
  properties.mass *= factor;
  properties.inertia *= factor;
  return properties;
}

Sum sumOfParts(const std::vector<BodyPart>& parts) {
  // Take away last, so that all sums before are bodies
  std::vector<MassProperties> added, taken;
  std::vector<TriangleMesh> surfaces;
  for (const BodyPart& part : parts) {
    const body::SolidPiece piece = placed(part);
    const double density = densityOf(part);
    MassProperties one = multiplied(piece.properties, density);
    if (density > 0) surfaces.push_back(piece.surface);
    if (density < 0) one.volume = -one.volume;
    (density < 0 ? taken : added).push_back(one);
  }
  if (added.empty())
    throw InputError("all parts have negative densities; what they take away needs a body");
  MassProperties sum = added.front();
  for (std::size_t i = 1; i < added.size(); ++i) sum = sumOf(sum, added[i]);
  for (const MassProperties& one : taken) sum = sumOf(sum, one);
  return {sum, boxAround(sum.centre, surfaces)};
}

void requireDrawable(const body::Surface& surface, const std::string& name) {
  const std::size_t count = surface.mesh.triangles.size();
  if (count <= body::kMaxDrawnTriangles) return;
  throw InputError(name + " has " + std::to_string(count) +
                   " triangles or more; pictures take up to " +
                   std::to_string(body::kMaxDrawnTriangles) + ": make it coarser");
}

Sum sumOfMesh(const MeshFile& mesh, double density) {
  const double u = mesh.unit, cubed = u * u * u;
  return {multiplied({mesh.volume * cubed, mesh.volume * cubed, Vector3d::Zero(),
                      mesh.inertia * (cubed * (u * u))},
                     density),
          mesh.size * u};
}

/// Returns the look of a mesh whose file was read.
body::Surface lookOfMesh(const MeshFile& mesh) {
  const body::ClosedMesh& file = *mesh.content;
  if (!file.undrawable.empty()) throw InputError(oneLine(mesh.name, 200) + ": " + file.undrawable);
  requireDrawable(file.surface, mesh.name);
  body::Surface surface = file.surface;
  const Vector3d centre = body::massPropertiesOf(surface.mesh, 1).centre;
  for (Vector3d& point : surface.mesh.points) point = (point - centre) * mesh.unit;
  return surface;
}

}  // namespace

double densityOf(const BodyPart& part) {
  return part.density.value_or(body::findShape(part.shape)->density);
}

body::SolidPiece placed(const BodyPart& part) {
  const body::Shape* shape = body::findShape(part.shape);
  if (shape == nullptr || part.lengths.size() != shape->lengths.size())
    throw InputError("a part needs a known shape, and each of its lengths");
  body::SolidPiece piece = shape->solid(part.lengths);
  putInPlace(part, piece.surface);
  piece.properties = moved(piece.properties, rotationOf(part), part.place);
  return piece;
}

body::Surface surfaceOf(const Solid& solid) {
  if (!solid.mesh.name.empty()) return lookOfMesh(solid.mesh);
  body::Surface surface;
  for (const BodyPart& part : solid.parts) {
    if (part.density && *part.density < 0) continue;
    body::Surface look = body::findShape(part.shape)->look(part.lengths);
    putInPlace(part, look.mesh);
    addSurface(look, surface);
    requireDrawable(surface, "body.part");
  }
  const Vector3d centre = sumOfParts(solid.parts).properties.centre;
  surface.mesh = body::welded(surface.mesh);
  for (Vector3d& point : surface.mesh.points) point -= centre;
  return surface;
}

SolidNumbers numbersOf(const Solid& solid) {
  auto [properties, size] = solid.mesh.name.empty()
                                ? sumOfParts(solid.parts)
                                : sumOfMesh(solid.mesh, solid.density.value_or(1));
  if (solid.mass) properties = multiplied(properties, *solid.mass / properties.mass);
  rigid::clearRounding(properties.inertia);
  return {properties, size, rigid::checkedInertia(properties.inertia)};
}

MeshFile readMeshFile(const std::string& name, std::string_view bytes) {
  auto content = std::make_shared<const body::ClosedMesh>(meshes::readMesh(name, bytes));
  const TriangleMesh& mesh = content->surface.mesh;
  const MassProperties properties = body::massPropertiesOf(mesh, 1);
  return {name,
          1,
          properties.volume,
          boxAround(properties.centre, {&mesh, 1}),
          properties.inertia,
          std::move(content),
          checksumOf(bytes)};
}

void takeMeshFile(std::string_view bytes, MeshFile& mesh) {
  MeshFile file = readMeshFile(mesh.name, bytes);
  file.unit = mesh.unit;
  if (file != mesh)
    throw InputError("the file " + quotedText(mesh.name) + " has changed: it is another body");
  mesh = std::move(file);
}

}  // namespace rotatebook::scene
