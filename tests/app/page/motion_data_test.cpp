#include "page/motion_data.h"

#include <limits>

#include <gtest/gtest.h>

namespace rotatebook::page {
namespace {

/// Two samples, the second with half the energy.
Motion motionOf(const std::string& label) {
  Motion motion;
  motion.panel.label = label;
  motion.trajectory.interval = 0.5;
  motion.trajectory.samples.resize(2);
  physics::Sample& first = motion.trajectory.samples[0];
  physics::Sample& second = motion.trajectory.samples[1];
  first.kinetic = 3;
  first.potential = 1;
  second.kinetic = 2;
  second.tiltDeg = 1.0 / 3;
  second.errorDeg = std::numeric_limits<double>::infinity();
  return motion;
}

TEST(MotionData, HoldsEachSampleOfEachMotion) {
  scene::Scene scene;
  scene.clip.frameRate = {30000, 1001};
  EXPECT_EQ(
      motionData({motionOf("a"), motionOf("<b>")}, scene, 7, ""),
      R"({"rate": [30000, 1001], "frames": 7, "interval": 0.5, "motions": [)"
      R"({"label": "a", "springs": false, "kinetic": [0.75,0.5], "potential": [0.25,0], )"
      R"("total": [1,0.5], "tilt": [0,0.333333], "error": [0,null]}, )"
      R"({"label": "\u003Cb>", "springs": false, "kinetic": [0.75,0.5], "potential": [0.25,0], )"
      R"("total": [1,0.5], "tilt": [0,0.333333], "error": [0,null]}]})");
}

TEST(MotionData, HoldsTheTimesOfFramesWhereTheSpeedChanges) {
  scene::Scene scene;
  scene.clip.frameRate = {2, 1};
  scene.clip.speed = scene::PlaybackSpeed{.stretches = {{0, 1, 0.5}}};
  const std::string data = motionData({motionOf("a")}, scene, 5, "");
  EXPECT_NE(data.find("\"times\": [0,0.25,0.523438,1,1.5]"), std::string::npos) << data;
}

TEST(MotionData, HoldsTheChecksumOfARecord) {
  EXPECT_NE(motionData({motionOf("a")}, {}, 2, "0f").find("\"checksum\": \"0f\""),
            std::string::npos);
}

TEST(MotionData, SaysWhetherThereAreSprings) {
  Motion motion = motionOf("");
  motion.panel.simulation.model = physics::Model::Particles;
  EXPECT_NE(motionData({motion}, {}, 2, "").find("\"springs\": true"), std::string::npos);
}

}  // namespace
}  // namespace rotatebook::page
