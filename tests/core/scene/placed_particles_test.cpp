#include "scene/placed_particles.h"

#include <cmath>
#include <iostream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "messages.h"
#include "physics/measure/flip_interval.h"
#include "physics/motion_start.h"
#include "physics/particle_places.h"
#include "physics/simulate.h"
#include "physics/spring_analysis.h"
#include "rigid/exact_rotation.h"
#include "scene/motion_files.h"
#include "scene/parse.h"
#include "scene/solid_particles.h"

namespace rotatebook::scene {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

constexpr const char* kHandle = "[body]\nshape = \"t-handle\"\n";
constexpr double kFlipBound = 0.02;  // of the rigid body's interval

/// An OBJ of a cube with corners at 0 and 2.
constexpr const char* kCube =
    "v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nv 0 0 2\nv 2 0 2\nv 2 2 2\nv 0 2 2\n"
    "f 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";

/// One of 2 x 4 x 6.
constexpr const char* kBrick =
    "v 0 0 0\nv 2 0 0\nv 2 4 0\nv 0 4 0\nv 0 0 6\nv 2 0 6\nv 2 4 6\nv 0 4 6\n"
    "f 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";

/// Returns the lines of a body with particles, in steps that are short enough.
std::string particles(const std::string& arrangement, const std::string& body,
                      const std::string& more = "") {
  return body +
         "\n[simulation]\nmodel = \"particles\"\nintegrator = \"verlet\"\nsubsteps = 4000\n" +
         "particles = \"" + arrangement + "\"\n" + more;
}

physics::MassSpringSystem systemOf(const std::string& arrangement, const std::string& body) {
  return particlesOf(sceneFrom(particles(arrangement, body)).motions[0]);
}

ReadNamedFile reading(const char* obj) {
  return [obj](const std::filesystem::path&, std::size_t) { return obj; };
}

TEST(PlacedParticles, AreTheBooksCornersByDefault) {
  const Scene scene = sceneFrom("[simulation]\nmodel = \"particles\"");
  EXPECT_EQ(scene.motions[0].simulation.particles.arrangement, physics::Arrangement::Corners);
  EXPECT_EQ(scene.motions[0].particles.system, nullptr);
  EXPECT_THAT(sceneText(scene), HasSubstr("particles = \"corners\""));
}

TEST(PlacedParticles, AreTheCornersOfABoxToo) {
  const Scene scene = sceneFrom(particles("corners", "[body]\nshape = \"cards\""));
  EXPECT_LT(
      (particlesOf(scene.motions[0].motion()).places[7] - scene.motions[0].body.size / 2).norm(),
      1e-17);
}

TEST(PlacedParticles, ArePrintedAndReadBack) {
  for (const char* arrangement : {"equimomental", "vertices", "grid:20"}) {
    const Scene scene = sceneFrom(particles(arrangement, kHandle));
    EXPECT_THAT(sceneText(scene), HasSubstr("particles = \"" + std::string(arrangement) + "\""));
    EXPECT_EQ(parseScene(sceneText(scene), "a.toml").motions[0], scene.motions[0]) << arrangement;
  }
}

TEST(PlacedParticles, HaveTheRigidBodysMomentsIfEquimomental) {
  const Scene rigid = sceneFrom(kHandle);
  const Scene scene = sceneFrom(particles("equimomental", kHandle));
  const Eigen::Vector3d expected = modelInertia(rigid.motions[0]).moments;
  const Eigen::Vector3d moments = modelInertia(scene.motions[0].motion()).moments;
  EXPECT_LT((moments - expected).norm() / expected.norm(), 1e-15);  // measured 2e-16
}

TEST(PlacedParticles, AreAtTheVerticesOfAMesh) {
  const Scene scene = parseScene(particles("vertices",
                                           "[body]\nmesh = \"a.obj\"\nunit = \"cm\"\n"
                                           "density = 1000") +
                                     "\n" + kSpin,
                                 "a.toml", {}, reading(kCube));
  const auto system = particlesOf(scene.motions[0].motion());
  ASSERT_EQ(system.places.size(), 8U);
  for (const Eigen::Vector3d& place : system.places)
    EXPECT_LT((place.cwiseAbs() - Eigen::Vector3d::Constant(0.01)).norm(), 1e-17);
  // Twelve edges, six diagonals, and some of the springs across.
  EXPECT_GT(system.springs.size(), 18U);
}

// A clip's record has the numbers of its mesh alone.
TEST(PlacedParticles, OfARecordWaitForTheFileOfTheirMesh) {
  for (const char* arrangement : {"vertices", "grid:5"}) {
    const std::string text =
        particles(arrangement, "[body]\nmesh = \"a.obj\"\nunit = \"cm\"\ndensity = 1000") +
        "\n[initial]\nangular_velocity = { about = \"middle\", value = 4 }\n"
        "[overlay]\nshow = [\"polhode\", \"omega\", \"error\", \"energy\", \"ghost\"]\n";
    const Scene scene = parseScene(text, "a.toml", {}, reading(kBrick));
    Scene recorded = parseScene(sceneText(scene), "a.toml");
    EXPECT_EQ(recorded.motions[0].particles.system, nullptr);
    EXPECT_EQ(sceneText(recorded), sceneText(scene));
    Scene other = recorded;
    readMotionFiles(recorded, reading(kBrick));
    EXPECT_EQ(recorded.motions[0], scene.motions[0]);
    EXPECT_THAT([&] { readMotionFiles(other, reading(kCube)); },
                ThrowsMessage<InputError>(HasSubstr("\"a.obj\" has changed")));
  }
}

TEST(PlacedParticles, FillABoxWithAGrid) {
  const auto system = systemOf("grid:4", "[body]\nsize = [0.4, 0.2, 0.2]");
  ASSERT_EQ(system.places.size(), 16U);
  EXPECT_LT((system.places[0] - Eigen::Vector3d(-0.15, -0.05, -0.05)).norm(), 1e-16);
  // Of the 4 x 2 x 2: 12 + 8 + 8 to neighbours, 8 along x to the next but one, 12 + 12 + 8 and
  // 12 diagonals of one, two and three axes.
  std::size_t near = 0;
  for (const physics::Spring& pair : physics::allPairs(16)) {
    const double length = (system.places[pair.a] - system.places[pair.b]).norm();
    if (length < 0.2001) ++near;
  }
  EXPECT_EQ(system.springs.size(), near);
}

TEST(PlacedParticles, LeaveOutWhatIsTakenAway) {
  const std::string whole =
      "[[body.part]]\nshape = \"box\"\ndensity = 700\n"
      "dimensions = { x = 0.5, y = 0.5, z = 0.5 }\n";
  const std::string hollow = whole +
                             "[[body.part]]\nshape = \"box\"\ndensity = -700\n"
                             "dimensions = { x = 0.1, y = 0.1, z = 0.1 }\n";
  EXPECT_EQ(systemOf("grid:5", whole).places.size(), 125U);
  EXPECT_EQ(systemOf("grid:5", hollow).places.size(), 124U);
}

std::string refusal(const std::string& arrangement, const std::string& body) {
  return errorOf(particles(arrangement, body));
}

TEST(PlacedParticles, RefuseNames) {
  EXPECT_MESSAGE(refusal("equimomentel", ""));
  for (const char* name : {"grid:1", "grid:201", "grid:x", "grid:", "grid:3.5", "grid:-3"})
    EXPECT_MESSAGE(refusal(name, "")) << name;
}

TEST(PlacedParticles, RefuseBodiesWithPlaces) {
  // The lines are the body's, then those of particles().
  EXPECT_MESSAGE(refusal("corners", kHandle));
  EXPECT_MESSAGE(refusal("grid:90", kHandle));
  EXPECT_MESSAGE(refusal("grid:90", kHandle));
  EXPECT_MESSAGE(refusal("vertices", "[body]\nshape = \"ellipsoid\""));
  EXPECT_MESSAGE(refusal("vertices", "[body]\ninertia = [1, 1, 1]"));
  EXPECT_EQ(refusal("equimomental", "[body]\ninertia = [1, 1, 1]"), "no error");
  const std::string parts =
      "[[body.part]]\nshape = \"box\"\n[[body.part]]\nshape = \"box\"\n"
      "density = 900\nplace = [0.3, 0, 0]";
  EXPECT_MESSAGE(refusal("grid:6", parts));
  EXPECT_EQ(refusal("equimomental", parts), "no error");
}

TEST(PlacedParticles, RefuseSpringsThatDoNotHoldTheShape) {
  // One layer of particles
  EXPECT_MESSAGE(refusal("grid:3", "[body]\nsize = [0.3, 0.2, 0.05]"));
  // A plane body
  EXPECT_MESSAGE(refusal("equimomental", "[body]\ninertia = [1, 2, 3]"));
  // Two boxes apart
  const std::string two =
      "[[body.part]]\nshape = \"box\"\n[[body.part]]\nshape = \"box\"\n"
      "place = [2, 0, 0]";
  EXPECT_MESSAGE(refusal("grid:60", two));
  EXPECT_MESSAGE(refusal("grid:6", "[body]\nshape = \"racket\""));
  EXPECT_MESSAGE(refusal("grid:25", "[body]\nshape = \"racket\""));
}

TEST(PlacedParticles, RefuseStepsThatAreNotStable) {
  const std::string lines = particles("grid:20", kHandle, "damping = 0\n");
  EXPECT_EQ(errorOf(lines), "no error");
  const std::string message = errorOf(lines, {"simulation.substeps=4"});
  EXPECT_MESSAGE(message);
  // The number that it names is enough, and one less isn't
  const auto at = message.find("take simulation.substeps = ") + 27;
  const int enough = std::stoi(message.substr(at));
  EXPECT_EQ(errorOf(lines, {"simulation.substeps=" + std::to_string(enough)}), "no error");
  EXPECT_NE(errorOf(lines, {"simulation.substeps=" + std::to_string(enough - 1)}), "no error");
  EXPECT_MESSAGE(errorOf(lines, {"simulation.integrator=euler"}));
  // The paper's particles may blow up
  EXPECT_EQ(errorOf("[simulation]\nmodel = \"particles\"\nsubsteps = 1\ndamping = 0"), "no error");
}

TEST(PlacedParticles, TheirSpringsAreDrawnBetweenEight) {
  const std::string overlay = "[overlay]\nshow = [\"springs\"]\n";
  EXPECT_MESSAGE(errorOf(particles("grid:20", kHandle) + overlay));
  EXPECT_EQ(errorOf(particles("equimomental", kHandle) + overlay), "no error");
}

/// Returns a motion of the T-handle about its middle axis, with stiff springs.
Scene handle(const std::string& simulation) {
  return parseScene(std::string(kHandle) + "[simulation]\n" + simulation +
                        "[initial]\nangular_velocity = { about = \"middle\", value = 12 }\n"
                        "tilt = [0.05, \"x\"]\n",
                    "a.toml");
}

double exactInterval(const physics::MotionSettings& motion) {
  const rigid::PrincipalAxes inertia = modelInertia(motion);
  return rigid::ExactRotation(inertia, motion.initial.alongPrincipal(inertia)).flipInterval();
}

/// Returns the mean interval of flips of a motion, of so many samples.
double simulatedInterval(const physics::MotionSettings& motion, int samples) {
  return physics::meanInterval(
      physics::flipTimes(physics::simulate(motion, samples), modelInertia(motion)));
}

// The paper's claim, tried: particles on stiff springs flip as the rigid body does. Those at
// vertices are a shell, whose moments are others.
TEST(PlacedParticles, FlipAsTheRigidBody) {
  const double rigid = exactInterval(handle("model = \"exact\"\n").motions[0]);
  const std::string common =
      "model = \"particles\"\nintegrator = \"verlet\"\ndamping = 0\nnormalize = false\n"
      "stiffness = 1e4\n";
  for (const auto& [arrangement, substeps] :
       {std::pair("equimomental", 100), {"grid:30", 250}, {"vertices", 500}}) {
    const auto motion = handle(common + "particles = \"" + arrangement +
                               "\"\nsubsteps = " + std::to_string(substeps) + "\n")
                            .motions[0];
    const double interval = simulatedInterval(motion, 180);
    if (arrangement != std::string("vertices")) {
      EXPECT_NEAR(interval / rigid, 1, kFlipBound) << arrangement;  // measured 0.017, grid
    }
    EXPECT_NEAR(interval / exactInterval(motion), 1, 0.01) << arrangement;  // measured 4.4e-3
  }
}

TEST(PlacedParticles, AreUpToTwoThousand) {
  const auto motion = sceneFrom(particles("grid:12", "[body]\nsize = [0.3, 0.3, 0.3]")).motions[0];
  EXPECT_EQ(particlesOf(motion).places.size(), 1728U);
  EXPECT_EQ(physics::simulate(motion, 2).samples.size(), 2U);
}

}  // namespace
}  // namespace rotatebook::scene
