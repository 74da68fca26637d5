#include "overlay/panel_heads.h"

#include <algorithm>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "messages.h"
#include "overlay/motion.h"

namespace rotatebook::overlay {
namespace {

using ::testing::ElementsAre;

/// Two panels side by side whose motions turn over and, if asked, diverge.
scene::Scene pairOf(const std::string& first, const std::string& second,
                    const std::vector<std::string>& overrides = {}) {
  return scene::parseScene(
      "[initial]\nangular_velocity = [6.3, 0, 0]\ntilt = [0.02, 'z']\n"
      "[simulation]\nintegrator = 'rk4'\n[clip]\nfps = 30\nduration = 6\nsize = [1280, 720]\n"
      "[overlay]\nshow = ['half_turns']\n"
      "[[panel]]\nlabel = '" +
          first + "'\n[[panel]]\nlabel = '" + second + "'\n",
      "pair.toml", overrides);
}

std::vector<physics::Trajectory> simulated(const scene::Scene& scene) {
  std::vector<physics::Trajectory> motions;
  for (const scene::Panel& panel : scene.motions) {
    const scene::Scene one = scene::withMotion(scene, panel);
    motions.push_back(physics::simulate(one.motions[0].motion(), one.clip.frameCount()));
  }
  return motions;
}

PanelCells cellsOf(const scene::Scene& scene) {
  const int width = scene.clip.width / 2;
  return {.width = width,
          .height = scene.clip.height,
          .corners = {{0, 0}, {width, 0}},
          .letters = 0.028 * scene.clip.height};
}

/// The heads of a scene whose motions have gone on for a while.
struct Drawn {
  explicit Drawn(const scene::Scene& scene, std::int64_t frame = 170)
      : motions(simulated(scene)), heads(scene, motions, cellsOf(scene)) {
    picture = testing::plainPicture(scene, 17);
    heads.draw(frame, picture);
  }

  std::vector<physics::Trajectory> motions;
  PanelHeads heads;
  image::Image picture;
};

/// Whether row `y` of a picture is of one colour.
bool isPlain(const image::Image& picture, int y) {
  const std::uint8_t* row = picture.row(y);
  for (int i = 4; i < picture.stride(); ++i) {
    if (row[i] != row[i - 4]) return false;
  }
  return true;
}

TEST(PanelHeads, AreAllInTheirRows) {
  for (const char* size : {"[640, 360]", "[1280, 720]", "[1920, 1080]"}) {
    const scene::Scene scene =
        pairOf("y: smallest moment", "x", {std::string("clip.size=") + size});
    const Drawn drawn(scene);
    const int rows = drawn.heads.rows();
    EXPECT_LT(rows, scene.clip.height / 12) << "takes more than a line";  // measured 1 / 15.7
    int written = 0;
    for (int y = 0; y < scene.clip.height; ++y) {
      const bool plain = isPlain(drawn.picture, y);
      EXPECT_TRUE(plain || y < rows) << size << ", row " << y;
      written += plain ? 0 : 1;
    }
    EXPECT_GT(written, rows / 3);  // measured 0.58 of them
  }
}

TEST(PanelHeads, HaveTextsOfOneKindAtOnePlace) {
  const scene::Scene scene = pairOf("a much longer label", "short");
  const Drawn drawn(scene);
  const std::vector<Box>& texts = drawn.heads.texts();
  ASSERT_EQ(texts.size(), 4U);  // label, count, label, count
  EXPECT_EQ(testing::meeting(texts), "");
  EXPECT_EQ(texts[2].x, texts[0].x + 640);
  EXPECT_EQ(texts[3].x, texts[1].x + 640);
  EXPECT_EQ(texts[3].y, texts[1].y);
  EXPECT_GT(texts[1].x, texts[0].right());
  EXPECT_LT(texts[1].right(), 640);
}

TEST(PanelHeads, HaveAnotherLineForWhatHasNoRoom) {
  const std::string longest = "a label that takes nearly all of a whole line";
  const Drawn drawn(pairOf(longest, "short"));
  const std::vector<Box>& texts = drawn.heads.texts();
  ASSERT_EQ(texts.size(), 4U);
  EXPECT_EQ(testing::meeting(texts), "");
  EXPECT_GT(texts[1].y, texts[0].bottom() - 1);
  EXPECT_EQ(texts[1].x, texts[0].x);
  EXPECT_EQ(texts[3].y, texts[1].y);
  EXPECT_GT(drawn.heads.rows(), Drawn(pairOf("long", "short")).heads.rows());
}

TEST(PanelHeads, SayWhichMotionHasDiverged) {
  const scene::Scene scene =
      pairOf("bursts", "goes on",
             {"panel.0.simulation.model=particles", "panel.0.simulation.integrator=euler",
              "panel.0.simulation.normalize=false", "panel.0.simulation.damping=0",
              "panel.0.simulation.substeps=8"});
  std::vector<physics::Trajectory> motions = simulated(scene);
  ASSERT_TRUE(motions[0].divergedAt);
  ASSERT_FALSE(motions[1].divergedAt);
  PanelHeads heads(scene, motions, cellsOf(scene));
  const auto textsAt = [&](std::int64_t frame) {
    image::Image picture = testing::plainPicture(scene, 17);
    heads.draw(frame, picture);
    EXPECT_EQ(testing::meeting(heads.texts()), "");
    return heads.texts();
  };
  const auto last = static_cast<std::int64_t>(motions[0].samples.size()) - 1;
  EXPECT_EQ(textsAt(last).size(), 4U);
  const std::vector<Box> texts = textsAt(last + 1);
  ASSERT_EQ(texts.size(), 5U);
  EXPECT_LT(texts[2].right(), 640);
  EXPECT_LE(texts[2].bottom(), heads.rows());
}

TEST(PanelHeads, OfATextlessSceneAreEmpty) {
  scene::Scene scene = pairOf("a", "b");
  scene.textless = true;
  const Drawn drawn(scene);
  EXPECT_EQ(drawn.heads.rows(), 0);
  EXPECT_EQ(drawn.picture, testing::plainPicture(scene, 17));
}

/// Panels of a picture, `across` beside each other.
PanelCells cellsOf(const scene::Scene& scene, int across) {
  const int count = static_cast<int>(scene.motions.size()), down = (count + across - 1) / across;
  PanelCells cells{.width = scene.clip.width / across,
                   .height = scene.clip.height / down,
                   .letters = 0.028 * std::min(scene.clip.width, scene.clip.height)};
  for (int i = 0; i < count; ++i)
    cells.corners.emplace_back(i % across * cells.width, i / across * cells.height);
  return cells;
}

scene::Scene several(const std::vector<std::string>& labels, const std::string& size) {
  scene::Scene scene = pairOf("a", "b", {"clip.size=" + size, "clip.duration=1"});
  const scene::Panel panel = scene.motions[0];
  scene.motions.clear();
  for (const std::string& label : labels) {
    scene.motions.push_back(panel);
    scene.motions.back().label = label;
  }
  return scene;
}

/// Returns how many texts two, four and six panels have in a picture of that size, none of which
/// may lie on the pictures below the heads, before and after a divergence.
std::vector<std::size_t> textsInTheirHeads(const std::string& label, const std::string& size) {
  std::vector<std::size_t> counts;
  std::vector<std::string> labels;
  for (const int across : {1, 2, 3}) {
    for (int i = 0; i < 2; ++i) labels.push_back(label + " " + std::to_string(labels.size()));
    const scene::Scene scene = several(labels, size);
    std::vector<physics::Trajectory> motions = simulated(scene);
    motions.front().divergedAt = 0.5;
    const PanelCells cells = cellsOf(scene, across);
    PanelHeads heads(scene, motions, cells);
    EXPECT_LE(heads.rows(), cells.height / 2);
    for (const int frame : {0, 29, 30}) {
      SCOPED_TRACE(size + " " + std::to_string(labels.size()) + " " + std::to_string(frame));
      image::Image picture = testing::plainPicture(scene, 17);
      heads.draw(frame, picture);
      EXPECT_EQ(testing::meeting(heads.texts()), "");
      const int end = cells.height * (static_cast<int>(labels.size()) / across);
      for (int y = 0; y < end; ++y) {
        EXPECT_TRUE(y % cells.height < heads.rows() || isPlain(picture, y)) << "row " << y;
      }
      if (frame == 30) counts.push_back(heads.texts().size());
    }
  }
  return counts;
}

TEST(PanelHeads, NeverLieOnPictures) {
  const std::string longer = "explicit gyroscopic torque, 240 Hz";
  for (const char* size : {"[64, 36]", "[160, 90]", "[320, 180]", "[426, 240]", "[640, 360]",
                           "[240, 426]", "[1280, 720]"}) {
    textsInTheirHeads("rk4", size);
    if (std::string(size) != "[240, 426]") textsInTheirHeads(longer, size);
  }
  // Labels, counts and the notice, which may be in the place of its panel's count
  EXPECT_THAT(textsInTheirHeads("rk4", "[320, 180]"), ElementsAre(5, 8, 12));
  EXPECT_THAT(textsInTheirHeads(longer, "[320, 180]"), ElementsAre(4, 8, 12));
  EXPECT_THAT(textsInTheirHeads("rk4", "[160, 90]"), ElementsAre(4, 8, 6)) << "labels alone";
  EXPECT_THAT(textsInTheirHeads(longer, "[64, 36]"), ElementsAre(0, 0, 0));
}

TEST(PanelHeads, LeaveOutLabelsThatHaveNoRoomAlone) {
  std::string endless;
  for (int i = 0; i < 20; ++i) endless += "label ";
  const scene::Scene scene = several({endless, "short", "brief", "rk4"}, "[160, 90]");
  const std::vector<physics::Trajectory> motions = simulated(scene);
  PanelHeads heads(scene, motions, cellsOf(scene, 2));
  image::Image picture = testing::plainPicture(scene, 17);
  heads.draw(0, picture);
  EXPECT_EQ(heads.texts().size(), 3U);
}

TEST(PanelHeads, OfAGridHaveNoLabels) {
  scene::Scene scene = several({"1", "2", "3", "4"}, "[640, 360]");
  scene.grid.emplace();
  std::vector<physics::Trajectory> motions = simulated(scene);
  motions.back().divergedAt = 0.5;
  PanelCells cells = cellsOf(scene, 2);
  const auto textsAt = [&](int frame) {
    PanelHeads heads(scene, motions, cells);
    image::Image picture = testing::plainPicture(scene, 17);
    heads.draw(frame, picture);
    return heads.texts().size();
  };
  EXPECT_EQ(textsAt(0), 4U);
  EXPECT_EQ(textsAt(30), 5U);
  cells.width = 80;  // The notice is in place of its count
  cells.height = 60;
  EXPECT_EQ(textsAt(30), 4U);
  cells.height = 16;
  EXPECT_EQ(textsAt(30), 0U);
}

TEST(PanelHeads, BeginAtTheRightInScriptsThatAreReadFromThere) {
  for (const std::string label : {"ציר ראשון", "المحور الأول"}) {
    const Drawn drawn(pairOf(label, label + " 2", {"overlay.font='DejaVu Sans'"}));
    const std::vector<Box>& texts = drawn.heads.texts();
    ASSERT_EQ(texts.size(), 4U);
    EXPECT_GT(texts[0].right(), 600);
    EXPECT_LT(texts[0].right(), 640);
    EXPECT_LT(texts[1].right(), texts[0].x);
    EXPECT_GE(testing::contrastOf(texts[0], drawn.picture), 4.5)
        << "nothing is written";  // measured 17.3
  }
}

std::string refusalOf(const std::string& label, const std::string& size, int height = 0) {
  try {
    scene::Scene scene = pairOf("a", "b", {"clip.size=" + size});
    scene.motions[1].label = label;
    const std::vector<physics::Trajectory> motions = simulated(scene);
    PanelCells cells = cellsOf(scene);
    if (height > 0) cells.height = height;
    const PanelHeads heads(scene, motions, cells);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(PanelHeads, RefuseALabelThatTakesTooMuch) {
  std::string endless;
  for (int i = 0; i < 200; ++i) endless += "label ";
  EXPECT_EQ(
      refusalOf("a label of two lines in this panel if it is as narrow as that", "[640, 720]"),
      "no error");
  EXPECT_MESSAGE(refusalOf(endless, "[640, 720]"));
  EXPECT_MESSAGE(refusalOf(endless, "[640, 720]"));
  EXPECT_EQ(refusalOf(endless, "[320, 180]"), "no error");  // For a quick look only.
}

TEST(PanelHeads, RefuseWordsThatTakeHalfOfAPanel) {
  const std::string label = "a label of two lines, with a count below";
  EXPECT_EQ(refusalOf(label, "[400, 360]"), "no error");
  EXPECT_MESSAGE(refusalOf(label, "[400, 360]", 80));
}

}  // namespace
}  // namespace rotatebook::overlay
