// (4179) Toutatis, 4.6 km long, as the ellipsoid with its moments, 1 : 3.09 : 3.22 (Hudson and
// Ostro 1995): a^2 : b^2 : c^2 = 2.655 : 0.565 : 0.435.
#include <cstdint>
#include <utility>

#include "body/look_pieces.h"
#include "body/shapes/shapes.h"
#include "body/solid_pieces.h"

namespace rotatebook::body::shapes {
namespace {

Eigen::Vector3d diametersOf(double length) {
  const Eigen::Vector3d squares(2.655, 0.565, 0.435);
  return (squares / squares.x()).cwiseSqrt() * length;
}

SolidPiece toutatisSolid(std::span<const double> lengths) {
  return ellipsoidOf(diametersOf(lengths[0]));
}

/// Returns a number from 0 to 1 that follows from three whole ones.
double randomOf(int x, int y, int z) {
  auto hash = static_cast<std::uint32_t>(x) * 0x8da6b343U ^
              static_cast<std::uint32_t>(y) * 0xd8163841U ^
              static_cast<std::uint32_t>(z) * 0xcb1ab31fU;
  hash = (hash ^ hash >> 15) * 0x2c1b3c6dU;
  hash = (hash ^ hash >> 12) * 0x297a2d39U;
  return (hash >> 8) / 16777216.0;
}

/// Returns a smooth function of the position, from 0 to 1, that varies within a length of 1.
double noiseAt(const Eigen::Vector3d& position) {
  const Eigen::Vector3d low = position.array().floor();
  const Eigen::Vector3d in = position - low;
  const Eigen::Array3d t = in.array() * in.array() * (3 - 2 * in.array());
  double sum = 0;
  for (int i = 0; i < 8; ++i) {
    double weight = 1;
    int cell[3];
    for (int axis = 0; axis < 3; ++axis) {
      const int up = i >> axis & 1;
      weight *= up != 0 ? t[axis] : 1 - t[axis];
      cell[axis] = static_cast<int>(low[axis]) + up;
    }
    sum += weight * randomOf(cell[0], cell[1], cell[2]);
  }
  return sum;
}

/// Returns how far, as a share, the surface lies within the ellipsoid: two lobes, hills and pits.
double depthAt(const Eigen::Vector3d& unit) {
  const double neck = unit.x() - 0.42;
  double depth = 0.16 / (1 + 28 * neck * neck);
  for (const auto& [frequency, height] :
       {std::pair(2.3, 0.16), {5.1, 0.09}, {11.3, 0.035}, {25.0, 0.012}})
    depth += height * noiseAt(unit * frequency + Eigen::Vector3d(9, 5, 7));
  return depth;
}

Surface toutatisLook(std::span<const double> lengths) {
  TriangleMesh mesh = toutatisSolid(lengths).surface;
  const Eigen::Vector3d half = diametersOf(lengths[0]) / 2;
  for (Eigen::Vector3d& point : mesh.points) point *= 1 - depthAt(point.cwiseQuotient(half));
  return surfaceOf(std::move(mesh),
                   materialOfColour(0x8d8378, 0, 0.95F,
                                    {Eigen::Vector3d::Constant(0.02 * lengths[0]), 0.35F,
                                     static_cast<float>(0.002 * lengths[0])}));
}

}  // namespace

Shape toutatis() {
  return {"toutatis", 2100, {{"length", 4600}}, toutatisSolid, toutatisLook};
}

}  // namespace rotatebook::body::shapes
