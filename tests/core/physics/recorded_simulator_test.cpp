#include "physics/recorded_simulator.h"

#include <memory>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "base/error.h"
#include "physics/make_simulator.h"
#include "physics/motion_start.h"
#include "physics/simulate.h"
#include "recording/recorded_motion.h"

namespace rotatebook::physics {
namespace {

constexpr double kRecordedFrame = 1.0 / 60;  // [s]
constexpr int kRecordedFrames = 120;

MotionSettings tossedBook() {
  MotionSettings settings;
  settings.initial.value = {6, 0.1, 0.2};
  settings.simulation.model = Model::Exact;
  return settings;
}

/// The exact motion of `settings`, recorded every `interval`. [s]
MotionSettings recordingOf(MotionSettings settings, double interval, double duration) {
  const NudgedRotation exact = exactRotation(settings);
  std::vector<recording::RecordedMoment> moments;
  for (int i = 0; i * interval < duration + interval; ++i) {
    const double time = i * interval;
    moments.push_back({time, Eigen::Quaterniond(exact.at(time).worldFromBody),
                       exact.angularVelocityBodyAt(time)});
  }
  settings.simulation.model = Model::Recorded;
  settings.simulation.recorded.motion =
      std::make_shared<recording::RecordedMotion>(std::move(moments));
  return settings;
}

TEST(RecordedSimulator, ShowsTheExactMotionThatWasRecorded) {
  const Trajectory exact = simulate(tossedBook(), kRecordedFrames);
  // At other times than the frames'
  const Trajectory again = simulate(recordingOf(tossedBook(), 1.0 / 97, 2), kRecordedFrames);
  ASSERT_EQ(again.samples.size(), exact.samples.size());
  for (std::size_t i = 0; i < exact.samples.size(); ++i) {
    const Sample &a = exact.samples[i], &b = again.samples[i];
    EXPECT_LT(b.errorDeg, 1e-4);  // measured 3e-6
    EXPECT_NEAR(b.total() / a.total(), 1, 1e-6);
    EXPECT_LT((b.angularMomentum - a.angularMomentum).norm() / a.angularMomentum.norm(), 1e-6);
    EXPECT_EQ(b.regime, a.regime);
    EXPECT_EQ(b.halfTurns, a.halfTurns);
    EXPECT_NEAR(b.stretchMin, 1, 1e-12);
  }
}

TEST(RecordedSimulator, IsTheMomentItselfAtItsTime) {
  const Trajectory again = simulate(recordingOf(tossedBook(), kRecordedFrame, 2), kRecordedFrames);
  for (const Sample& sample : again.samples) EXPECT_LT(sample.errorDeg, 1e-10);  // measured 1e-12
}

TEST(RecordedSimulator, EndsWithItsRecording) {
  const MotionSettings settings = recordingOf(tossedBook(), 0.1, 1);
  const double duration = settings.simulation.recorded.motion->duration();
  Simulation simulation(settings);
  EXPECT_TRUE(simulation.sample(duration));
  EXPECT_THROW(simulation.sample(duration + 0.1), InputError);
}

TEST(RecordedSimulator, NeedsARecordingThatIsRead) {
  MotionSettings settings = tossedBook();
  settings.simulation.model = Model::Recorded;
  settings.simulation.recorded.file = "t.csv";
  try {
    makeSimulator(settings);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(),
                 "the model \"recorded\" has no recording: the file \"t.csv\" hasn't been read");
  }
}

}  // namespace
}  // namespace rotatebook::physics
