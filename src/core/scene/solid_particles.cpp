#include "scene/solid_particles.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

#include "base/error.h"
#include "body/closed_mesh.h"
#include "body/lattice.h"
#include "body/shape.h"
#include "scene/solid_numbers.h"

namespace rotatebook::scene {
namespace {

using body::Lattice;
using body::TriangleMesh;
using Eigen::Vector3d;
using physics::kMaxParticles;
using physics::MassSpringSystem;
using physics::Spring;

/// A surface of the body, of what it has or what is taken away.
struct Surface {
  TriangleMesh mesh;  // [m]
  bool isTaken = false;
};

/// Throws InputError if parts have different densities, which equal particles can't show.
void requireOneDensity(const Solid& solid) {
  double density = 0;
  for (const BodyPart& part : solid.parts) {
    const double own = std::abs(densityOf(part));
    if (density != 0 && own != density)
      throw InputError(
          "makes particles of equal mass, and so a body of one density, but its parts have "
          "several; take \"equimomental\", or give them one");
    density = own;
  }
}

/// Throws InputError if the mass of a part isn't within its surface.
void requireSolids(const Solid& solid) {
  for (const BodyPart& part : solid.parts) {
    const body::Shape* shape = body::findShape(part.shape);
    if (shape == nullptr || shape->weights == nullptr) continue;
    throw InputError(
        "is of a body whose mass is in a few points, not within its surface; choose "
        "another model, such as \"exact\"");
  }
}

std::vector<Surface> surfacesOf(const Motion& motion) {
  const Solid& solid = motion.solid;
  std::vector<Surface> surfaces;
  if (solid.isBook()) {
    const Vector3d& size = motion.body.size;
    surfaces.push_back({placed({"box", {size.x(), size.y(), size.z()}}).surface});
  } else if (!solid.mesh.name.empty()) {
    surfaces.push_back({solid.mesh.content->surface.mesh});
    for (Vector3d& point : surfaces.back().mesh.points) point *= solid.mesh.unit;
  }
  requireOneDensity(solid);
  requireSolids(solid);
  for (const BodyPart& part : solid.parts)
    surfaces.push_back({placed(part).surface, densityOf(part) < 0});
  return surfaces;
}

void refuseMany(std::size_t count, const std::string& remedy) {
  if (count <= kMaxParticles) return;
  throw InputError("makes " + std::to_string(count) + " particles; the limit is " +
                   std::to_string(kMaxParticles) + ": " + remedy);
}

/// Returns all triangles with every vertex once.
TriangleMesh joinedMesh(const std::vector<Surface>& surfaces) {
  TriangleMesh all;
  for (const Surface& surface : surfaces) body::append(surface.mesh, all);
  return body::welded(all);
}

/// Returns the springs with every pair once, in the order of their ends.
std::vector<Spring> once(std::vector<Spring> springs) {
  const auto ends = [](const Spring& spring) { return std::pair(spring.a, spring.b); };
  for (Spring& spring : springs) {
    if (spring.a > spring.b) std::swap(spring.a, spring.b);
  }
  std::erase_if(springs, [](const Spring& spring) { return spring.a == spring.b; });
  std::ranges::stable_sort(springs, {}, ends);
  springs.erase(std::unique(springs.begin(), springs.end()), springs.end());
  return springs;
}

/// Springs from each vertex to others that are so many further in the list.
void addAcross(std::size_t count, std::vector<Spring>& springs) {
  // 2 - sqrt 3, the golden section and sqrt 2 - 1: steps that no simple pattern of a mesh repeats.
  constexpr std::array kShares{0.2679, 0.3820, 0.4142};
  for (const double share : kShares) {
    const auto step = static_cast<std::size_t>(share * static_cast<double>(count));
    for (std::size_t i = 0; i < count; ++i) {
      springs.push_back(
          {static_cast<std::uint32_t>(i), static_cast<std::uint32_t>((i + step) % count)});
    }
  }
}

Lattice latticeOf(const std::vector<Surface>& surfaces, int cells) {
  std::vector<Vector3d> points;
  for (const Surface& surface : surfaces) {
    if (surface.isTaken) continue;
    points.insert(points.end(), surface.mesh.points.begin(), surface.mesh.points.end());
  }
  const auto [low, high] = body::boxAround(points);
  return body::latticeIn(low, high, cells);
}

/// Returns whether each point of the lattice is in the body.
std::vector<bool> insideOf(const std::vector<Surface>& surfaces, const Lattice& lattice) {
  std::vector<bool> inside(lattice.size(), false);
  for (const bool isTaken : {false, true}) {
    for (const Surface& surface : surfaces) {
      if (surface.isTaken != isTaken) continue;
      const std::vector<int> windings = body::windingNumbers(surface.mesh, lattice);
      for (std::size_t i = 0; i < windings.size(); ++i) {
        if (windings[i] > 0) inside[i] = !isTaken;
      }
    }
  }
  return inside;
}

/// The particles of a lattice: who is where.
struct Filled {
  Lattice lattice;
  std::vector<std::array<int, 3>> cells;  // of each particle
  std::vector<std::uint32_t> numbers;     // of each point's particle; kNone for none

  static constexpr std::uint32_t kNone = 0xffffffff;
};

Filled filled(const Lattice& lattice, const std::vector<bool>& inside) {
  Filled result{lattice, {}, std::vector<std::uint32_t>(inside.size(), Filled::kNone)};
  for (int z = 0; z < lattice.counts[2]; ++z) {
    for (int y = 0; y < lattice.counts[1]; ++y) {
      for (int x = 0; x < lattice.counts[0]; ++x) {
        const std::size_t point = lattice.index(x, y, z);
        if (!inside[point]) continue;
        result.numbers[point] = static_cast<std::uint32_t>(result.cells.size());
        result.cells.push_back({x, y, z});
      }
    }
  }
  return result;
}

/// Returns the steps to half of the points within two cells; the other half are their opposites.
std::vector<std::array<int, 3>> stepsWithinTwo() {
  constexpr int kFar = 2;
  std::vector<std::array<int, 3>> steps;
  for (int z = 0; z <= kFar; ++z) {
    for (int y = -kFar; y <= kFar; ++y) {
      for (int x = -kFar; x <= kFar; ++x) {
        const bool isFirstHalf = z > 0 || y > 0 || (y == 0 && x > 0);
        if (isFirstHalf && x * x + y * y + z * z <= kFar * kFar) steps.push_back({x, y, z});
      }
    }
  }
  return steps;
}

std::vector<Spring> springsWithinTwo(const Filled& filled) {
  const auto steps = stepsWithinTwo();
  std::vector<Spring> springs;
  for (std::uint32_t i = 0; i < filled.cells.size(); ++i) {
    for (const auto& step : steps) {
      std::array<int, 3> other{};
      bool isWithin = true;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        other.at(axis) = filled.cells[i].at(axis) + step.at(axis);
        isWithin =
            isWithin && other.at(axis) >= 0 && other.at(axis) < filled.lattice.counts.at(axis);
      }
      if (!isWithin) continue;
      const auto number = filled.numbers[filled.lattice.index(other[0], other[1], other[2])];
      if (number != Filled::kNone) springs.push_back({i, number});
    }
  }
  return springs;
}

/// Returns the largest grid that has few enough particles, if `cells` have `count`.
int cellsForFewer(int cells, std::size_t count) {
  const auto cube = [](int n) { return 1.0 * n * n * n; };
  int fewer = cells;
  while (fewer > 1 && cube(fewer) * static_cast<double>(count) > kMaxParticles * cube(cells))
    --fewer;
  return fewer;
}

}  // namespace

bool lacksSurface(const Motion& motion) {
  const MeshFile& mesh = motion.solid.mesh;
  return motion.simulation.model == physics::Model::Particles &&
         !physics::areEight(motion.simulation.particles.arrangement) && !mesh.name.empty() &&
         mesh.content == nullptr;
}

MassSpringSystem particlesAtVertices(const Motion& motion) {
  TriangleMesh mesh = joinedMesh(surfacesOf(motion));
  refuseMany(mesh.points.size(), "take a grid, or a coarser mesh");
  std::vector<Spring> springs;
  for (const auto& [a, b, c] : mesh.triangles)
    springs.insert(springs.end(), {Spring{a, b}, Spring{b, c}, Spring{c, a}});
  addAcross(mesh.points.size(), springs);
  physics::centre(mesh.points);
  return {std::move(mesh.points), once(std::move(springs))};
}

MassSpringSystem particlesOnGrid(const Motion& motion, int cells) {
  const std::vector<Surface> surfaces = surfacesOf(motion);
  const Lattice lattice = latticeOf(surfaces, cells);
  const Filled filledLattice = filled(lattice, insideOf(surfaces, lattice));
  const std::size_t count = filledLattice.cells.size();
  refuseMany(count, "take \"grid:" + std::to_string(cellsForFewer(cells, count)) + "\"");
  MassSpringSystem system;
  if (count == 0) return system;
  for (const auto& [x, y, z] : filledLattice.cells) system.places.push_back(lattice.point(x, y, z));
  physics::centre(system.places);
  system.springs = springsWithinTwo(filledLattice);
  return system;
}

}  // namespace rotatebook::scene
