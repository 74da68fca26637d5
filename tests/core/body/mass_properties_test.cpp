#include "body/mass_properties.h"

#include <chrono>
#include <cmath>
#include <iostream>
#include <numbers>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "base/error.h"
#include "body/closed_surface.h"
#include "body/solids.h"
#include "messages.h"

namespace rotatebook::body {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

struct Solid {
  const char* name;
  TriangleMesh mesh;
  double volume;
  Vector3d centre;
  Matrix3d inertia;  ///< of a density of 1
};

Matrix3d diagonal(double x, double y, double z) {
  return Vector3d(x, y, z).asDiagonal();
}

/// A prism over a regular polygon of circumradius r: V = N/2 r^2 sin(2 pi/N) h,
/// I_axis = m r^2 (2 + cos(2 pi/N))/6, I_across = m (r^2 (2 + cos(2 pi/N))/12 + h^2/12).
Solid prism(const char* name, std::uint32_t sides, double r, double h) {
  const double angle = 2 * std::numbers::pi / sides;
  const double volume = sides / 2.0 * r * r * std::sin(angle) * h;
  const double share = r * r * (2 + std::cos(angle)) / 12;
  const double across = volume * (share + h * h / 12);
  return {name,
          testing::prismMesh(sides, r, h),
          volume,
          {0, 0, 0},
          diagonal(across, across, 2 * volume * share)};
}

std::vector<Solid> solids() {
  const double off = 1.0 / 480;
  Matrix3d tetrahedron = Matrix3d::Constant(off);
  tetrahedron.diagonal().setConstant(0.0125);
  return {
      {"book",
       testing::boxMesh(0.15, 0.22, 0.04),
       0.00132,
       {0, 0, 0},
       diagonal(5.5e-06, 2.651e-06, 7.799e-06)},
      {"tetrahedron", testing::tetrahedronMesh(), 1.0 / 6, Vector3d::Constant(0.25), tetrahedron},
      prism("octagon", 8, 0.5, 2),
      prism("128-gon", 128, 0.5, 2),
      prism("thin disc", 1000, 1, 1e-3),
      prism("needle", 32, 1e-3, 1)};
}

void expectClose(const MassProperties& found, const Solid& solid, double size, double bound,
                 const Vector3d& shift = {0, 0, 0}) {
  const double cubed = size * size * size;
  const auto check = [&](double error, const char* what) {
    EXPECT_LE(error, bound) << solid.name << ": " << what;
  };
  check(std::fabs(found.volume / (solid.volume * cubed) - 1), "volume");
  check((found.centre - shift - solid.centre * size).norm() /
            (solid.mesh.points[0] * size - solid.centre * size).norm(),
        "centre");
  const Matrix3d inertia = solid.inertia * cubed * size * size;
  check((found.inertia - inertia).cwiseAbs().maxCoeff() / inertia.diagonal().maxCoeff(), "inertia");
}

TEST(MassProperties, AreThoseOfKnownSolids) {
  for (const Solid& solid : solids())
    expectClose(massPropertiesOf(solid.mesh, 1), solid, 1, 1e-14);  // measured 4.1e-16
}

TEST(MassProperties, AreAsPreciseInAnySize) {
  for (const double size : {0x1p-20, 0x1p20}) {  // about 10^-6 and 10^6
    for (Solid solid : solids()) {
      TriangleMesh scaledMesh = solid.mesh;
      for (Vector3d& point : scaledMesh.points) point *= size;
      expectClose(massPropertiesOf(scaledMesh, 1), solid, size, 1e-14);  // measured 4.1e-16
    }
  }
}

/// Rounds coordinates to 2^-30, so that a shift by 2^20 changes nothing but the place.
TriangleMesh onGrid(TriangleMesh mesh) {
  for (Vector3d& point : mesh.points) point = (point * 0x1p30).array().round() * 0x1p-30;
  return mesh;
}

TEST(MassProperties, AreThoseOfTheSameBodyFarAway) {
  const Vector3d shift(0x1p20, -0x1p20, 0x1p20);  // more than 10^6 sizes
  for (const Solid& solid : solids()) {
    const TriangleMesh near = onGrid(solid.mesh);
    TriangleMesh far = near;
    for (Vector3d& point : far.points) point += shift;
    const MassProperties a = massPropertiesOf(near, 1), b = massPropertiesOf(far, 1);
    EXPECT_NEAR(b.volume / a.volume, 1, 1e-14) << solid.name;  // measured 0
    const double error =
        (a.inertia - b.inertia).cwiseAbs().maxCoeff() / a.inertia.diagonal().maxCoeff();
    EXPECT_LE(error, 1e-14) << solid.name;                                 // measured 0
    EXPECT_LE((b.centre - shift - a.centre).norm(), 2e-10) << solid.name;  // the place's own ulp
  }
}

TEST(MassProperties, TurnWithTheBody) {
  const Matrix3d turn = Eigen::Quaterniond(0.3, -0.4, 0.5, 0.7).normalized().toRotationMatrix();
  for (const Solid& solid : solids()) {
    TriangleMesh turned = solid.mesh;
    for (Vector3d& point : turned.points) point = turn * point;
    const MassProperties found = massPropertiesOf(turned, 1);
    const Matrix3d wanted = turn * solid.inertia * turn.transpose();
    // Turned points are rounded, which is most of it: measured 5.3e-13, of the needle
    EXPECT_LE((found.inertia - wanted).cwiseAbs().maxCoeff() / wanted.diagonal().maxCoeff(), 1e-12)
        << solid.name;
  }
}

TEST(MassProperties, AreInProportionToTheDensity) {
  const TriangleMesh box = testing::boxMesh(1, 2, 3);
  const MassProperties light = massPropertiesOf(box, 1), heavy = massPropertiesOf(box, 8);
  EXPECT_EQ(heavy.mass, 8 * light.mass);
  EXPECT_EQ(heavy.volume, light.volume);
  EXPECT_EQ(heavy.inertia, 8 * light.inertia);
}

TEST(MassProperties, OfTwoBodiesAddUp) {
  TriangleMesh left = testing::boxMesh(1, 2, 4), right = left;
  for (Vector3d& point : left.points) point.x() -= 0.5;
  for (Vector3d& point : right.points) point.x() += 0.5;
  const MassProperties sum = sumOf(massPropertiesOf(left, 3), massPropertiesOf(right, 3));
  const MassProperties whole = massPropertiesOf(testing::boxMesh(2, 2, 4), 3);
  EXPECT_DOUBLE_EQ(sum.mass, whole.mass);
  EXPECT_LE(sum.centre.norm(), 1e-15);                                            // measured 0
  EXPECT_LE((sum.inertia - whole.inertia).norm() / whole.inertia.norm(), 1e-15);  // measured 2e-16
}

TEST(MassProperties, OfABodyWithAHoleAreTheDifference) {
  const MassProperties outer = massPropertiesOf(testing::boxMesh(2, 2, 2), 5);
  const MassProperties hole = massPropertiesOf(testing::boxMesh(1, 1, 1), -5);
  const MassProperties hollow = sumOf(outer, hole);
  EXPECT_DOUBLE_EQ(hollow.mass, 35);
  EXPECT_NEAR(hollow.inertia(0, 0), 40 * 8.0 / 12 - 5 * 2.0 / 12, 1e-14);  // measured 0
  EXPECT_THROW(sumOf(hole, hole), InputError);
}

TEST(MassProperties, NeedAVolume) {
  const auto messageOf = [](const TriangleMesh& mesh) -> std::string {
    try {
      massPropertiesOf(mesh, 1);
    } catch (const InputError& error) {
      return error.what();
    }
    return "accepted";
  };
  TriangleMesh inside = testing::boxMesh(1, 1, 1);
  for (auto& triangle : inside.triangles) std::swap(triangle[0], triangle[1]);
  EXPECT_MESSAGE(messageOf(inside));
  EXPECT_MESSAGE(messageOf(testing::boxMesh(1, 1, 0)));
  EXPECT_MESSAGE(messageOf(testing::boxMesh(1e70, 1, 1)));
  EXPECT_MESSAGE(messageOf(testing::boxMesh(0, 0, 0)));
}

// Its times, which nothing asserts, are in the report that --gtest_output makes.
TEST(MassProperties, OfAMillionTriangles) {
  const TriangleMesh ball = testing::ballMesh(500, 1000);
  ASSERT_EQ(ball.triangles.size(), 998'000U);
  const auto begin = std::chrono::steady_clock::now();
  requireClosed(ball);
  const auto middle = std::chrono::steady_clock::now();
  const MassProperties found = massPropertiesOf(ball, 1);
  const auto end = std::chrono::steady_clock::now();
  EXPECT_NEAR(found.volume, 4 * std::numbers::pi / 3, 1e-4);  // measured 4.1e-5, a polyhedron's
  RecordProperty("check_ms", static_cast<int>((middle - begin) / std::chrono::milliseconds(1)));
  RecordProperty("sums_ms", static_cast<int>((end - middle) / std::chrono::milliseconds(1)));
}

}  // namespace
}  // namespace rotatebook::body
