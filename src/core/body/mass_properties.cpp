#include "body/mass_properties.h"

#include <cmath>

#include <Eigen/Geometry>

#include "base/double_double.h"
#include "base/error.h"
#include "base/number_text.h"

namespace rotatebook::body {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// A sum that keeps what rounding would lose.
class Sum {
 public:
  void add(double number) {
    const DoubleDouble sum = exactSum(high_, number);
    high_ = sum.high;
    low_ += sum.low;
  }
  double value() const { return high_ + low_; }

 private:
  double high_ = 0, low_ = 0;
};

/// The place and the size of a mesh.
struct Extent {
  Vector3d middle{0, 0, 0};
  double scale = 1;  ///< A power of two, so that scaling is exact.
};

Extent extentOf(const TriangleMesh& mesh) {
  const auto [low, high] = boxAround(mesh.points);
  // Half of each first: the sum of two large numbers may be none.
  const Vector3d middle = low / 2 + high / 2;
  const double size = (high - low).maxCoeff();
  if (!(size > 1e-60 && size < 1e60)) {
    throw InputError("the mesh is " + shortestText(size) +
                     " m large; a body is between 1e-60 and 1e60 m: is its unit right?");
  }
  return {middle, powerOfTwoBelow(size)};
}

/// The integrals of 1, x and x x^T over tetrahedra, times 6, 24 and 120.
struct Integrals {
  Sum volume;
  Sum first[3];
  Sum second[6];  ///< xx, yy, zz, xy, yz, zx

  void add(const Vector3d& a, const Vector3d& b, const Vector3d& c) {
    const double six = a.dot(b.cross(c));
    const Vector3d s = a + b + c;
    volume.add(six);
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3;
      first[i].add(six * s[i]);
      second[i].add(six * (s[i] * s[i] + (a[i] * a[i] + b[i] * b[i] + c[i] * c[i])));
      second[3 + i].add(six * (s[i] * s[j] + (a[i] * a[j] + b[i] * b[j] + c[i] * c[j])));
    }
  }
};

/// Returns tr(C) 1 - C for the covariance of a unit of density.
Matrix3d inertiaOf(const Matrix3d& covariance) {
  return covariance.trace() * Matrix3d::Identity() - covariance;
}

}  // namespace

MassProperties massPropertiesOf(const TriangleMesh& mesh, double density) {
  const auto [middle, scale] = extentOf(mesh);
  Integrals integrals;
  const auto scaledPoint = [&, middle = middle, scale = scale](std::uint32_t index) -> Vector3d {
    return (mesh.points[index] - middle) / scale;
  };
  for (const auto& [a, b, c] : mesh.triangles)
    integrals.add(scaledPoint(a), scaledPoint(b), scaledPoint(c));

  const double volume = integrals.volume.value() / 6;
  if (!(volume > 1e-15)) {
    throw InputError("the surface encloses " + shortestText(volume * scale * scale * scale) +
                     " m^3" +
                     (volume < -1e-15 ? ": it is inside out; turn all triangles' corners round"
                                      : ": a body must have a volume"));
  }
  Vector3d centre;
  Matrix3d covariance;
  for (int i = 0; i < 3; ++i) centre[i] = integrals.first[i].value() / 24 / volume;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    covariance(i, i) = integrals.second[i].value() / 120 - volume * centre[i] * centre[i];
    covariance(i, j) = covariance(j, i) =
        integrals.second[3 + i].value() / 120 - volume * centre[i] * centre[j];
  }
  const double cubed = scale * scale * scale;
  return {volume * cubed, volume * cubed * density, middle + centre * scale,
          inertiaOf(covariance) * (density * cubed) * (scale * scale)};
}

MassProperties moved(const MassProperties& body, const Matrix3d& turn, const Vector3d& place) {
  MassProperties result = body;
  result.centre = turn * body.centre + place;
  if (turn.isIdentity(0)) return result;
  const Matrix3d inertia = turn * body.inertia * turn.transpose();
  result.inertia = (inertia + inertia.transpose()) / 2;
  return result;
}

MassProperties sumOf(const MassProperties& a, const MassProperties& b) {
  MassProperties sum{a.volume + b.volume, a.mass + b.mass};
  if (!(sum.mass > 0)) {
    throw InputError("the parts' masses add up to " + shortestText(sum.mass) +
                     " kg; take less away");
  }
  sum.centre = (a.mass * a.centre + b.mass * b.centre) / sum.mass;
  const Vector3d apart = a.centre - b.centre;
  // The parallel axis theorem, for both at once.
  sum.inertia =
      a.inertia + b.inertia + inertiaOf(apart * apart.transpose()) * (a.mass * b.mass / sum.mass);
  return sum;
}

}  // namespace rotatebook::body
