// The scenes that come with the program: each figure shows what it must, and its twin doesn't.
#include <algorithm>
#include <cctype>
#include <filesystem>
#include <ostream>
#include <string>
#include <vector>

#include "cli/program_test.h"
#include "scene/scene_file.h"

namespace rotatebook::cli::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::Not;

const fs::path kScenes = fs::path(ROTATEBOOK_SOURCE) / "scenes";
const fs::path kFigures = kScenes / "figures";

constexpr double kShortest = 12;        // [s]
constexpr double kLongest = 40;         // [s]
constexpr double kSmallestSide = 0.01;  // Of a real book. [m]
constexpr double kLargestSide = 0.5;    // [m]
constexpr double kLightest = 0.1;       // [kg]
constexpr double kHeaviest = 5;         // [kg]

std::vector<std::string> scenesBelow(const fs::path& folder) {
  std::vector<std::string> names;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.path().extension() != ".toml") continue;
    names.push_back(entry.path().lexically_relative(folder).replace_extension().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

std::string wordFrom(std::string name) {
  std::replace_if(
      name.begin(), name.end(), [](unsigned char letter) { return !std::isalnum(letter); }, '_');
  return name;
}

/// A figure's scene with that changed which makes its effect.
struct Twin {
  const char* figure;
  std::vector<std::string> overrides;
};

void PrintTo(const Twin& twin, std::ostream* stream) {
  *stream << twin.figure;
}

const std::vector<std::string> kAboutX{"initial.angular_velocity=[4, 0, 0]",
                                       "initial.tilt=[0.014, \"z\"]"};
const std::vector<std::string> kAboutZ{"initial.angular_velocity=[0, 0, 4]",
                                       "initial.tilt=[0.0003, \"x\"]"};
const std::vector<std::string> kNormalized{"simulation.normalize=true"};

const std::vector<Twin> kTwins{
    {"fig03-stable-z", kAboutX},
    {"fig04-stable-y", kAboutX},
    {"fig05-unstable-x", kAboutZ},
    {"fig05b-rounding-only", {"simulation.model=quaternion"}},
    {"fig06-undamped", {"simulation.damping=1"}},
    {"fig07-unnormalized", kNormalized},
    {"fig08-neither", {"simulation.damping=1"}},
    {"fig08-neither", kNormalized},
    {"fig09-matrix", kAboutZ},
    {"fig09b-matrix-large-step", {"simulation.substeps=100"}},
    {"fig10-matrix-unnormalized", kNormalized},
    {"fig11-quaternion-unnormalized", kNormalized},
    {"fig12-quaternion-pulsating", kNormalized},
    {"figa-exact", {"simulation.model=\"quaternion\""}},
    {"figa-normalized-euler", {"simulation.substeps=64"}},
    {"figa-normalized-euler", {"simulation.integrator=\"rk4\""}},
};

TEST(Figures, AreAllThere) {
  std::vector<std::string> names;
  for (const Twin& twin : kTwins) {
    if (names.empty() || names.back() != twin.figure) names.emplace_back(twin.figure);
  }
  EXPECT_EQ(scenesBelow(kFigures), names);
}

class ShippedScene : public ProgramTest, public ::testing::WithParamInterface<std::string> {};

TEST_P(ShippedScene, PassesTheCheck) {
  const std::string path = (kScenes / (GetParam() + ".toml")).string();
  const ChildResult result = runWithoutGraphics({"check", path});
  EXPECT_EQ(result.status, 0) << result.error;
  EXPECT_EQ(result.output, path + ": ok\n");
}

TEST_P(ShippedScene, ShowsWhatItExpects) {
  const std::string path = (kScenes / (GetParam() + ".toml")).string();
  const ChildResult result = run({"render", path, "--size", "96x54", "--no-png"});
  EXPECT_EQ(result.status, 0) << result.output << result.error;
  EXPECT_THAT(result.output, HasSubstr("\n  met    "));
  EXPECT_THAT(result.output, Not(HasSubstr("UNMET")));
  EXPECT_TRUE(has("out/" + fs::path(path).stem().string() + ".mp4"));
}

INSTANTIATE_TEST_SUITE_P(All, ShippedScene, ::testing::ValuesIn(scenesBelow(kScenes)),
                         [](const auto& scene) { return wordFrom(scene.param); });

class Figure : public ::testing::TestWithParam<std::string> {};

TEST_P(Figure, IsARealBookInRealTime) {
  const scene::Scene scene = scene::readScene(kFigures / (GetParam() + ".toml"));
  EXPECT_EQ(scene.clip.width, 1280);
  EXPECT_EQ(scene.clip.height, 720);
  EXPECT_EQ(scene.clip.frameRate.text(), "60");
  EXPECT_GE(scene.clip.duration, kShortest);
  EXPECT_LE(scene.clip.duration, kLongest);
  EXPECT_EQ(scene.simulation.timePerFrame, 1.0 / 60);
  EXPECT_GE(scene.body.size.minCoeff(), kSmallestSide);
  EXPECT_LE(scene.body.size.maxCoeff(), kLargestSide);
  EXPECT_GE(scene.body.mass, kLightest);
  EXPECT_LE(scene.body.mass, kHeaviest);
  EXPECT_FALSE(scene.title.empty());
  EXPECT_FALSE(scene.caption.empty());
  EXPECT_FALSE(scene.expectations.empty());
}

INSTANTIATE_TEST_SUITE_P(All, Figure, ::testing::ValuesIn(scenesBelow(kFigures)),
                         [](const auto& scene) { return wordFrom(scene.param); });

class FigureTwin : public ProgramTest, public ::testing::WithParamInterface<Twin> {};

TEST_P(FigureTwin, FailsTheExpectations) {
  std::vector<std::string> arguments{"simulate", (kFigures / GetParam().figure).string() + ".toml",
                                     "--csv", "x.csv"};
  for (const std::string& change : GetParam().overrides) {
    arguments.insert(arguments.end(), {"--set", change});
  }
  const ChildResult result = run(arguments);
  EXPECT_EQ(result.status, 1) << result.output << result.error;
  EXPECT_THAT(result.output, HasSubstr("\n  UNMET  "));
}

INSTANTIATE_TEST_SUITE_P(All, FigureTwin, ::testing::ValuesIn(kTwins), [](const auto& twin) {
  return wordFrom(twin.param.figure) + std::to_string(twin.index);
});

}  // namespace
}  // namespace rotatebook::cli::testing
