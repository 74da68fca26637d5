#include <numbers>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scene/names.h"
#include "scene/parse.h"
#include "scene/scene_text.h"

namespace rotatebook::scene {
namespace {

using physics::InitialSpin;
using physics::Model;

TEST(BodySection, ReadsSizeAndMass) {
  const Scene scene = sceneFrom("[body]\nsize = [1, 2.5, 3]\nmass = 7");
  EXPECT_EQ(scene.motions[0].body.size, Eigen::Vector3d(1, 2.5, 3));
  EXPECT_EQ(scene.motions[0].body.mass, 7);
}

TEST(BodySection, RefusesImpossibleSizes) {
  const std::string must = "body.size must be three lengths from 1e-6 to 1e6 m, not ";
  EXPECT_EQ(errorOf("[body]\nsize = [1, 0, 3]"), "a.toml:2:12: " + must + "0");
  EXPECT_EQ(errorOf("[body]\nsize = [1, 2, -3.0]"), "a.toml:2:15: " + must + "-3.0");
  EXPECT_EQ(errorOf("[body]\nsize = [nan, 2, 3]"), "a.toml:2:9: " + must + "nan");
  EXPECT_EQ(errorOf("[body]\nsize = [1, +inf, 3]"), "a.toml:2:12: " + must + "inf");
  EXPECT_EQ(errorOf("[body]\nsize = [1, 2, 1e7]"), "a.toml:2:15: " + must + "1e+07");
  EXPECT_EQ(errorOf("[body]\nsize = [1, 2]"), "a.toml:2:8: " + must + "[1, 2]");
  EXPECT_EQ(errorOf("[body]\nsize = 0.2"), "a.toml:2:8: " + must + "0.2");
}

TEST(BodySection, RefusesImpossibleMasses) {
  const std::string must = "a.toml:2:8: body.mass must be a mass from 1e-9 to 1e9 kg, not ";
  EXPECT_EQ(errorOf("[body]\nmass = 0"), must + "0");
  EXPECT_EQ(errorOf("[body]\nmass = -1"), must + "-1");
  EXPECT_EQ(errorOf("[body]\nmass = nan"), must + "nan");
  EXPECT_EQ(errorOf("[body]\nmass = inf"), must + "inf");
  EXPECT_EQ(errorOf("[body]\nmass = true"), must + "true");
}

TEST(SimulationSection, ReadsEveryKey) {
  const Scene scene = sceneFrom(
      "[simulation]\nmodel = 'particles'\nintegrator = 'euler'\nnormalize = false\n"
      "damping = 0\nstiffness = 31.5\ntime_per_frame = 0.001\nsubsteps = 1000000");
  EXPECT_EQ(scene.motions[0].simulation.model, Model::Particles);
  EXPECT_EQ(scene.motions[0].simulation.integrator, physics::Integrator::Euler);
  EXPECT_EQ(scene.motions[0].simulation.normalizeEvery, 0);
  EXPECT_EQ(scene.motions[0].simulation.damping, 0);
  EXPECT_EQ(scene.motions[0].simulation.stiffness, 31.5);
  EXPECT_EQ(scene.timePerFrame(), 0.001);
  EXPECT_EQ(scene.motions[0].simulation.substeps, 1'000'000);
}

TEST(SimulationSection, ReadsHowOftenAMotionIsNormalised) {
  const auto simulationFrom = [](const std::string& keys) {
    return sceneFrom("[simulation]\nmodel = 'particles'\n" + keys).motions[0].simulation;
  };
  EXPECT_EQ(simulationFrom("normalize = true").normalizeEvery, 1);
  EXPECT_EQ(simulationFrom("normalize = { every = 100 }").normalizeEvery, 100);
  const auto both = simulationFrom("normalize = { every = 7 }");
  EXPECT_EQ(both.energyEvery(), 7);
  EXPECT_EQ(both.driftEvery(), 7);
  const auto apart = simulationFrom("normalize_energy = false\nremove_drift = { every = 3 }");
  EXPECT_EQ(apart.energyEvery(), 0);
  EXPECT_EQ(apart.driftEvery(), 3);
}

TEST(SimulationSection, RefusesOtherIntervals) {
  EXPECT_EQ(
      errorOf("[simulation]\nnormalize = { every = 0 }"),
      "a.toml:2:23: simulation.normalize.every must be an integer from 1 to 1000000000, not 0");
  EXPECT_EQ(errorOf("[simulation]\nnormalize = { each = 3 }"),
            "a.toml:2:15: unknown key \"each\" in [simulation.normalize]; valid is \"every\"");
  EXPECT_EQ(errorOf("[simulation]\nnormalize = {}"),
            "a.toml:2:13: simulation.normalize must be true, false or a table such as "
            "{ every = 100 }, not a table");
  EXPECT_EQ(errorOf("[simulation]\nnormalize = { evry = 5 }"),
            "a.toml:2:15: unknown key \"evry\" in [simulation.normalize]; did you mean \"every\"?");
}

TEST(BodySection, ReadsMomentsOfInertia) {
  const Scene scene = sceneFrom("[body]\ninertia = [3, 4, 5.5]");
  ASSERT_TRUE(scene.motions[0].inertia);
  EXPECT_EQ(*scene.motions[0].inertia, Eigen::Matrix3d(Eigen::Vector3d(3, 4, 5.5).asDiagonal()));
  EXPECT_EQ(scene.motions[0].motion().inertia, scene.motions[0].inertia);
  EXPECT_FALSE(sceneFrom("").motions[0].inertia);
}

TEST(BodySection, ReadsATensorOfInertia) {
  const Scene scene =
      sceneFrom("[body]\ninertia = [[3, 0.1, 0.2],\n  [0.1, 4, 0.3],\n  [0.2, 0.3, 5]]");
  Eigen::Matrix3d expected;
  expected << 3, 0.1, 0.2, 0.1, 4, 0.3, 0.2, 0.3, 5;
  EXPECT_EQ(*scene.motions[0].inertia, expected);
}

TEST(BodySection, RefusesImpossibleInertia) {
  EXPECT_EQ(errorOf("[body]\ninertia = [1, 1, 3]"),
            "a.toml:2:11: no body has this inertia: a principal moment can't exceed the sum of the "
            "other two, but its principal moments are 1, 1 and 3 kg m^2");
  EXPECT_EQ(errorOf("[body]\ninertia = [[3, 1, 0], [0, 4, 0], [0, 0, 5]]"),
            "a.toml:2:11: an inertia tensor must be symmetric, but its xy entries are 1 and 0");
  EXPECT_EQ(errorOf("[body]\ninertia = [1, 0, 1]"),
            "a.toml:2:11: an inertia tensor must be positive definite, but its principal moments "
            "are 1, 0 and 1 kg m^2");
  EXPECT_EQ(errorOf("[body]\ninertia = [1, 2]"),
            "a.toml:2:11: body.inertia must be three moments, [Ix, Iy, Iz], or a tensor of three "
            "rows, [[Ixx, Ixy, Ixz], ...], not [1, 2]");
  EXPECT_EQ(errorOf("[body]\ninertia = [[1, 2], [3, 4], [5, 6]]"),
            "a.toml:2:12: body.inertia must be rows of three numbers up to 1e21 kg m^2, not "
            "[1, 2]");
  EXPECT_EQ(errorOf("[body]\ninertia = [1, nan, 1]"),
            "a.toml:2:15: body.inertia must be three moments of inertia up to 1e21 kg m^2, not "
            "nan");
}

TEST(BodySection, RefusesInertiaOfParticles) {
  EXPECT_EQ(errorOf("body.inertia = [3, 4, 5]\nsimulation.model = 'particles'"),
            "a.toml:1:16: body.inertia is for rigid models, but the model is \"particles\", whose "
            "inertia follows from their positions; leave it out, or set simulation.particles = "
            "\"equimomental\"");
}

TEST(SimulationSection, ReadsEveryIntegrator) {
  for (const auto& model : kModels) {
    for (const std::string_view name : integratorNames(model.value)) {
      const Scene scene = sceneFrom("simulation = { model = '" + std::string(model.name) +
                                    "', integrator = '" + std::string(name) + "' }");
      EXPECT_EQ(nameOf(kIntegrators, scene.motions[0].simulation.integrator), name);
    }
  }
  EXPECT_TRUE(integratorNames(Model::Exact).empty());
}

TEST(SimulationSection, KeepsTheWordsOfTheIntegrators) {
  // Written out, as scenes have them: renamed, they would no longer be read.
  for (const std::string word :
       {"euler", "rk4", "lie-euler", "cf4", "splitting", "suzuki4", "midpoint", "dmv2", "dmv4",
        "dmv6", "no-gyroscopic", "explicit-gyroscopic", "implicit-gyroscopic", "renormalised"}) {
    EXPECT_EQ(errorOf("simulation.integrator = '" + word + "'"), "no error");
  }
  for (const std::string word : {"euler", "rk4", "symplectic-euler", "verlet"}) {
    EXPECT_EQ(errorOf("simulation = { model = 'particles', integrator = '" + word + "' }"),
              "no error");
  }
}

TEST(SimulationSection, StepsRigidModelsByRk4AndParticlesByEulerUnlessItSaysOtherwise) {
  const auto integratorWith = [](const std::string& lines) {
    return sceneFrom(lines).motions[0].simulation.integrator;
  };
  using physics::Integrator;
  EXPECT_EQ(integratorWith(""), Integrator::Rk4);
  EXPECT_EQ(integratorWith("simulation.substeps = 2"), Integrator::Rk4);
  EXPECT_EQ(integratorWith("simulation.model = 'matrix'"), Integrator::Rk4);
  EXPECT_EQ(integratorWith("simulation.model = 'particles'"), Integrator::Euler);
  EXPECT_EQ(integratorWith("simulation.integrator = 'euler'"), Integrator::Euler);
  EXPECT_EQ(integratorWith("[simulation]\nmodel = 'particles'\nintegrator = 'rk4'"),
            Integrator::Rk4);
}

TEST(SimulationSection, RefusesAnIntegratorOfAnotherModel) {
  EXPECT_EQ(errorOf("[simulation]\nmodel = 'particles'\nintegrator = 'dmv4'"),
            "a.toml:3:14: simulation.integrator = \"dmv4\", but the model \"particles\" has " +
                listOfIntegrators("and", Model::Particles));
  EXPECT_EQ(errorOf("[simulation]\nintegrator = 'verlet'"),
            "a.toml:2:14: simulation.integrator = \"verlet\", but the model \"quaternion\" has " +
                listOfIntegrators("and", Model::Quaternion));
  EXPECT_EQ(errorOf("[simulation]\nmodel = 'exact'\nintegrator = 'rk4'"),
            "a.toml:3:14: simulation.integrator = \"rk4\", but the model \"exact\" takes no steps; "
            "leave it out");
  EXPECT_EQ(errorOf("[simulation]\nmodel = 'particles'\nintegrator = 'exact'"),
            "a.toml:3:14: simulation.integrator can't be \"exact\": the closed form is a model of "
            "its own, simulation.model = \"exact\", for rigid bodies; particles have none");
}

TEST(SimulationSection, RefusesDissipationWhereNothingTakesIt) {
  EXPECT_EQ(sceneFrom("simulation.dissipation = 2e-6").motions[0].simulation.dissipation, 2e-6);
  EXPECT_EQ(sceneFrom("[simulation]\nmodel = 'exact'\ndissipation = 0").motions[0].simulation.model,
            Model::Exact);
  EXPECT_EQ(errorOf("[simulation]\nintegrator = 'dmv6'\ndissipation = 2e-6"),
            "a.toml:3:15: simulation.dissipation = 2e-06, but the integrator \"dmv6\" takes none; "
            "choose \"euler\", \"rk4\", \"lie-euler\" or \"cf4\"");
  for (const std::string model : {"exact", "particles"}) {
    EXPECT_EQ(errorOf("[simulation]\nmodel = '" + model + "'\ndissipation = 2e-6"),
              "a.toml:3:15: simulation.dissipation = 2e-06, but the model \"" + model +
                  "\" takes none; leave it 0, or choose \"matrix\" or \"quaternion\"");
  }
}

TEST(SimulationSection, RefusesDissipationThatIsFasterThanTheSteps) {
  EXPECT_EQ(
      errorOf("[simulation]\ndissipation = 1\nstep = '10 ms'"),
      "a.toml:2:15: simulation.dissipation = 1 takes the energy in less than a step of 10 ms; "
      "take a shorter simulation.step, or at most 0.00671");
  const std::string coarse = "[simulation]\nintegrator = 'euler'\nsubsteps = 1\ndissipation = ";
  EXPECT_EQ(errorOf(coarse + "1"),
            "a.toml:4:15: simulation.dissipation = 1 takes the energy in less than a step of "
            "16.7 ms; take simulation.substeps = 248 or more, or at most 0.00402");
  EXPECT_EQ(sceneFrom(coarse + "0.00402").motions[0].simulation.dissipation, 0.00402);
  // A nudge may make L larger, and the decay faster.
  EXPECT_NE(errorOf(coarse + "0.00402\n[[nudge]]\nat = 1\nangular_velocity = [0, 0, 5]"), "");
}

TEST(SimulationSection, KnowsTheModels) {
  EXPECT_EQ(sceneFrom("simulation.model = 'particles'").motions[0].simulation.model,
            Model::Particles);
  EXPECT_EQ(sceneFrom("simulation.model = 'matrix'").motions[0].simulation.model, Model::Matrix);
  EXPECT_EQ(sceneFrom("simulation.model = 'quaternion'").motions[0].simulation.model,
            Model::Quaternion);
  EXPECT_EQ(sceneFrom("simulation.model = 'exact'").motions[0].simulation.model, Model::Exact);
}

TEST(SimulationSection, RefusesUnknownWords) {
  const std::string must =
      "a.toml:2:9: simulation.model must be \"particles\", \"matrix\", \"quaternion\", "
      "\"exact\" or \"recorded\", not ";
  EXPECT_EQ(errorOf("[simulation]\nmodel = 'matrx'"), must + "\"matrx\"; did you mean \"matrix\"?");
  EXPECT_EQ(errorOf("[simulation]\nmodel = 'rigid'"), must + "\"rigid\"");
  EXPECT_EQ(errorOf("[simulation]\nmodel = 2"), must + "2");
}

TEST(SimulationSection, RefusesNumbersOutOfRange) {
  const std::string substeps = "simulation.substeps must be an integer from 1 to 1000000, not ";
  EXPECT_EQ(errorOf("[simulation]\nsubsteps = 0"), "a.toml:2:12: " + substeps + "0");
  EXPECT_EQ(errorOf("[simulation]\nsubsteps = 1000001"), "a.toml:2:12: " + substeps + "1000001");
  EXPECT_EQ(errorOf("[simulation]\nsubsteps = 10.0"), "a.toml:2:12: " + substeps + "10.0");
  EXPECT_EQ(errorOf("[simulation]\nsubsteps = 4294967297"),
            "a.toml:2:12: " + substeps + "4294967297");
  EXPECT_EQ(errorOf("[simulation]\ndamping = -0.1"),
            "a.toml:2:11: simulation.damping must be zero or a positive number, not -0.1");
  EXPECT_EQ(errorOf("[simulation]\ndamping = inf"),
            "a.toml:2:11: simulation.damping must be zero or a positive number, not inf");
  EXPECT_EQ(errorOf("[simulation]\nstiffness = 0"),
            "a.toml:2:13: simulation.stiffness must be a positive number, not 0");
  EXPECT_EQ(errorOf("[simulation]\nstiffness = nan"),
            "a.toml:2:13: simulation.stiffness must be a positive number, not nan");
  EXPECT_EQ(
      errorOf("[simulation]\ntime_per_frame = 0.0"),
      "a.toml:2:18: simulation.time_per_frame must be a time from 1e-100 to 1e100 s, not 0.0");
  EXPECT_EQ(
      errorOf("[simulation]\ntime_per_frame = inf"),
      "a.toml:2:18: simulation.time_per_frame must be a time from 1e-100 to 1e100 s, not inf");
  EXPECT_EQ(errorOf("[simulation]\nnormalize = 1"),
            "a.toml:2:13: simulation.normalize must be true, false or a table such as { every = "
            "100 }, not 1");
}

TEST(InitialSection, ReadsEitherSpin) {
  const Scene velocity = parseScene("[initial]\nangular_velocity = [1, -2, 3.5]", "a.toml");
  EXPECT_EQ(velocity.motions[0].initial.kind, InitialSpin::Kind::AngularVelocity);
  EXPECT_EQ(velocity.motions[0].initial.value, Eigen::Vector3d(1, -2, 3.5));
  const Scene momentum = parseScene("[initial]\nangular_momentum = [0, 0.01, 0]", "a.toml");
  EXPECT_EQ(momentum.motions[0].initial.kind, InitialSpin::Kind::AngularMomentum);
  EXPECT_EQ(momentum.motions[0].initial.value, Eigen::Vector3d(0, 0.01, 0));
}

TEST(InitialSection, ReadsATiltTowardEachAxis) {
  const std::string spin = "[initial]\nangular_velocity = [1, 2, 3]\ntilt = ";
  EXPECT_EQ(parseScene(spin + "[0.5, 'x']", "a.toml").motions[0].initial.tilt,
            (physics::Tilt{0.5, 0}));
  EXPECT_EQ(parseScene(spin + "[-1, 'y']", "a.toml").motions[0].initial.tilt,
            (physics::Tilt{-1, 1}));
  EXPECT_EQ(parseScene(spin + "[0, 'z']", "a.toml").motions[0].initial.tilt, (physics::Tilt{0, 2}));
}

TEST(InitialSection, ReadsATiltInDegreesAndPrintsRadians) {
  const std::string spin = "[initial]\nangular_velocity = [1, 2, 3]\ntilt = ";
  const auto angleOf = [&](const std::string& tilt) {
    return parseScene(spin + tilt, "a.toml").motions[0].initial.tilt->angle;
  };
  EXPECT_EQ(angleOf("['180 deg', 'x']"), std::numbers::pi);
  EXPECT_EQ(angleOf("['-1.5deg', 'x']"), -1.5 * (std::numbers::pi / 180));
  EXPECT_EQ(angleOf("['0.02 rad', 'x']"), 0.02);
  EXPECT_THAT(sceneText(parseScene(spin + "['1 deg', 'z']", "a.toml")),
              testing::HasSubstr("\ntilt = [0.017453292519943295, \"z\"]"));
}

TEST(InitialSection, NeedsExactlyOneSpin) {
  EXPECT_EQ(errorOfText("\n[initial]\ntilt = [0.1, 'x']"),
            "a.toml:2:1: [initial] needs angular_velocity or angular_momentum");
  EXPECT_EQ(errorOfText("[initial]\nangular_velocity = [0, 0, 1]\nangular_momentum = [0, 0, 1]"),
            "a.toml:1:1: [initial] has both angular_velocity and angular_momentum; keep one of "
            "them");
}

TEST(InitialSection, RefusesAVectorThatIsNone) {
  const std::string must =
      "initial.angular_velocity must be three numbers from -1e9 to 1e9, at least one other than 0, "
      "not ";
  EXPECT_EQ(errorOfText("[initial]\nangular_velocity = [0, 0, 0]"),
            "a.toml:2:20: " + must + "[0, 0, 0]");
  EXPECT_EQ(errorOfText("[initial]\nangular_velocity = [0, 0, 1e-200]"),
            "a.toml:2:20: initial.angular_velocity must be at least 1e-30 long, not "
            "[0, 0, 1e-200]");
  EXPECT_EQ(errorOfText("[initial]\nangular_velocity = [1e-101, 2e-100, 2e-101]"),
            "a.toml:2:20: initial.angular_velocity must be at least 1e-30 long, not "
            "[1e-101, 2e-100, 2e-101]");
  EXPECT_EQ(errorOfText("[initial]\nangular_velocity = [0, nan, 0]"),
            "a.toml:2:24: " + must + "nan");
  EXPECT_EQ(errorOfText("[initial]\nangular_velocity = [0, 0, 1e10]"),
            "a.toml:2:27: " + must + "1e+10");
  EXPECT_EQ(errorOfText("[initial]\nangular_momentum = [1, 2]"),
            "a.toml:2:20: initial.angular_momentum must be three numbers from -1e9 to 1e9, at "
            "least one other than 0, not [1, 2]");
  EXPECT_EQ(errorOfText("[initial]\nangular_velocty = [1, 2, 3]"),
            "a.toml:2:1: unknown key \"angular_velocty\" in [initial]; did you mean "
            "\"angular_velocity\"?");
}

// These are six values to TOML.
TEST(InitialSection, GuessesADecimalCommaInEachOfThreeNumbers) {
  EXPECT_EQ(
      errorOfText("[initial]\nangular_velocity = [5,0, 0,0, 0,0]"),
      "a.toml:2:20: initial.angular_velocity must be three numbers from -1e9 to 1e9, at least one "
      "other than 0, not an array of 6 values; a comma separates values, so write a decimal point: "
      "5.0, not 5,0");
}

TEST(InitialSection, RefusesATiltThatIsNone) {
  const std::string spin = "[initial]\nangular_velocity = [0, 0, 6]\ntilt = ";
  const std::string form = "an angle and an axis, such as [0.02, \"z\"] or [\"1 deg\", \"z\"]";
  EXPECT_EQ(errorOfText(spin + "0.1"), "a.toml:3:8: initial.tilt must be " + form + ", not 0.1");
  EXPECT_EQ(errorOfText(spin + "[1]"), "a.toml:3:8: initial.tilt must be " + form + ", not [1]");
  EXPECT_EQ(errorOfText(spin + "[inf, 'x']"),
            "a.toml:3:9: initial.tilt must be an angle from -1e6 to 1e6 rad, not inf");
  EXPECT_EQ(errorOfText(spin + "['1e300 deg', 'x']"),
            "a.toml:3:9: initial.tilt must be an angle from -1e6 to 1e6 rad, not \"1e300 deg\"");
  for (const char* angle : {"", "1", "deg", "1 deg deg", "x rad", "1,5 deg"}) {
    EXPECT_EQ(
        errorOfText(spin + "['" + angle + "', 'x']"),
        std::string("a.toml:3:9: initial.tilt must be an angle from -1e6 to 1e6 rad, not \"") +
            angle + "\"; a text is a number and a unit, \"rad\", \"deg\", \"turn\" or \"°\", " +
            "such as \"1.5 rad\"");
  }
  EXPECT_EQ(errorOfText(spin + "[0.1, 'w']"),
            "a.toml:3:14: initial.tilt must be \"x\", \"y\" or \"z\", not \"w\"");
  EXPECT_EQ(errorOfText(spin + "[0.1, 'Y']"),
            "a.toml:3:14: initial.tilt must be \"x\", \"y\" or \"z\", not \"Y\"; did you mean "
            "\"y\"?");
  EXPECT_EQ(errorOfText(spin + "[0.1, 'z']"),
            "a.toml:3:8: can't tilt the initial spin (0, 0, 6) toward z: it points along that axis "
            "already; tilt it toward another axis");
}

}  // namespace
}  // namespace rotatebook::scene
