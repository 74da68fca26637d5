#include "overlay/motion_overlays.h"

#include <algorithm>
#include <optional>
#include <string>

#include <gtest/gtest.h>

#include "base/error.h"
#include "overlay/drawn_overlay.h"
#include "overlay/motion.h"

namespace rotatebook::overlay {
namespace {

using testing::diverging;
using testing::drawn;
using testing::greyPicture;
using testing::motionOf;
using testing::overlaysOf;
using testing::tumbling;

constexpr const char* kSmall = "clip.size=[320, 180]";

/// The first frame after a half-turn.
std::int64_t firstTurn(const physics::Trajectory& trajectory) {
  const auto& samples = trajectory.samples;
  const auto turned = std::ranges::find_if(
      samples, [](const physics::Sample& sample) { return sample.halfTurns == 1; });
  return turned - samples.begin();
}

TEST(MotionOverlays, LeaveThePictureAloneIfNothingIsShown) {
  const scene::Scene scene = tumbling({kSmall});
  EXPECT_EQ(drawn(scene, 3), greyPicture(scene));
  const physics::Trajectory trajectory = motionOf(scene);
  EXPECT_EQ(overlaysOf(scene, trajectory).bottomRows(), 0);
}

TEST(MotionOverlays, OfATextlessSceneAreOnTheBodyAlone) {
  const auto textsOf = [](scene::Scene scene, bool textless) {
    scene.textless = textless;
    const physics::Trajectory trajectory = motionOf(scene);
    MotionOverlays overlays = overlaysOf(scene, trajectory);
    const auto last = static_cast<std::int64_t>(trajectory.samples.size());
    EXPECT_NE(drawn(overlays, scene, last), greyPicture(scene));
    EXPECT_EQ(overlays.bottomRows() > 0, !textless);
    return overlays.texts().size();
  };
  const scene::Scene scene =
      diverging({kSmall, "overlay.show=[" + testing::namesOfMotionOverlays() + "]"});
  EXPECT_GE(textsOf(scene, false), 8U);  // measured 19
  EXPECT_EQ(textsOf(scene, true), 0U);
}

TEST(MotionOverlays, CountHalfTurnsAndLightUpWhenOneIsMade) {
  const scene::Scene scene = tumbling({kSmall, "overlay.show=['half_turns']"});
  const physics::Trajectory trajectory = motionOf(scene);
  MotionOverlays overlays = overlaysOf(scene, trajectory);
  const std::int64_t turn = firstTurn(trajectory);
  ASSERT_GT(turn, 40);
  EXPECT_EQ(drawn(overlays, scene, 0), drawn(overlays, scene, turn - 1));
  EXPECT_NE(drawn(overlays, scene, turn - 1), drawn(overlays, scene, turn));
  EXPECT_NE(drawn(overlays, scene, turn), drawn(overlays, scene, turn + 10));
  EXPECT_EQ(drawn(overlays, scene, turn + 25), drawn(overlays, scene, turn + 30));
}

TEST(MotionOverlays, SayThatAMotionDivergedOnlyPastItsEnd) {
  const scene::Scene scene = diverging({kSmall});
  const physics::Trajectory trajectory = motionOf(scene);
  ASSERT_TRUE(trajectory.divergedAt);
  const auto last = static_cast<std::int64_t>(trajectory.samples.size()) - 1;
  MotionOverlays overlays = overlaysOf(scene, trajectory);
  EXPECT_EQ(drawn(overlays, scene, last), greyPicture(scene));
  EXPECT_TRUE(overlays.texts().empty());
  EXPECT_NE(drawn(overlays, scene, last + 1), greyPicture(scene));
  EXPECT_EQ(overlays.texts().size(), 1U);
  EXPECT_EQ(drawn(overlays, scene, last + 1), drawn(overlays, scene, last + 9));
}

TEST(MotionOverlays, AreOfThisMotion) {
  // Each shows the sample that is drawn.
  for (const char* name : {"axes", "omega", "momentum", "trail", "polhode", "energy",
                           "energy_ladder", "error", "ghost", "poinsot"}) {
    const scene::Scene scene = tumbling(
        {kSmall, "overlay.show=['" + std::string(name) + "']", "simulation.integrator=euler"});
    const physics::Trajectory trajectory = motionOf(scene);
    MotionOverlays overlays = overlaysOf(scene, trajectory);
    EXPECT_NE(drawn(overlays, scene, 60), greyPicture(scene)) << name;
    EXPECT_NE(drawn(overlays, scene, 60), drawn(overlays, scene, 100)) << name;
    EXPECT_EQ(drawn(overlays, scene, 60), drawn(overlays, scene, 60)) << name;
  }
}

TEST(MotionOverlays, HaveAGhostThatNoIntegratorMoves) {
  const auto shown = [](const char* overlay, const char* integrator) {
    return drawn(tumbling({kSmall, "overlay.show=['" + std::string(overlay) + "']",
                           "simulation.integrator='" + std::string(integrator) + "'"}),
                 120);
  };
  EXPECT_EQ(shown("ghost", "rk4"), shown("ghost", "euler"));
  EXPECT_NE(shown("omega", "rk4"), shown("omega", "euler"));
  EXPECT_NE(shown("error", "rk4"), shown("error", "euler"));
  EXPECT_NE(shown("energy", "rk4"), shown("energy", "euler"));
}

TEST(MotionOverlays, LeaveOutWhatTheModelHasNot) {
  scene::Scene scene = tumbling({kSmall});
  scene.motions[0].simulation.model = physics::Model::Exact;
  scene.overlay.show = {scene::Overlay::Springs, scene::Overlay::Error, scene::Overlay::Ghost};
  EXPECT_EQ(drawn(scene, 30), greyPicture(scene));
}

TEST(MotionOverlays, TurnWithTheCamerasFrame) {
  const auto shown = [](const char* overlay, const char* frame, std::int64_t n) {
    return drawn(tumbling({kSmall, "overlay.show=['" + std::string(overlay) + "']",
                           "camera.frame='" + std::string(frame) + "'"}),
                 n);
  };
  // The body's axes stand still in the body's frame, the momentum in its own.
  EXPECT_EQ(shown("axes", "body", 0), shown("axes", "body", 100));
  EXPECT_NE(shown("axes", "world", 0), shown("axes", "world", 100));
  EXPECT_NE(shown("momentum", "body", 0), shown("momentum", "body", 100));
  EXPECT_NE(shown("momentum", "world", 0), shown("momentum", "momentum", 0));
  EXPECT_NE(shown("trail", "world", 100), shown("trail", "body", 100));
}

TEST(MotionOverlays, CanBeDrawnOnTheSmallestPictures) {
  const std::string all = "overlay.show=[" + testing::namesOfMotionOverlays() + "]";
  for (const char* size : {"[16, 16]", "[64, 36]", "[16, 400]", "[400, 16]"}) {
    const scene::Scene scene = diverging({all, "clip.size=" + std::string(size)});
    const physics::Trajectory trajectory = motionOf(scene);
    MotionOverlays overlays = overlaysOf(scene, trajectory);
    EXPECT_LE(overlays.bottomRows(), 2 * scene.clip.height / 3) << size;
    EXPECT_NO_THROW(drawn(overlays, scene, 3)) << size;
    EXPECT_NO_THROW(drawn(overlays, scene, scene.clip.frameCount())) << size;
  }
}

TEST(MotionOverlays, NameForcesWhereTheNamesLeaveRoomForTheBody) {
  const auto texts = [](const char* size) {
    const scene::Scene scene = testing::tumbling(
        {"overlay.show=['forces']", "camera.frame='turning'", std::string("clip.size=") + size});
    const physics::Trajectory trajectory = testing::motionOf(scene);
    MotionOverlays overlays = testing::overlaysOf(scene, trajectory);
    testing::drawn(overlays, scene, 0);
    return overlays.texts().size();
  };
  EXPECT_EQ(texts("[640, 360]"), 4);  // three names and the scale
  EXPECT_EQ(texts("[180, 160]"), 1);  // the scale
}

TEST(MotionOverlays, DrawTheEnergyOnTheScaleOfThoseBesideThem) {
  const scene::Scene scene = tumbling({"overlay.show=['energy']", "clip.size=[640, 360]"});
  const physics::Trajectory calm = motionOf(scene), wild = motionOf(diverging());
  EXPECT_EQ(energyChartTop(calm), 1.15);
  EXPECT_EQ(energyChartTop(wild), 1.02 * 3);
  const auto shown = [&](double energyTop) {
    MotionOverlays overlays(scene, calm, {.width = 640, .height = 360, .energyTop = energyTop});
    return drawn(overlays, scene, 60);
  };
  EXPECT_EQ(shown(energyChartTop(calm)), shown(0));
  EXPECT_NE(shown(energyChartTop(wild)), shown(0));
}

// In whose middle is the body.
TEST(MotionOverlays, SayThatAMotionDivergedAtTheLeft) {
  const scene::Scene scene = diverging({"clip.size=[1280, 720]", "overlay.show=['half_turns']"});
  const physics::Trajectory trajectory = motionOf(scene);
  MotionOverlays overlays = overlaysOf(scene, trajectory);
  drawn(overlays, scene, scene.clip.frameCount());
  ASSERT_EQ(overlays.texts().size(), 2U);
  const Box& notice = overlays.texts().back();
  EXPECT_GE(notice.y, overlays.texts().front().bottom());
  EXPECT_LT(notice.x, 60);
  // A circle as wide as the picture is high, about its middle.
  EXPECT_GT((Point(notice.right(), notice.bottom()) - Point(640, 360)).norm(),
            360);  // measured 461
}

TEST(MotionOverlays, ShowWordsThatAreReadFromTheRight) {
  for (const std::string word : {"תנועה", "حركة"}) {
    std::string words;
    for (const char* english :
         {"Flips", "Energy", "kinetic", "Error", "Polhode", "\"Diverged at\""})
      words += (words.empty() ? "" : ", ") + std::string(english) + " = '" + word + "'";
    const scene::Scene scene = diverging(
        {"clip.size=[1280, 720]", "overlay.font='DejaVu Sans'", "overlay.words={" + words + "}",
         "overlay.show=['half_turns', 'energy', 'error', 'polhode']"});
    const physics::Trajectory trajectory = motionOf(scene);
    MotionOverlays overlays = overlaysOf(scene, trajectory);
    const image::Image picture = drawn(overlays, scene, scene.clip.frameCount());
    EXPECT_GE(overlays.texts().size(), 8U);
    // measured 5.2 and more; 1 where nothing is written
    for (const Box& box : overlays.texts())
      EXPECT_GE(testing::contrastOf(box, picture), 1.5) << word << " at " << box.x << ", " << box.y;
  }
}

TEST(MotionOverlays, LeaveToAHeadWhatIsInIt) {
  const scene::Scene scene = diverging({"clip.size=[640, 360]", "overlay.show=['half_turns']"});
  const physics::Trajectory trajectory = motionOf(scene);
  MotionOverlays overlays(scene, trajectory, {.width = 640, .height = 360, .hasHead = true});
  EXPECT_EQ(drawn(overlays, scene, scene.clip.frameCount()), greyPicture(scene));
}

TEST(OverlayList, HasAFactoryForEachOverlayOfOneMotion) {
  const Typesetter type;
  for (const scene::OverlayRow& row : scene::kOverlayRows) {
    const bool isRigid = row.models == scene::OverlayModels::Rigid;
    const scene::Scene scene = isRigid ? tumbling({kSmall}) : diverging({kSmall});
    const physics::Trajectory trajectory = motionOf(scene);
    const OverlayContext context{scene, trajectory, type, Scale(320, 180)};
    ASSERT_TRUE(isFor(scene.motions[0].simulation, row.overlay)) << row.name;
    EXPECT_EQ(makeOverlay(row.overlay, context, {0, 0, 80, 60}) == nullptr,
              row.placement == scene::Placement::WholeClip)
        << row.name;
  }
}

TEST(OverlayList, IsInDrawingOrder) {
  // Where they meet, later ones hide earlier ones.
  EXPECT_LT(scene::Overlay::Springs, scene::Overlay::Ghost);
  EXPECT_LT(scene::Overlay::Ghost, scene::Overlay::Axes);
  EXPECT_LT(scene::Overlay::Axes, scene::Overlay::Trail);
  EXPECT_LT(scene::Overlay::Trail, scene::Overlay::Momentum);
  EXPECT_LT(scene::Overlay::Momentum, scene::Overlay::Omega);
}

}  // namespace
}  // namespace rotatebook::overlay
