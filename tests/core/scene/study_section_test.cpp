#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "scene/parse.h"
#include "scene/scene_text.h"

namespace rotatebook::scene {
namespace {

using physics::Integrator;
using physics::Model;

constexpr const char* kFlipping =
    "[initial]\nangular_velocity = [5, 0, 0]\ntilt = [0.1, 'z']\n[study]\n";

/// The message about [study] with these lines, in the third line and on, of a scene of particles.
std::string errorOfParticles(const std::string& lines) {
  return errorOf("[simulation]\nmodel = 'particles'\n[study]\n" + lines);
}

std::string errorOfTilts(const std::string& lines) {
  return errorOfText(kFlipping + lines);
}

TEST(StudySection, IsNotThereUnlessWritten) {
  EXPECT_FALSE(sceneFrom("").study.has_value());
}

TEST(StudySection, HasEveryIntegratorAndElevenStepsByDefault) {
  const Scene rigid = sceneFrom("[study]");
  ASSERT_TRUE(rigid.study.has_value());
  EXPECT_EQ(*rigid.study, defaultStudy(Model::Quaternion));
  EXPECT_EQ(rigid.study->integrators.size(), 14U);
  EXPECT_EQ(rigid.study->steps, (std::vector{1, 2, 4, 8, 16, 32, 64, 128, 256, 512, 1024}));
  EXPECT_EQ(sceneFrom("simulation.model = 'particles'\n[study]").study->integrators,
            (std::vector{Integrator::Euler, Integrator::Rk4, Integrator::SymplecticEuler,
                         Integrator::Verlet}));
}

TEST(StudySection, ReadsIntegratorsStepsAndOrders) {
  const Scene scene = sceneFrom(
      "[study]\nintegrators = ['rk4', 'dmv6']\nsteps = [5, 1]\n"
      "orders = { dmv6 = { min = 5.5, max = 6.5 }, rk4 = { min = 3 } }");
  EXPECT_EQ(scene.study->integrators, (std::vector{Integrator::Rk4, Integrator::Dmv6}));
  EXPECT_EQ(scene.study->steps, (std::vector{5, 1}));
  EXPECT_EQ(scene.study->orders, (std::vector<ExpectedOrder>{{Integrator::Dmv6, {5.5, 6.5}},
                                                             {Integrator::Rk4, {3, {}}}}));
  EXPECT_FALSE(scene.study->isOfTilts());
}

TEST(StudySection, KnowsTheIntegratorsOfParticlesByName) {
  const Scene scene = sceneFrom(
      "simulation.model = 'particles'\n[study]\n"
      "integrators = ['verlet', 'rk4', 'symplectic-euler']");
  EXPECT_EQ(scene.study->integrators,
            (std::vector{Integrator::Verlet, Integrator::Rk4, Integrator::SymplecticEuler}));
}

TEST(StudySection, ForgetsTheOrderOfAnIntegratorThatIsLeftOut) {
  const Scene scene = sceneFrom("[study]\norders.rk4.min = 3\norders.cf4.min = 3",
                                {"study.integrators=[\"euler\", \"cf4\"]"});
  EXPECT_EQ(scene.study->orders, (std::vector<ExpectedOrder>{{Integrator::Cf4, {3, {}}}}));
}

TEST(StudySection, ReadsTilts) {
  const Scene scene = parseScene(std::string(kFlipping) +
                                     "tilts = [0.1, 1e-8]\n"
                                     "flip_law = { max = 0.01 }",
                                 "a.toml");
  EXPECT_TRUE(scene.study->isOfTilts());
  EXPECT_EQ(scene.study->tilts, (std::vector{0.1, 1e-8}));
  EXPECT_EQ(scene.study->flipLaw, (Bounds{{}, 0.01}));
  EXPECT_TRUE(scene.study->integrators.empty());
  EXPECT_TRUE(scene.study->steps.empty());
}

TEST(StudySection, ReadsBackFromItsText) {
  for (const std::string lines :
       {"", "steps = [3]\nintegrators = ['cf4']", "orders.rk4 = { min = 3.5, max = 4.5 }"}) {
    const Scene scene = sceneFrom("[study]\n" + lines);
    EXPECT_EQ(parseScene(sceneText(scene), "a.toml").study, scene.study) << sceneText(scene);
  }
  const Scene tilts =
      parseScene(std::string(kFlipping) + "tilts = [0.1, 1e-8]\nflip_law.max = 0.01", "a.toml");
  EXPECT_EQ(parseScene(sceneText(tilts), "a.toml").study, tilts.study) << sceneText(tilts);
}

TEST(StudySection, RefusesIntegratorsThatTheModelDoesNotHave) {
  const std::string valid =
      "study.integrators must be \"euler\", \"rk4\", \"symplectic-euler\" or \"verlet\", not ";
  EXPECT_EQ(errorOfParticles("integrators = ['euler', 'dmv6']"),
            "a.toml:4:25: " + valid + "\"dmv6\"");
  EXPECT_EQ(errorOfParticles("integrators = ['verlett']"),
            "a.toml:4:16: " + valid + "\"verlett\"; did you mean \"verlet\"?");
  EXPECT_EQ(errorOfParticles("integrators = [4]"), "a.toml:4:16: " + valid + "4");
  EXPECT_EQ(errorOfParticles("orders.cf4.min = 4"),
            "a.toml:4:8: unknown key \"cf4\" in [study.orders]; valid are \"euler\", "
            "\"rk4\", \"symplectic-euler\" and \"verlet\"");
}

TEST(StudySection, RefusesListsThatAreNone) {
  const std::string integrators =
      "a.toml:4:15: study.integrators must be a list of integrators, such as [\"euler\", "
      "\"rk4\"], not ";
  EXPECT_EQ(errorOfParticles("integrators = []"), integrators + "[]");
  EXPECT_EQ(errorOfParticles("integrators = 'euler'"), integrators + "\"euler\"");
  EXPECT_EQ(errorOfParticles("steps = 4"),
            "a.toml:4:9: study.steps must be a list of steps a frame, such as [1, 2, 4], not 4");
  EXPECT_EQ(errorOfTilts("tilts = []"),
            "a.toml:5:9: study.tilts must be a list of angles, such as [0.1, 0.01], not []");
}

TEST(StudySection, RefusesSomethingTwice) {
  EXPECT_EQ(errorOfParticles("steps = [1, 2, 1]"), "a.toml:4:16: study.steps has 1 twice");
  EXPECT_EQ(errorOfParticles("integrators = ['rk4', 'rk4']"),
            "a.toml:4:23: study.integrators has \"rk4\" twice");
}

TEST(StudySection, RefusesNumbersOutOfRange) {
  const std::string steps = "study.steps must be an integer from 1 to 1000000, not ";
  EXPECT_EQ(errorOfParticles("steps = [0]"), "a.toml:4:10: " + steps + "0");
  EXPECT_EQ(errorOfParticles("steps = [2, 1000001]"), "a.toml:4:13: " + steps + "1000001");
  EXPECT_EQ(errorOfParticles("steps = [1.5]"), "a.toml:4:10: " + steps + "1.5");
  const std::string tilts =
      "a.toml:5:10: study.tilts must be an angle over 0 and up to 0.785 rad, "
      "not ";
  EXPECT_EQ(errorOfTilts("tilts = [0]"), tilts + "0");
  EXPECT_EQ(errorOfTilts("tilts = [-0.1]"), tilts + "-0.1");
  EXPECT_EQ(errorOfTilts("tilts = [0.8]"), tilts + "0.8");
  EXPECT_EQ(errorOfTilts("tilts = [nan]"), tilts + "nan");
}

TEST(StudySection, RefusesBoundsThatBoundNothing) {
  EXPECT_EQ(errorOfParticles("orders.rk4 = {}"),
            "a.toml:4:14: study.orders.rk4 needs min, max or both");
  EXPECT_EQ(errorOfParticles("orders.rk4 = { min = 4, max = 3 }"),
            "a.toml:4:22: study.orders.rk4.min must be at most max, 3.0, not 4");
  EXPECT_EQ(errorOfParticles("orders.rk4.rises_to = 4"),
            "a.toml:4:12: unknown key \"rises_to\" in [study.orders.rk4]; valid are \"min\" and "
            "\"max\"");
}

TEST(StudySection, TakesBoundsThatAreOneNumber) {
  const Scene scene = sceneFrom("[study]\norders.rk4 = { min = 4, max = 4 }");
  EXPECT_EQ(scene.study->orders, (std::vector<ExpectedOrder>{{Integrator::Rk4, {4.0, 4.0}}}));
}

TEST(StudySection, RefusesUnknownKeys) {
  EXPECT_EQ(errorOfParticles("step = [1]"),
            "a.toml:4:1: unknown key \"step\" in [study]; did you mean \"steps\"?");
}

TEST(StudySection, RefusesBothKindsAtOnce) {
  EXPECT_EQ(errorOfTilts("tilts = [0.1]\nsteps = [1]"),
            "a.toml:6:9: [study] has both tilts and steps; it compares either tilts, or "
            "integrators and steps");
  EXPECT_EQ(errorOfParticles("flip_law.max = 1"), "a.toml:4:1: study.flip_law needs study.tilts");
}

TEST(StudySection, RefusesTheExactModelWithoutTilts) {
  EXPECT_EQ(errorOf("simulation.model = 'exact'\n[study]"),
            "a.toml:2:1: the model \"exact\" takes no steps, so [study] has no integrators "
            "and steps to compare; give it tilts, or choose another model");
}

TEST(StudySection, RefusesTiltsOfASpinThatDoesNotFlip) {
  EXPECT_EQ(errorOf("[study]\ntilts = [0.1]"),
            "a.toml:2:9: study.tilts needs initial.tilt, whose axis it takes, such as [0.1, "
            "\"z\"]");
  EXPECT_EQ(errorOfText("[initial]\nangular_velocity = [0, 5, 0]\ntilt = [0.1, 'z']\n[study]\n"
                        "tilts = [0.1]"),
            "a.toml:5:9: study.tilts needs a spin about the axis of the middle moment of inertia, "
            "the only one about which a body flips");
}

TEST(StudySection, ChecksThemForTheAxesOfTheBodysOwnInertia) {
  const std::string lines =
      "angular_velocity = [0, 5, 0]\ntilt = [0.1, 'z']\n[study]\ntilts = [0.1]";
  EXPECT_EQ(errorOfText("[body]\ninertia = [1, 2, 2.5]\n[initial]\n" + lines), "no error");
}

TEST(Bounds, HoldWhatLiesWithinThem) {
  EXPECT_TRUE((Bounds{1, 2}.hold(1)));
  EXPECT_TRUE((Bounds{1, 2}.hold(2)));
  EXPECT_FALSE((Bounds{1, 2}.hold(0.999)));
  EXPECT_FALSE((Bounds{1, 2}.hold(2.001)));
  EXPECT_TRUE((Bounds{{}, 2}.hold(-1e300)));
  EXPECT_FALSE(Bounds{}.hold(std::numeric_limits<double>::quiet_NaN()));
}

}  // namespace
}  // namespace rotatebook::scene
