#include "timeline/clip_json.h"

#include <limits>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/json.h"

namespace rotatebook::timeline {
namespace {

using scene::Measure;
using ::testing::HasSubstr;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Two samples, the second with half the energy.
physics::Trajectory halving() {
  physics::Trajectory trajectory;
  trajectory.interval = 0.5;
  trajectory.samples.resize(2);
  physics::Sample& first = trajectory.samples[0];
  physics::Sample& second = trajectory.samples[1];
  first.kinetic = 3;
  first.potential = 1;
  second.time = 0.5;
  second.kinetic = 2;
  second.tiltDeg = 1.0 / 3;
  second.errorDeg = kInfinity;
  return trajectory;
}

std::string jsonOf(const scene::Scene& scene, std::size_t motions = 1) {
  const ClipMotion motion(std::vector<physics::Trajectory>(motions, halving()),
                          scene.clip.frameRate);
  return jsonText(clipJson(scene, motion, {{.motion = {}, .flips = {0.5}}}, {"c0ffee", "decade"}));
}

TEST(ClipJson, HoldsEachSampleOfEachMotion) {
  scene::Scene scene;
  scene.clip.frameRate = {30000, 1001};
  scene.motions.resize(2);
  scene.motions[0].label = "a";
  scene.motions[0].nudges.push_back({.at = 0.5});
  scene.motions[1].label = "<b>";
  const std::string json = jsonOf(scene, 2);
  EXPECT_TRUE(rotatebook::isResultOf("clip", json));
  EXPECT_THAT(json, HasSubstr(R"("scene_xxh128":"c0ffee","motion_xxh128":"decade",)"
                              R"("rate":[30000,1001],"frames":2,"motions":[{)"));
  EXPECT_THAT(json, HasSubstr(R"("flips_s":[0.5])"));  // As it is given, not computed again.
  EXPECT_THAT(
      json, HasSubstr(R"("plots":{"interval":0.5,"motions":[)"
                      R"({"label":"a","springs":false,"kinetic":[0.75,0.5],"potential":[0.25,0],)"
                      R"("total":[1,0.5],"tilt":[0,0.333333],"error":[0,null]},)"
                      R"({"label":"<b>","springs":false,"kinetic":[0.75,0.5],"potential":[0.25,0],)"
                      R"("total":[1,0.5],"tilt":[0,0.333333],"error":[0,null]}]})"));
  EXPECT_THAT(json, HasSubstr(R"("events":[{"frame":1,"time_s":0.5,"label":"a",)"));
}

TEST(ClipJson, HoldsTheTimesOfFramesWhereTheSpeedChanges) {
  scene::Scene scene;
  scene.clip.frameRate = {2, 1};
  scene.clip.speed = scene::PlaybackSpeed{.stretches = {{0, 0.5, 0.5}}};
  EXPECT_THAT(jsonOf(scene), HasSubstr("\"times\":[0,"));
}

TEST(ClipJson, SaysWhetherThereAreSprings) {
  scene::Scene scene;
  scene.motions[0].simulation.model = physics::Model::Particles;
  EXPECT_THAT(jsonOf(scene), HasSubstr("\"springs\":true"));
}

TEST(ExpectationJson, HoldsBoundsAndMeasuredValues) {
  EXPECT_EQ(jsonText(expectationJson(
                {{Measure::Stretch, 0.5, {}, 1.25, {}, 3, 4.5}, 0.1, 1.3, false, 4})),
            R"({"quantity":"stretch","from_s":3.0,"to_s":4.5,"min":0.5,"max":null,)"
            R"("rises_to":1.25,"falls_to":null,"lowest":0.1,"highest":1.3,"met":false,)"
            R"("ends_early_s":4.0})");
  EXPECT_EQ(jsonText(expectationJson(
                {{.measure = Measure::DivergesAt, .max = 2}, kInfinity, kInfinity, false})),
            R"({"quantity":"diverges_at","from_s":0.0,"to_s":null,"min":null,"max":2.0,)"
            R"("rises_to":null,"falls_to":null,"lowest":null,"highest":null,)"
            R"("met":false,"ends_early_s":null})");
}

}  // namespace
}  // namespace rotatebook::timeline
