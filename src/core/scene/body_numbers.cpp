#include "scene/body_numbers.h"

#include "base/error.h"
#include "base/text.h"
#include "body/closed_mesh.h"
#include "body/self_crossing.h"
#include "body/shells.h"
#include "meshes/mesh_readers.h"
#include "physics/measure/flip_interval.h"
#include "physics/motion_start.h"
#include "rigid/inertia.h"
#include "rigid/regime.h"
#include "scene/solid_numbers.h"

namespace rotatebook::scene {
namespace {

BodySurface closedSurfaceOf(const body::ClosedMesh& file) {
  const body::TriangleMesh& mesh = file.surface.mesh;
  const body::Shells shells = body::shellsOf(mesh);
  const auto inFile = [&](auto pair) {
    if (pair) pair = {file.closing.numberOf((*pair)[0]), file.closing.numberOf((*pair)[1])};
    return pair;
  };
  return {mesh.triangles.size(), shells.count, inFile(body::findSelfCrossing(mesh)),
          inFile(shells.overlap), file.closing.notes};
}

BodyNumbers numbersOfBook(const Panel& motion) {
  const rigid::PrincipalAxes inertia = physics::modelInertia(motion);
  const Eigen::Matrix3d& axes = inertia.bodyFromPrincipal;
  return {{motion.body.size.prod(),
           motion.body.mass,
           {0, 0, 0},
           axes * inertia.moments.asDiagonal() * axes.transpose()}};
}

/// The scene has the mesh's numbers, but for its centre.
BodyNumbers numbersOfMesh(const Solid& solid) {
  const body::ClosedMesh& file = *solid.mesh.content;
  BodyNumbers numbers{numbersOf(solid).properties, closedSurfaceOf(file)};
  numbers.properties.centre = body::massPropertiesOf(file.surface.mesh, 1).centre * solid.mesh.unit;
  return numbers;
}

BodyNumbers numbersOfParts(const Solid& solid) {
  BodySurface surface;
  for (const BodyPart& part : solid.parts) {
    const body::TriangleMesh mesh = placed(part).surface;
    surface.triangles += mesh.triangles.size();
    surface.shells += body::shellsOf(mesh).count;
  }
  return {numbersOf(solid).properties, surface};
}

}  // namespace

BodyNumbers bodyNumbersOf(const Panel& motion) {
  if (motion.solid.isBook()) return numbersOfBook(motion);
  return motion.solid.parts.empty() ? numbersOfMesh(motion.solid) : numbersOfParts(motion.solid);
}

bool isMesh(std::string_view name) {
  return meshes::isMeshName(name);
}

BodyNumbers bodyNumbersOf(const std::string& name, std::string_view bytes,
                          const MeshSubstance& substance) {
  constexpr double kWater = 1000;  // [kg/m^3]
  body::ClosedMesh file = meshes::readMesh(name, bytes);
  try {
    body::TriangleMesh& mesh = file.surface.mesh;
    for (Eigen::Vector3d& point : mesh.points) point *= substance.unit;
    double density = substance.density.value_or(kWater);
    if (substance.mass) density = *substance.mass / body::massPropertiesOf(mesh, 1).volume;
    const body::MassProperties properties = body::massPropertiesOf(mesh, density);
    rigid::checkedInertia(properties.inertia);
    return {properties, closedSurfaceOf(file)};
  } catch (const InputError& error) {
    throw InputError(oneLine(name, 200) + ": " + error.what());
  }
}

SortedAxes sortedAxesOf(const body::MassProperties& properties) {
  const rigid::PrincipalAxes principal = rigid::principalAxes(properties.inertia);
  const auto order = rigid::axesByInertia(principal.moments);
  SortedAxes sorted;
  for (int i = 0; i < 3; ++i) {
    const int from = order[static_cast<std::size_t>(i)];
    sorted.moments[i] = principal.moments[from];
    sorted.axes.col(i) = principal.bodyFromPrincipal.col(from);
  }
  if (sorted.axes.determinant() < 0) sorted.axes.col(2) *= -1;
  sorted.axes.array() += 0.0;  // No -0
  sorted.growth = physics::tiltGrowth(principal);
  return sorted;
}

}  // namespace rotatebook::scene
