#include "farm/status.h"

#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "farm/fake_slurm.h"
#include "farm/plan_folder.h"
#include "messages.h"

namespace rotatebook::farm {
namespace {

namespace fs = std::filesystem;
using testing::emptyFolder;
using testing::FakeSlurm;
using ::testing::HasSubstr;
using testing::leaveClip;
using testing::leaveFrames;
using testing::planOfClips;
using Kind = TaskState::Kind;

/// A clip of five tasks, which was sent as the jobs 101 and 102.
class Status : public ::testing::Test {
 protected:
  Status() { writeNewPlan(files, stored); }
  PlanState state() const { return statesBelow(stored.plan.folder).front(); }

  fs::path folder = emptyFolder();
  FakeSlurm slurm{folder / "bin"};
  StoredPlan stored{planOfClips(folder / "out", {"a"}), {{"101"}, "102"}};
  PlanFiles files = planFiles(stored.plan.folder, Work::Render);
};

TEST_F(Status, SaysWhatIsDoneAndWhoRunsWhat) {
  leaveFrames(stored.plan, {0, 1, 2});
  slurm.setQueue(
      "101|1|COMPLETED|0:20|n1|None\n101|2|RUNNING|0:30|n2|None\n101|3|RUNNING|0:10|n3|"
      "None\n101|4|PENDING|0:00||Resources\n101|5|PENDING|0:00||Resources\n102|N/A|"
      "PENDING|0:00||Dependency\n");
  std::ofstream(files.ends / "1") << "0 n1 20\n";
  const PlanState now = state();
  EXPECT_EQ(now.scenes.at(0).done, 3);
  EXPECT_EQ(now.scenes.at(0).units, 10);
  EXPECT_EQ(now.tasks.at(0).kind, Kind::Done);
  EXPECT_EQ(now.tasks.at(1).kind, Kind::Running);
  EXPECT_EQ(now.tasks.at(1).node, "n2");
  EXPECT_EQ(now.tasks.at(1).seconds, 30);
  EXPECT_EQ(now.tasks.at(3).kind, Kind::Waiting);
  EXPECT_EQ(now.tasks.at(3).reason, "Resources");
  EXPECT_EQ(now.join->kind, Kind::Waiting);
  EXPECT_FALSE(now.hasFailed());
  // 3 frames in 20 + 30 + 10 s; 7 are left to two tasks
  EXPECT_DOUBLE_EQ(now.remaining.value_or(0), 70);
}

TEST_F(Status, SaysWhyATaskFailed) {
  slurm.setQueue("101|2|FAILED|0:01|n2|NonZeroExitCode\n101|3|TIMEOUT|9:00|n3|TimeLimit\n");
  std::ofstream(files.ends / "2") << "2 n2 1\n";
  std::ofstream(files.logOf(2)) << "a: A\nrotatebook: the renderer differs\n";
  const PlanState now = state();
  EXPECT_TRUE(now.hasFailed());
  EXPECT_EQ(now.tasks.at(1).kind, Kind::Failed);
  EXPECT_EQ(now.tasks.at(1).node, "n2");
  EXPECT_EQ(now.tasks.at(1).reason, "exit status 2: rotatebook: the renderer differs");
  EXPECT_EQ(now.tasks.at(2).kind, Kind::Failed);
  EXPECT_THAT(now.tasks.at(2).reason, HasSubstr("TIMEOUT"));
  EXPECT_FALSE(now.remaining) << "nothing runs";
}

TEST_F(Status, SaysWhatTheClusterHolds) {
  slurm.setQueue(
      "101|2|REQUEUE_HOLD|0:00||JobHoldMaxRequeue\n101|3|PENDING|0:00||JobHeldUser\n"
      "101|4|PENDING|0:00||job requeued in held state\n"
      "102|N/A|PENDING|0:00||Dependency\n");
  const PlanState now = state();
  EXPECT_TRUE(now.hasFailed());
  EXPECT_EQ(now.tasks.at(1).kind, Kind::Failed);
  EXPECT_EQ(now.tasks.at(1).reason, "held by the cluster (JobHoldMaxRequeue), submit again");
  EXPECT_EQ(now.tasks.at(2).kind, Kind::Waiting) << "as its user wants";
  EXPECT_THAT(now.tasks.at(3).reason, HasSubstr("held by the cluster (job requeued in held"));
  EXPECT_EQ(now.join->kind, Kind::Waiting);
}

// What hasn't begun when an array is cancelled stays known as one job without a task's number.
TEST_F(Status, SaysThatTasksWereCancelledBeforeTheyBegan) {
  slurm.setQueue(
      "101|N/A|CANCELLED|0:00||Resources\n101|1|CANCELLED|0:01|n1|None\n102|N/A|FAILED|0:00||"
      "Dependency\n");
  const PlanState now = state();
  for (const TaskState& task : now.tasks) {
    EXPECT_EQ(task.kind, Kind::Failed);
    EXPECT_EQ(task.reason, "CANCELLED");
  }
  EXPECT_EQ(now.tasks.at(0).node, "n1");
  EXPECT_EQ(now.tasks.at(4).node, "");
  EXPECT_THAT(now.join->reason, HasSubstr("results aren't there"));
}

TEST_F(Status, KnowsFailuresThatTheClusterHasForgotten) {
  leaveFrames(stored.plan, {0, 1});
  slurm.fail("squeue", "slurm_load_jobs error: Invalid job id specified");
  const PlanState now = state();
  EXPECT_EQ(now.tasks.at(0).kind, Kind::Done);
  EXPECT_EQ(now.tasks.at(1).kind, Kind::Failed);
  EXPECT_EQ(now.join->kind, Kind::Failed);
  EXPECT_THAT(now.queueProblem, "");
}

TEST_F(Status, KnowsFailuresOfTasksThatTheClusterHasForgottenAlone) {
  slurm.setQueue("101|4|RUNNING|0:05|n4|None\n102|N/A|PENDING|0:00||Dependency\n");
  const PlanState now = state();
  EXPECT_EQ(now.tasks.at(0).kind, Kind::Failed);
  EXPECT_EQ(now.tasks.at(3).kind, Kind::Running);
  EXPECT_EQ(now.join->kind, Kind::Waiting);
}

TEST_F(Status, RefusesAFolderThatWasMoved) {
  fs::rename(stored.plan.folder, folder / "moved");
  try {
    statesBelow(folder / "moved");
    FAIL() << "not refused";
  } catch (const InputError& error) {
    EXPECT_MESSAGE(error.what());
  }
}

TEST_F(Status, IsDoneOnceTheClipIsWhole) {
  leaveClip(stored.plan);
  slurm.fail("squeue", "slurm_load_jobs error: Invalid job id specified");
  const PlanState now = state();
  EXPECT_TRUE(now.isWhole());
  EXPECT_FALSE(now.hasFailed());
  EXPECT_EQ(now.join->kind, Kind::Done);
}

TEST_F(Status, TakesTheLastTryOfATask) {
  slurm.setQueue("101|1|FAILED|0:01|n1|NonZeroExitCode\n103|1|RUNNING|0:05|n4|None\n");
  stored.jobs.arrays.push_back("103");
  writePlan(files, stored);
  EXPECT_EQ(state().tasks.at(0).kind, Kind::Running);
  EXPECT_EQ(state().tasks.at(0).node, "n4");
}

TEST_F(Status, SaysIfTheQueueIsNotKnown) {
  leaveFrames(stored.plan, {0, 1});
  slurm.fail("squeue", "slurm_load_jobs error: Unable to contact slurm controller");
  const PlanState now = state();
  EXPECT_THAT(now.queueProblem, HasSubstr("can't reach the cluster"));
  EXPECT_EQ(now.tasks.at(0).kind, Kind::Done);
  EXPECT_EQ(now.tasks.at(1).kind, Kind::Waiting) << "not known to have failed";
}

TEST_F(Status, NeedsAPlan) {
  EXPECT_THROW(statesBelow(folder / "elsewhere"), InputError);
}

}  // namespace
}  // namespace rotatebook::farm
