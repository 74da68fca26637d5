#include "scene/body_section.h"

#include <cmath>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "messages.h"
#include "scene/parse.h"

namespace rotatebook::scene {
namespace {

using ::testing::HasSubstr;

constexpr const char* kHandle = "[body]\nshape = \"t-handle\"\n";

/// An OBJ of a cube with corners at 0 and 2.
constexpr const char* kCube =
    "v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nv 0 0 2\nv 2 0 2\nv 2 2 2\nv 0 2 2\n"
    "f 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";

Scene withMesh(const std::string& lines, const std::string& mesh = kCube) {
  return parseScene(lines + "\n" + kSpin, "a.toml", {},
                    [&](const std::filesystem::path&, std::size_t) { return mesh; });
}

std::string meshErrorOf(const std::string& lines, const std::string& mesh = kCube) {
  try {
    withMesh(lines, mesh);
    return "no error";
  } catch (const InputError& error) {
    return error.what();
  }
}

TEST(BodySection, ReadsTheMeshOfSeveralPanelsOnce) {
  const std::string panel = "[[panel]]\nbody.mesh = \"a.obj\"\nbody.density = 1000\nlabel = ";
  int reads = 0;
  const Scene scene = parseScene(panel + "\"a\"\n" + panel + "\"b\"\nbody.unit = \"cm\"\n" + kSpin,
                                 "a.toml", {}, [&](const std::filesystem::path&, std::size_t) {
                                   ++reads;
                                   return kCube;
                                 });
  EXPECT_EQ(reads, 1);
  EXPECT_EQ(scene.motions[0].solid.mesh.content, scene.motions[1].solid.mesh.content);
  EXPECT_NEAR(scene.motions[0].body.mass, 8000, 1e-9);      // measured to rounding
  EXPECT_NEAR(scene.motions[1].body.mass, 8000e-6, 1e-15);  // measured to rounding
}

TEST(BodySection, AShapeDecidesSizeMassAndInertia) {
  const Scene scene = sceneFrom(kHandle);
  EXPECT_FALSE(scene.motions[0].solid.isBook());
  EXPECT_NEAR(scene.motions[0].body.mass, 0.09771609789725692, 1e-15);
  ASSERT_TRUE(scene.motions[0].inertia);
  EXPECT_NEAR(scene.motions[0].inertia->tensor()(1, 1) / 8.025748840628036e-05, 1,
              4e-9);  // measured 8e-10
  EXPECT_NEAR(scene.motions[0].body.size.x(), 0.12, 1e-15);
  EXPECT_NEAR(scene.motions[0].body.size.y(), 0.1106667,
              1e-5);  // measured 8e-7, as facets' corners stick out
}

TEST(BodySection, ABookIsAsBefore) {
  const Scene scene = sceneFrom("[body]\nshape = \"book\"\nmass = 2\n");
  const Scene usual = sceneFrom("[body]\nmass = 2\n");
  EXPECT_EQ(scene, usual);
  EXPECT_EQ(sceneText(sceneFrom("")).find("shape"), std::string::npos);
}

TEST(BodySection, IsPrintedAndReadBack) {
  for (const std::string& lines :
       {std::string(kHandle),
        std::string("[body]\nshape = \"cylinder\"\ndimensions = { radius = 0.1 }\nmass = 3"),
        std::string("[body]\nshape = \"disc\"\ndensity = 7.5"),
        std::string("[[body.part]]\nshape = \"box\"\n[[body.part]]\nshape = \"cylinder\"\n"
                    "dimensions = { radius = 0.01 }\ndensity = -100\nplace = [0, 0, 0.01]\n"
                    "turn = [\"90 deg\", \"y\"]")}) {
    const Scene scene = sceneFrom(lines);
    const std::string text = sceneText(scene);
    EXPECT_EQ(sceneText(parseScene(text, "a.toml")), text);
    EXPECT_EQ(parseScene(text, "a.toml").motions[0].solid, scene.motions[0].solid) << text;
    EXPECT_EQ(parseScene(text, "a.toml").motions[0].inertia, scene.motions[0].inertia) << text;
  }
}

TEST(BodySection, PartsAddUp) {
  const Scene scene = sceneFrom(
      "[[body.part]]\nshape = \"cylinder\"\ndimensions = { radius = 0.008, height = 0.12 }\n"
      "turn = [\"90 deg\", \"y\"]\n"
      "[[body.part]]\nshape = \"cylinder\"\ndimensions = { radius = 0.008, height = 0.06 }\n"
      "turn = [\"90 deg\", \"x\"]\nplace = [0, 0.038, 0]\n");
  const Scene handle = sceneFrom(kHandle);
  // Measured 3e-16.
  EXPECT_LT((scene.motions[0].inertia->tensor() - handle.motions[0].inertia->tensor()).norm() /
                handle.motions[0].inertia->tensor().norm(),
            1e-13);
}

TEST(BodySection, AMeshIsReadInItsUnit) {
  const Scene scene = withMesh("[body]\nmesh = \"cube.obj\"\nunit = \"cm\"\ndensity = 1000");
  EXPECT_NEAR(scene.motions[0].body.mass, 0.008, 1e-17);
  EXPECT_NEAR(scene.motions[0].inertia->tensor()(2, 2), 0.008 * 0.0004 / 6, 1e-20);
  EXPECT_THAT(sceneText(scene), HasSubstr("mesh = { file = \"cube.obj\", volume = 8.0, "));
  EXPECT_THAT(sceneText(scene), HasSubstr("density = 1000.0\n"));
}

TEST(BodySection, RefusesPartsThatTakeAwayWhatIsNotThere) {
  const auto withHole = [](const std::string& hole) {
    return errorOf(
        "[[body.part]]\nshape = \"box\"\ndensity = 700\ndimensions = { x = 1, y = 1, z = 1 }\n"
        "[[body.part]]\nshape = \"cylinder\"\n" +
        hole);
  };
  EXPECT_EQ(withHole("density = -700\ndimensions = { radius = 0.4, height = 1 }"), "no error");
  EXPECT_MESSAGE(withHole("density = -700\ndimensions = { radius = 0.4, height = 1.2 }"));
  EXPECT_MESSAGE(withHole("density = -800\ndimensions = { radius = 0.4, height = 1 }"));
}

TEST(BodySection, RefusesWhatIsNoBody) {
  for (const std::string& lines : std::vector<std::string>{
           "[body]\nshape = \"t-handel\"", "[body]\nshape = \"disc\"\ndimensions = { radus = 1 }",
           "[body]\nshape = \"disc\"\ndimensions = { radius = 0 }",
           "[body]\nshape = \"disc\"\nsize = [1, 1, 1]",
           "[body]\nshape = \"disc\"\ninertia = [1, 1, 1]",
           "[body]\nshape = \"disc\"\nmass = 1\ndensity = 1", "[body]\ndensity = 1",
           "[body]\ndimensions = { x = 1 }", "[body]\nshape = \"disc\"\nunit = \"mm\"",
           "[body]\nshape = \"racket\"\ndimensions = { frame = 1 }",
           "[[body.part]]\nplace = [0, 0, 0]", "[[body.part]]\nshape = \"book\"",
           "[[body.part]]\nshape = \"box\"\ndensity = 0",
           "[[body.part]]\nshape = \"box\"\ndensity = -1",
           std::string(kHandle) + "[simulation]\nmodel = \"particles\"",
           "[body]\nmesh = \"a.stl\"\ndensity = 1"}) {
    EXPECT_MESSAGE(errorOf(lines)) << lines;
  }
}

TEST(BodySection, RefusesWrongMeshes) {
  constexpr const char* kStated = "[body]\nmesh = \"cube.obj\"\ndensity = 1";
  EXPECT_EQ(meshErrorOf(kStated), "no error");
  EXPECT_MESSAGE(meshErrorOf("[body]\nmesh = \"cube.obj\""));
  EXPECT_MESSAGE(meshErrorOf("[body]\nmesh = \"cube.fbx\"\ndensity = 1"));
  EXPECT_MESSAGE(meshErrorOf("[body]\nmesh = \"/cube.obj\"\ndensity = 1"));
  EXPECT_MESSAGE(meshErrorOf("[body]\nmesh = \"cube.obj\"\ndensity = 1\nshape = \"box\""));
  EXPECT_MESSAGE(meshErrorOf("[body]\nmesh = { file = \"a\", volume = 1 }\ndensity = 1"));
  EXPECT_MESSAGE(meshErrorOf(kStated, "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"));
}

TEST(BodySection, ASpinIsAboutTheAxisOfAMoment) {
  const auto spin = [](const std::string& about) {
    return parseScene(std::string(kHandle) + "[initial]\nangular_velocity = { about = \"" + about +
                          "\", value = 4 }\n",
                      "a.toml")
        .motions[0]
        .initial.value;
  };
  EXPECT_EQ(spin("smallest"), Eigen::Vector3d(4, 0, 0));
  EXPECT_EQ(spin("middle"), Eigen::Vector3d(0, 4, 0));
  EXPECT_EQ(spin("largest"), Eigen::Vector3d(0, 0, 4));
}

TEST(BodySection, ASpinAboutAnAxisIsPrintedAndTilted) {
  const std::string text =
      std::string(kHandle) +
      "[initial]\nangular_velocity = { about = \"middle\", value = 4 }\ntilt = [0.01, \"x\"]\n";
  const Scene scene = parseScene(text, "a.toml");
  EXPECT_THAT(sceneText(scene), HasSubstr("{ about = \"middle\", value = 4.0 }"));
  EXPECT_EQ(parseScene(sceneText(scene), "a.toml").motions[0].initial, scene.motions[0].initial);
  EXPECT_NEAR(scene.motions[0].initial.tilted().x(), 4 * std::sin(0.01), 1e-15);
  EXPECT_MESSAGE(errorOfText(std::string(kHandle) +
                             "[initial]\nangular_velocity = { about = "
                             "\"middle\", value = 4 }\ntilt = [0.1, \"y\"]\n"));
  EXPECT_MESSAGE(errorOfText("[initial]\nangular_velocity = { about = \"midle\", value = 4 }\n"));
}

TEST(InitialSection, StatesTheAttitudeAsAQuaternionOrAnAngleAboutAnAxis) {
  const auto attitude = [](const std::string& value) {
    const std::string text = "[initial]\nangular_velocity = [1, 0, 0]\nattitude = " + value + "\n";
    const Scene scene = parseScene(text, "a.toml");
    EXPECT_EQ(parseScene(sceneText(scene), "a.toml").motions[0].initial, scene.motions[0].initial);
    return *scene.motions[0].initial.attitude;
  };
  EXPECT_EQ(attitude("[2, 0, -1, 0.5]"), Eigen::Vector4d(2, 0, -1, 0.5));
  const Eigen::Vector4d quarter(std::sqrt(0.5), 0, std::sqrt(0.5), 0);
  EXPECT_LT((attitude("[\"90 deg\", \"y\"]") - quarter).norm(), 1e-15);  // measured 1.1e-16
  for (const char* wrong : {"[0, 0, 0, 0]", "[1, 0, 0]", "\"90 deg\""}) {
    EXPECT_MESSAGE(errorOfText(std::string("[initial]\nangular_velocity = [1, 0, 0]\nattitude = ") +
                               wrong + "\n"))
        << wrong;
  }
}

TEST(BodySection, ASpinNamesAnAxisThatIsTheOnlyOneOfItsMoment) {
  const auto discAbout = [](const std::string& about) {
    return errorOfText("[body]\nshape = 'disc'\n[initial]\nangular_velocity = { about = '" + about +
                       "', value = 4 }\n");
  };
  EXPECT_EQ(discAbout("largest"), "no error");
  for (const char* about : {"smallest", "middle"}) {
    EXPECT_EQ(discAbout(about),
              "a.toml:4:20: initial.angular_velocity: two moments of this body are equal, so that "
              "no single axis has that one; state the spin as three numbers");
  }
}

}  // namespace
}  // namespace rotatebook::scene
