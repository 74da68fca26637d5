// The scenes that come with the program: each figure shows what it must, and its twin doesn't.
#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <ostream>
#include <string>
#include <vector>

#include "cli/program_test.h"
#include "store/scene_file.h"

namespace rotatebook::cli::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::Not;

const fs::path kScenes = fs::path(ROTATEBOOK_SOURCE) / "scenes";

constexpr double kShortest = 12;        // [s]
constexpr double kLongest = 40;         // [s]
constexpr double kSmallestSide = 0.01;  // Of a real book. [m]
constexpr double kLargestSide = 0.5;    // [m]
constexpr double kLightest = 0.1;       // [kg]
constexpr double kHeaviest = 5;         // [kg]
constexpr double kMostLetters = 10.1;   // Of a text, in a second: most people read 17. Measured 9.9
constexpr double kLatest = 20;          // The last text, which names the effect. [s]

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

/// The figures, the comparisons and the bodies: scenes that are there to show an effect.
std::vector<std::string> figures() {
  std::vector<std::string> names;
  for (const char* folder : {"bodies", "comparisons", "figures"}) {
    for (const std::string& name : scenesBelow(kScenes / folder)) {
      names.push_back(folder + ("/" + name));
    }
  }
  return names;
}

/// A figure's scene with that changed which makes its effect.
struct Twin {
  const char* figure;  ///< Its path from kScenes, without ".toml"
  std::vector<std::string> overrides;
};

void PrintTo(const Twin& twin, std::ostream* stream) {
  *stream << twin.figure;
}

const std::vector<std::string> kAboutX{"initial.angular_velocity=[4, 0, 0]",
                                       "initial.tilt=[0.014, \"z\"]"};
const std::vector<std::string> kAboutZ{"initial.angular_velocity=[0, 0, 4]",
                                       "initial.tilt=[0.0003, \"x\"]"};
const std::vector<std::string> kNeverNudged{"nudge.0.at=1000", "nudge.1.at=1000"};
const char* const kEven = "clip.speed=1";  // Without a flip there is none to slow down at.
const std::vector<std::string> kNormalized{"simulation.normalize=true"};

const std::vector<Twin> kTwins{
    {"bodies/disc-holds", {"initial.angular_velocity=[0, 5, 0]"}},
    {"bodies/disc-tips", {"initial.angular_velocity=[0, 0, 5]", "initial.tilt=[0.01, \"x\"]"}},
    {"bodies/disc-turned-aside", {"initial.angular_velocity=[0, 5, 0]"}},
    {"bodies/earth", {"simulation.dissipation=0"}},
    {"bodies/earth", {"panel.0.body.part.0.dimensions={ x = 0.3, y = 0.3, z = 0.300984 }"}},
    {"bodies/explorer-1", {"panel.0.simulation.dissipation=0"}},
    {"bodies/explorer-1", {"panel.1.simulation.dissipation=6.39"}},
    {"bodies/knot", {"panel.1.initial.angular_velocity={about=\"largest\", value=5}"}},
    {"bodies/mallet", {"initial.angular_velocity={about=\"largest\", value=9}"}},
    {"bodies/particles-beside-rigid",
     {"panel.2.initial.angular_velocity={about=\"largest\", value=12}"}},
    {"bodies/phone",
     {"panel.1.initial.angular_velocity={about=\"smallest\", value=5}",
      "panel.1.initial.tilt=[0.01, \"x\"]", kEven}},
    {"bodies/racket",
     {"initial.angular_velocity={about=\"largest\", value=5}", "initial.tilt=[0.01, \"x\"]",
      kEven}},
    {"bodies/shapes", {"panel.0.initial.angular_velocity={about=\"largest\", value=5}"}},
    {"bodies/sizes", {"panel.1.initial.angular_velocity={about=\"largest\", value=5}"}},
    {"bodies/sizes", {"panel.3.body.dimensions.bar=\"3 km\""}},
    {"bodies/toutatis", {"initial.angular_velocity=[0, 0, 2e-5]"}},
    {"comparisons/axes", {"panel.1.initial.angular_velocity=[0, 4, 0]", kEven}},
    {"comparisons/axes",
     {"panel.0.initial.angular_velocity=[4, 0, 0]", "panel.0.initial.tilt=[0.014, \"z\"]"}},
    {"comparisons/axes",
     {"panel.2.initial.angular_velocity=[4, 0, 0]", "panel.2.initial.tilt=[0.014, \"z\"]"}},
    {"comparisons/bursts", kNormalized},
    {"comparisons/energies",
     {"panel.0.initial.angular_velocity=[4, 0, 0]", "panel.0.initial.tilt=[0.003, \"z\"]"}},
    {"comparisons/energies", {"panel.1.initial.angular_velocity=[0, 4, 0]"}},
    {"comparisons/energies",
     {"panel.2.initial.angular_velocity=[4, 0, 0]", "panel.2.initial.tilt=[0.003, \"z\"]"}},
    {"comparisons/engines", {"panel.0.simulation.integrator=\"rk4\""}},
    {"comparisons/engines", {"panel.1.simulation.integrator=\"rk4\""}},
    {"comparisons/engines", {"panel.2.simulation.integrator=\"rk4\""}},
    {"comparisons/engines", {"panel.3.simulation.integrator=\"rk4\""}},
    {"comparisons/matrix-steps", {"panel.1.simulation.substeps=100"}},
    {"comparisons/matrix-steps", {"panel.2.simulation.substeps=10"}},
    {"comparisons/models", {"panel.3.simulation.model=\"quaternion\""}},
    {"comparisons/models", {"panel.0.simulation.model=\"exact\""}},
    {"comparisons/models", {"panel.1.simulation.integrator=\"rk4\""}},
    {"comparisons/models", {"panel.2.simulation.integrator=\"rk4\""}},
    {"comparisons/ninety-six", {"grid.rows.values.0.value=\"rk4\""}},
    {"comparisons/ninety-six", {"grid.rows.values.1.value=\"rk4\""}},
    {"comparisons/ninety-six", {"grid.rows.values.2.value=\"rk4\""}},
    {"comparisons/ninety-six", {"grid.rows.values.3.value=\"rk4\""}},
    {"comparisons/ninety-six", {"grid.rows.values.4.value=\"rk4\""}},
    {"comparisons/ninety-six", {"grid.rows.values.5.value=\"euler\""}},
    {"comparisons/ninety-six", {"grid.rows.values.6.value=\"euler\""}},
    {"comparisons/ninety-six", {"grid.rows.values.7.value=\"euler\""}},
    {"comparisons/recorded-defaults", {"panel.0.simulation.file=recordings/bullet.csv"}},
    {"comparisons/recorded-defaults", {"panel.1.simulation.file=recordings/simbody.csv"}},
    {"comparisons/recorded-defaults", {"panel.2.simulation.file=recordings/mujoco.csv"}},
    {"comparisons/recorded-defaults", {"panel.3.simulation.file=recordings/mujoco-2ms.csv"}},
    {"comparisons/recorded-engines", {"panel.1.simulation.file=recordings/simbody.csv"}},
    {"comparisons/recorded-engines", {"panel.2.simulation.file=recordings/simbody.csv"}},
    {"comparisons/recorded-engines", {"panel.3.simulation.file=recordings/simbody.csv"}},
    {"comparisons/recorded-engines", {"panel.4.simulation.file=recordings/mujoco.csv"}},
    {"comparisons/recorded-engines", {"panel.5.simulation.file=recordings/mujoco-rk4.csv"}},
    {"comparisons/tossed-book", {"panel.0.simulation.bias=[0.262, -0.332, 0.297]"}},
    {"comparisons/tossed-book", {"panel.1.simulation.bias=[0, 0, 0]"}},
    {"figures/fig02-in-space", {"panel.0.initial.angular_velocity={about=\"largest\", value=7}"}},
    {"figures/fig03-stable-z", kAboutX},
    {"figures/fig03b-jiggled-z", kNeverNudged},
    {"figures/fig04-stable-y", kAboutX},
    {"figures/fig04b-jiggled-y", kNeverNudged},
    {"figures/fig05-unstable-x", kAboutZ},
    {"figures/fig05b-rounding-only", {"simulation.model=quaternion"}},
    {"figures/fig05c-nudged-x", {"nudge.0.at=1000", kEven}},
    {"figures/fig05d-ten-minutes", {"simulation.damping=0"}},
    {"figures/fig05d-ten-minutes", {"simulation.normalize=false"}},
    {"figures/fig06-undamped", {"simulation.damping=1"}},
    {"figures/fig06-undamped", {"panel.1.simulation.integrator=\"euler\""}},
    {"figures/fig07-unnormalized", kNormalized},
    {"figures/fig08-neither", {"simulation.damping=1"}},
    {"figures/fig08-neither", kNormalized},
    {"figures/fig09-matrix", kAboutZ},
    {"figures/fig09b-matrix-large-step", {"simulation.substeps=100"}},
    {"figures/fig10-matrix-unnormalized", kNormalized},
    {"figures/fig11-quaternion-unnormalized", kNormalized},
    {"figures/fig12-quaternion-pulsating", kNormalized},
    {"figures/figa-exact", {"simulation.model=\"quaternion\"", "simulation.integrator=\"euler\""}},
    {"figures/figh-rolling", {"initial.angular_velocity=[0, 0, 5]", "initial.tilt=[0.01, \"x\"]"}},
};

TEST(Figures, AreAllThere) {
  std::vector<std::string> names;
  for (const Twin& twin : kTwins) {
    if (names.empty() || names.back() != twin.figure) names.emplace_back(twin.figure);
  }
  EXPECT_EQ(figures(), names);
}

class ShippedScene : public ProgramTest, public ::testing::WithParamInterface<std::string> {};

TEST_P(ShippedScene, PassesTheCheck) {
  const std::string path = (kScenes / (GetParam() + ".toml")).string();
  const ChildResult result = runWithoutGraphics({"check", path});
  EXPECT_EQ(result.status, 0) << result.error;
  EXPECT_EQ(result.output, path + ": ok\n");
}

INSTANTIATE_TEST_SUITE_P(All, ShippedScene, ::testing::ValuesIn(scenesBelow(kScenes)),
                         [](const auto& scene) { return wordFrom(scene.param); });

/// Those whose motion is expected to do something; what maps expect is in maps_test.cpp.
std::vector<std::string> scenesThatExpect() {
  std::vector<std::string> names = scenesBelow(kScenes);
  std::erase_if(names, [](const std::string& name) { return name.starts_with("maps/"); });
  return names;
}

class ExpectingScene : public ShippedScene {};

TEST_P(ExpectingScene, ShowsWhatItExpects) {
  const std::string path = (kScenes / (GetParam() + ".toml")).string();
  std::ifstream file(path);
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  const bool isGrid = text.find("\n[grid]\n") != std::string::npos;  // Its books need room.
  // Of the whole motion, whatever is drawn of it.
  const ChildResult result = run(
      {"render", path, "--size", isGrid ? "1280x720" : "128x72", "--no-png", "--frames", "0:3"});
  EXPECT_EQ(result.status, 0) << result.output << result.error;
  EXPECT_THAT(result.output, HasSubstr("\n  met      "));
  EXPECT_THAT(result.output, Not(HasSubstr("not met")));
  EXPECT_TRUE(has("out/" + fs::path(path).stem().string() + "_00000-00003.mp4"));
}

INSTANTIATE_TEST_SUITE_P(All, ExpectingScene, ::testing::ValuesIn(scenesThatExpect()),
                         [](const auto& scene) { return wordFrom(scene.param); });

class Figure : public ::testing::TestWithParam<std::string> {};

bool changesPaceAtTimes(const scene::Scene& scene) {
  return scene.clip.speed && !scene.clip.speed->stretches.empty() &&
         std::ranges::all_of(scene.clip.speed->stretches,
                             [](const scene::SpeedStretch& one) { return one.value < 2; });
}

TEST_P(Figure, IsARealBookInRealTimeUnlessTheTitleSaysOtherwise) {
  const scene::Scene scene = store::readScene(kScenes / (GetParam() + ".toml"));
  EXPECT_EQ(scene.clip.width, 1280);
  EXPECT_EQ(scene.clip.height, 720);
  EXPECT_EQ(scene.clip.frameRate.text(), "60");
  EXPECT_GE(scene.clip.duration, kShortest);
  EXPECT_LE(scene.clip.duration, kLongest);
  const bool isRealTime = std::ranges::none_of(
      std::array{"minutes in", "days in", "times as fast", "slow motion"},
      [&](const char* words) { return scene.title.find(words) != std::string::npos; });
  if (changesPaceAtTimes(scene)) {
    EXPECT_TRUE(shows(scene, scene::Overlay::Clock)) << "says \"0.25×\" or \"1.5×\" meanwhile";
  } else {
    const bool isEven = !scene.clip.speed || scene.clip.speed->stretches.empty();
    EXPECT_EQ(isEven && scene.timePerFrame() == 1.0 / 60, isRealTime);
  }
  EXPECT_FALSE(scene.title.empty());
  EXPECT_FALSE(scene.caption.empty());
  for (const scene::Panel& motion : scene.motions) {
    EXPECT_FALSE(motion.expectations.empty());
    if (!motion.solid.isBook()) continue;
    EXPECT_GE(motion.body.size.minCoeff(), kSmallestSide);
    EXPECT_LE(motion.body.size.maxCoeff(), kLargestSide);
    EXPECT_GE(motion.body.mass, kLightest);
    EXPECT_LE(motion.body.mass, kHeaviest);
  }
}

/// How many letters a text in UTF-8 has.
std::ptrdiff_t lettersOf(const std::string& text) {
  return std::ranges::count_if(text, [](char byte) { return (byte & 0xC0) != 0x80; });
}

TEST_P(Figure, LeavesTimeToReadEachTextTwice) {
  const scene::Scene scene = store::readScene(kScenes / (GetParam() + ".toml"));
  std::vector<std::pair<double, std::string>> texts;  // with their time in the video [s]
  for (const scene::ShownCue& shown : scene.shownCues) {
    const auto& text = scene.cues[shown.cue].text;
    if (text) texts.emplace_back(static_cast<double>(shown.frame) / 60, *text);
  }
  ASSERT_GE(texts.size(), 2U);
  EXPECT_EQ(texts.front().first, 0);
  EXPECT_LE(texts.back().first, kLatest);
  texts.emplace_back(scene.clip.duration, "");
  for (std::size_t i = 0; i + 1 < texts.size(); ++i) {
    const double seconds = texts[i + 1].first - texts[i].first;
    EXPECT_LE(static_cast<double>(lettersOf(texts[i].second)) / seconds, kMostLetters)
        << texts[i].second << " stands for " << seconds << " s";
  }
}

TEST_P(Figure, DrawsTheCameraBackIfItBursts) {
  const scene::Scene scene = store::readScene(kScenes / (GetParam() + ".toml"));
  for (const scene::Panel& motion : scene.motions) {
    for (const scene::Expectation& expected : motion.expectations) {
      if (expected.measure != scene::Measure::DivergesAt) continue;
      EXPECT_EQ(scene.camera.follow, scene::Follow::Size);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, Figure, ::testing::ValuesIn(figures()),
                         [](const auto& scene) { return wordFrom(scene.param); });

class FigureTwin : public ProgramTest, public ::testing::WithParamInterface<Twin> {};

TEST_P(FigureTwin, FailsTheExpectations) {
  std::vector<std::string> arguments{"simulate", (kScenes / GetParam().figure).string() + ".toml",
                                     "--csv",    "x.csv",
                                     "--set",    "cue=[]"};  // of events it may lack
  for (const std::string& change : GetParam().overrides) {
    arguments.insert(arguments.end(), {"--set", change});
  }
  const ChildResult result = run(arguments);
  EXPECT_EQ(result.status, 1) << result.output << result.error;
  EXPECT_THAT(result.output, HasSubstr("\n  not met  "));
}

INSTANTIATE_TEST_SUITE_P(All, FigureTwin, ::testing::ValuesIn(kTwins), [](const auto& twin) {
  return wordFrom(twin.param.figure) + std::to_string(twin.index);
});

}  // namespace
}  // namespace rotatebook::cli::testing
