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

/// A part in its place.
struct Placed {
  body::TriangleMesh surface;
  double density;
};

/// Returns the densities at the points of a lattice, added up.
std::vector<double> densitiesAt(const body::Lattice& lattice, const std::vector<Placed>& parts) {
  std::vector<double> densities(lattice.size());
  for (const Placed& part : parts) {
    const std::vector<int> windings = body::windingNumbers(part.surface, lattice);
    for (std::size_t i = 0; i < windings.size(); ++i) densities[i] += windings[i] * part.density;
  }
  return densities;
}

}  // namespace

void requireMatter(const std::vector<BodyPart>& parts) {
  constexpr int kCells = 24;
  constexpr double kRounding = 1e-9;  // of the density that is taken away
  const auto takesAway = [](const BodyPart& part) { return densityOf(part) < 0; };
  if (std::ranges::none_of(parts, takesAway) || std::ranges::all_of(parts, takesAway)) return;
  std::vector<Placed> all;
  for (const BodyPart& part : parts) all.push_back({placed(part).surface, densityOf(part)});
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all[i].density > 0) continue;
    const auto [low, high] = body::boxAround(all[i].surface.points);
    for (const double density : densitiesAt(body::latticeIn(low, high, kCells), all)) {
      if (density >= kRounding * all[i].density) continue;
      throw InputError("part " + std::to_string(i + 1) +
                       " takes away more than is there: somewhere in it the densities add up to " +
                       roundedText(density, 4) +
                       " kg/m^3; move it into the others, or make it smaller or less dense");
    }
  }
}

}  // namespace rotatebook::scene
