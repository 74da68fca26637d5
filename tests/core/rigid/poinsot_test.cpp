// Poinsot's construction of the book of scenes/starter.toml, against numbers computed
// independently, in long doubles.
#include "rigid/poinsot.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "rigid/exact_rotation.h"

namespace rotatebook::rigid {
namespace {

using Eigen::Vector3d;
using std::numbers::pi;

const Vector3d kStarterSize(0.1878, 0.29085, 0.05);
const Vector3d kStarterMoments =
    (Vector3d::Constant(kStarterSize.squaredNorm()) - kStarterSize.cwiseAbs2()) / 12;  // [kg m^2]
constexpr double kPeriod = 6.72119059527;                                              // [s]

/// The exact motion, and Poinsot's construction of its moments.
struct Rolling {
  explicit Rolling(const Vector3d& moments, const Vector3d& velocity)
      : axes{moments},
        motion(axes, velocity),
        momentum(moments.cwiseProduct(velocity)),
        energy(velocity.dot(momentum) / 2),
        distance(std::sqrt(2 * energy) / momentum.norm()) {}

  Poinsot inBody(double time) const {
    const auto moment = motion.at(time);
    return poinsotOf(axes.moments, moment.worldFromBody.transpose() * momentum);
  }
  Vector3d contact(double time) const {
    return motion.at(time).worldFromBody * inBody(time).contact;
  }
  /// Returns the contact point's place on the plane, seen from where the plane's normal meets it.
  Vector3d herpolhode(double time) const {
    return contact(time) - distance * momentum.normalized();
  }

  PrincipalAxes axes;
  ExactRotation motion;
  Vector3d momentum;  // in the world
  double energy, distance;
};

Rolling starter() {
  return Rolling(kStarterMoments, {5 * std::cos(pi / 180), 0, 5 * std::sin(pi / 180)});
}

TEST(Poinsot, IsThatOfTheBook) {
  const Rolling book = starter();
  const Vector3d semiAxes = inertiaSemiAxes(kStarterMoments);
  EXPECT_NEAR((semiAxes - Vector3d(11.73808355, 17.82476446, 10.00573149)).norm(), 0, 1e-8);
  EXPECT_NEAR(book.inBody(0).distance, 11.7371581102, 1e-10);
  const HerpolhodeRadii radii = herpolhodeRadii(semiAxes, book.distance);
  EXPECT_NEAR(radii.least, 0.07705069678, 1e-11);
  EXPECT_NEAR(radii.greatest, 7.012733571, 1e-9);
}

TEST(Poinsot, TouchesThePlaneThatRestsWithoutSlipping) {
  const Rolling book = starter();
  double slips = 0, leaves = 0, off = 0;
  for (double time = 0; time < 20; time += 0.01) {
    const auto moment = book.motion.at(time);
    const Poinsot poinsot = book.inBody(time);
    const Vector3d contact = moment.worldFromBody * poinsot.contact;
    slips = std::max(slips, moment.angularVelocity.cross(contact).norm());
    leaves = std::max(leaves, std::abs(contact.dot(book.momentum.normalized()) - book.distance));
    off = std::max(off, std::abs(poinsot.contact.cwiseAbs2().dot(kStarterMoments) - 1));
  }
  EXPECT_LT(slips, 1e-12);   // of 58; measured 3e-14
  EXPECT_LT(leaves, 1e-13);  // of 11.7; measured 5.3e-15
  EXPECT_LT(off, 1e-14);     // measured 4.4e-16
}

struct KnownContact {
  double time;
  Vector3d contact;
  double radius;
};
const KnownContact kContacts[] = {
    {1, {11.77664298, -0.25713591, -1.50270458}, 1.803518603},
    {1.68, {11.56651876, -0.8218555, 7.2442716}, 7.012730797},
    {2.5, {11.74731972, 1.05690832, -0.28204623}, 1.198017258},
    {3.3605952976, {11.73557123, 0.01815842, 0.20701569}, 0.077050697}};

TEST(Poinsot, IsWhereItIsKnownToBe) {
  const Rolling book = starter();
  EXPECT_NEAR((book.contact(0) - Vector3d(11.73562335, 0, 0.20484607)).norm(), 0, 1e-8);
  for (const KnownContact& known : kContacts) {
    EXPECT_NEAR((book.contact(known.time) - known.contact).norm(), 0, 1e-8) << known.time;
    EXPECT_NEAR(book.herpolhode(known.time).norm(), known.radius, 1e-9) << known.time;
  }
}

// Both curves are as long as each other, as nothing slips; the herpolhode goes forward always.
TEST(Poinsot, RollsItsPolhodeOffOnTheHerpolhode) {
  const Rolling book = starter();
  const Vector3d normal = book.momentum.normalized();
  constexpr int kParts = 20000;
  double polhode = 0, herpolhode = 0, turn = 0, leastTurn = 1;
  for (int i = 0; i < kParts; ++i) {
    const double from = kPeriod * i / kParts, to = kPeriod * (i + 1) / kParts;
    polhode += (book.inBody(to).contact - book.inBody(from).contact).norm();
    herpolhode += (book.contact(to) - book.contact(from)).norm();
    const Vector3d a = book.herpolhode(from), b = book.herpolhode(to);
    const double step = std::atan2(a.cross(b).dot(normal), a.dot(b));
    leastTurn = std::min(leastTurn, step);
    turn += step;
  }
  EXPECT_NEAR(herpolhode / polhode, 1, 2e-7);  // measured 1.4e-7: chords are shorter than arcs
  EXPECT_GT(polhode, 50);
  EXPECT_GT(leastTurn, 0);
  EXPECT_NEAR(turn, 38.174924551, 1e-7);
}

/// Returns the least and the greatest radius of the herpolhode in many moments.
HerpolhodeRadii radiiSeen(const Rolling& rolling) {
  HerpolhodeRadii seen{1e9, 0};
  for (double time = 0; time < 30; time += 1e-3) {
    const double radius = rolling.herpolhode(time).norm();
    seen = {std::min(seen.least, radius), std::max(seen.greatest, radius)};
  }
  return seen;
}

TEST(HerpolhodeRadii, AreThoseOfTheMotionInBothRegimes) {
  for (const Vector3d& velocity : {Vector3d(1, 0.2, 3), {1, 3, 0.2}, {0.1, 4, 0.3}}) {
    const Rolling rolling(kStarterMoments, velocity);
    const HerpolhodeRadii radii =
        herpolhodeRadii(inertiaSemiAxes(kStarterMoments), rolling.distance);
    const HerpolhodeRadii seen = radiiSeen(rolling);
    EXPECT_NEAR(radii.least, seen.least, 1e-8);        // measured 3.0e-9
    EXPECT_NEAR(radii.greatest, seen.greatest, 1e-8);  // 1.9e-9
    EXPECT_GT(radii.greatest - radii.least, 0.1);
  }
}

TEST(HerpolhodeRadii, AreZeroOfASteadySpin) {
  const Vector3d semiAxes = inertiaSemiAxes(kStarterMoments);
  EXPECT_EQ(herpolhodeRadii(semiAxes, semiAxes.y()).greatest, 0);
  EXPECT_EQ(herpolhodeRadii(semiAxes, semiAxes.z()).greatest, 0);
  EXPECT_EQ(herpolhodeRadii(semiAxes, semiAxes.x()).least, 0);
  EXPECT_EQ(herpolhodeRadii(semiAxes, 100).greatest, 0);
}

TEST(AxisEnergies, AreThoseOfTheBook) {
  const Rolling book = starter();
  const Vector3d energies = axisEnergies(kStarterMoments, book.momentum.norm());
  EXPECT_NEAR(energies.x(), 0.09074733302, 1e-11);
  EXPECT_NEAR(energies.y(), 0.2092604126, 1e-10);
  EXPECT_NEAR(energies.z(), 0.06593821186, 1e-11);
  EXPECT_NEAR(book.energy, 0.0907330244229, 1e-13);
  EXPECT_NEAR(1 - book.energy / energies.x(), 1.577e-4, 5e-8);
}

TEST(ReachOfMomentum, IsTheGreatestAngleFromTheCircledAxis) {
  for (const Vector3d& velocity : {Vector3d(1, 0.2, 3), {1, 3, 0.2}, {0.1, 4, 0.3}}) {
    const Rolling rolling(kStarterMoments, velocity);
    const int axis = rolling.motion.regime() == Regime::AboutLargest ? 2 : 1;
    double greatest = 0;
    for (double time = 0; time < 30; time += 1e-3) {
      const Vector3d seen =
          rolling.motion.at(time).worldFromBody.transpose() * rolling.momentum.normalized();
      greatest = std::max(greatest, std::acos(std::abs(seen[axis])));
    }
    const Vector3d energies = axisEnergies(kStarterMoments, rolling.momentum.norm());
    EXPECT_NEAR(reachOfMomentum(energies, rolling.energy), greatest, 1e-9);  // measured 2.1e-10
    EXPECT_GT(greatest, 0.1);
  }
}

TEST(ReachOfMomentum, IsZeroAtBothEndsAndARightAngleInTheMiddle) {
  const Vector3d energies(3, 5, 1);
  EXPECT_EQ(reachOfMomentum(energies, 1), 0);
  EXPECT_EQ(reachOfMomentum(energies, 5), 0);
  EXPECT_EQ(reachOfMomentum(energies, 3), pi / 2);
  EXPECT_NEAR(reachOfMomentum(energies, 2), pi / 4, 1e-15);
  EXPECT_EQ(reachOfMomentum(energies, 0.5), 0);
  EXPECT_EQ(reachOfMomentum(energies, 5.5), 0);
  EXPECT_EQ(reachOfMomentum({1, 1, 1}, 1), 0);
}

}  // namespace
}  // namespace rotatebook::rigid
