#include "scene/part_densities.h"

#include <algorithm>
#include <cstddef>
#include <string>

#include "base/error.h"
#include "base/number_text.h"
#include "body/lattice.h"
#include "scene/solid_numbers.h"

namespace rotatebook::scene {
namespace {

/// Adds a part's density at the points of a lattice that it encloses.
void addDensity(const BodyPart& part, const body::Lattice& lattice,
                std::vector<double>& densities) {
  const std::vector<int> windings = body::windingNumbers(placed(part).surface, lattice);
  for (std::size_t i = 0; i < windings.size(); ++i) densities[i] += windings[i] * densityOf(part);
}

body::Lattice latticeIn(const BodyPart& part) {
  constexpr int kCells = 24;
  const body::TriangleMesh surface = placed(part).surface;
  Eigen::Vector3d low = surface.points.front(), high = low;
  for (const Eigen::Vector3d& point : surface.points) {
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
  return body::latticeIn(low, high, kCells);
}

}  // namespace

void requireMatter(const std::vector<BodyPart>& parts) {
  constexpr double kRounding = 1e-9;  // of the density that is taken away
  if (std::ranges::all_of(parts, [](const BodyPart& part) { return densityOf(part) < 0; })) return;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (densityOf(parts[i]) > 0) continue;
    const body::Lattice lattice = latticeIn(parts[i]);
    std::vector<double> densities(lattice.size());
    for (const BodyPart& part : parts) addDensity(part, lattice, densities);
    for (const double density : densities) {
      if (density >= kRounding * densityOf(parts[i])) continue;
      throw InputError("part " + std::to_string(i + 1) +
                       " takes away more than is there: somewhere in it the densities add up to " +
                       roundedText(density, 4) +
                       " kg/m^3; move it into the others, or make it smaller or less dense");
    }
  }
}

}  // namespace rotatebook::scene
