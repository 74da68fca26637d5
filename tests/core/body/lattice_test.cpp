#include "body/lattice.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <gtest/gtest.h>

#include "body/closed_surface.h"
#include "body/mass_properties.h"
#include "body/shape.h"
#include "body/solid_pieces.h"

namespace rotatebook::body {
namespace {

using Eigen::Vector3d;

Lattice around(const TriangleMesh& mesh, int cells) {
  Vector3d low = mesh.points.front(), high = low;
  for (const Vector3d& point : mesh.points) {
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
  return latticeIn(low, high, cells);
}

TEST(Lattice, HasAPointInTheMiddleOfEachCell) {
  const Lattice lattice = latticeIn({0, 0, 0}, {4, 2, 1}, 4);
  EXPECT_EQ(lattice.cell, 1);
  EXPECT_EQ(lattice.counts, (std::array{4, 2, 1}));
  EXPECT_EQ(lattice.point(0, 0, 0), Vector3d(0.5, 0.5, 0.5));
  EXPECT_EQ(lattice.point(3, 1, 0), Vector3d(3.5, 1.5, 0.5));
}

TEST(Lattice, FillsSidesThatRoundingMakesLonger) {
  EXPECT_EQ(latticeIn({0, 0, 0}, {0.3, 0.1 + 1e-15, 0.2}, 3).counts, (std::array{3, 1, 2}));
}

TEST(WindingNumbers, AreOneThroughoutABox) {
  const TriangleMesh box = cuboidOf({0.3, 0.2, 0.1}).surface;
  for (const int winding : windingNumbers(box, around(box, 12))) EXPECT_EQ(winding, 1);
}

// Lines of this lattice go through edges and corners of the mesh, and along its sides.
TEST(WindingNumbers, AreZeroOrOneOnTheEdgesOfABox) {
  const TriangleMesh box = cuboidOf({2, 2, 2}).surface;
  const Lattice lattice{{-2, -2, -2}, 0.5, {9, 9, 9}};
  const auto windings = windingNumbers(box, lattice);
  for (int z = 0; z < 9; ++z) {
    for (int y = 0; y < 9; ++y) {
      for (int x = 0; x < 9; ++x) {
        const double farthest = lattice.point(x, y, z).cwiseAbs().maxCoeff();
        const int winding = windings[lattice.index(x, y, z)];
        if (farthest < 1) {
          EXPECT_EQ(winding, 1) << x << y << z;
        }
        if (farthest > 1) {
          EXPECT_EQ(winding, 0) << x << y << z;
        }
        if (farthest == 1) {
          EXPECT_TRUE(winding == 0 || winding == 1) << x << y << z;
        }
      }
    }
  }
}

TEST(WindingNumbers, CountEachSurfaceThatEncloses) {
  SolidPiece both = cuboidOf({4, 4, 4});
  addMoved(cuboidOf({2, 2, 2}), {0.5, 0, 0}, both);
  const Lattice lattice{{-1.75, 0, 0}, 1, {4, 1, 1}};
  EXPECT_EQ(windingNumbers(both.surface, lattice), (std::vector{1, 1, 2, 2}));
}

/// Returns cells along a mesh's longest side, so many that twelve are along its shortest.
int manyCells(const TriangleMesh& mesh) {
  const auto counts = around(mesh, 1000).counts;
  const auto [least, most] = std::minmax_element(counts.begin(), counts.end());
  return std::max(60, 12 * *most / *least);
}

// As many cells as the volume has, for every shape.
TEST(WindingNumbers, FillTheVolume) {
  for (const Shape& shape : allShapes()) {
    if (shape.weights != nullptr) continue;  // not a solid
    std::vector<double> lengths;
    for (const ShapeLength& length : shape.lengths) lengths.push_back(length.byDefault);
    const TriangleMesh mesh = shape.solid(lengths).surface;
    const Lattice lattice = around(mesh, manyCells(mesh));
    const auto windings = windingNumbers(mesh, lattice);
    const int sum = std::accumulate(windings.begin(), windings.end(), 0);
    const double volume = sum * lattice.cell * lattice.cell * lattice.cell;
    const double ratio = volume / massPropertiesOf(mesh, 1).volume;
    EXPECT_NEAR(ratio, 1, 0.1) << shape.name;  // measured 0.03 of flat ones, 0.09 of the racket
  }
}

}  // namespace
}  // namespace rotatebook::body
