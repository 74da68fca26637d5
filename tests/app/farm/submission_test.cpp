#include "farm/submission.h"

#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "farm/fake_slurm.h"
#include "messages.h"

namespace rotatebook::farm {
namespace {

namespace fs = std::filesystem;
using ::testing::Contains;
using ::testing::ElementsAre;
using testing::emptyFolder;
using testing::FakeSlurm;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::leaveClip;
using testing::leaveFrames;
using testing::planOfClips;
using testing::planOfStudy;
using testing::textIn;

/// A plan of one clip, and a cluster.
class Submissions : public ::testing::Test {
 protected:
  Submission send() {
    return submit(continued(plan, files).value_or(StoredPlan{plan}), files, {}, {});
  }
  std::string messageOfSending() {
    try {
      send();
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  }

  fs::path folder = emptyFolder();
  FakeSlurm slurm{folder / "bin"};
  Plan plan = planOfClips(folder / "out", {"a"});
  PlanFiles files = planFiles(plan.folder, plan.work);
};

TEST_F(Submissions, AreAnArrayAndAJoin) {
  const Submission sent = send();
  EXPECT_THAT(sent.sent, ElementsAre(1, 2, 3, 4, 5));
  EXPECT_EQ(sent.array, "101");
  EXPECT_EQ(sent.join, "102");
  EXPECT_THAT(slurm.calls(), ElementsAre("sbatch --parsable part.sh",
                                         "sbatch --parsable --dependency=afterany:101 join.sh"));
  EXPECT_THAT(textIn(files.partScript), HasSubstr("--array=1-5\n"));
  const StoredPlan stored = *readPlan(files);
  EXPECT_THAT(stored.jobs.arrays, ElementsAre("101"));
  EXPECT_EQ(stored.jobs.join, "102");
}

TEST_F(Submissions, SendOnlyWhatIsMissing) {
  leaveFrames(plan, {0, 1, 4, 5, 6});  // parts 1 and 3 of two frames each
  const Submission sent = send();
  EXPECT_THAT(sent.sent, ElementsAre(2, 4, 5));
  EXPECT_EQ(sent.done, 2);
  EXPECT_THAT(textIn(files.partScript), HasSubstr("--array=2,4-5\n"));
}

TEST_F(Submissions, SendNothingThatIsOnItsWay) {
  send();
  slurm.setQueue(
      "101|1|RUNNING|0:09|n1|None\n101|2|PENDING|0:00||Priority\n101|3|PENDING|0:00||x\n"
      "101|4|PENDING|0:00||x\n101|5|PENDING|0:00||x\n102|N/A|PENDING|0:00||Dependency\n");
  const std::size_t before = slurm.calls().size();
  const Submission again = send();
  EXPECT_THAT(again.sent, IsEmpty());
  EXPECT_EQ(again.queued, 5);
  EXPECT_EQ(again.array + again.join, "");
  for (std::size_t i = before; i < slurm.calls().size(); ++i)
    EXPECT_THAT(slurm.calls()[i], ::testing::StartsWith("squeue"));
}

TEST_F(Submissions, SendAFailedTaskAgainWhileOthersRun) {
  send();
  slurm.setQueue(
      "101|1|RUNNING|0:09|n1|None\n101|2|FAILED|0:01|n2|NonZeroExitCode\n"
      "101|3|RUNNING|0:09|n3|None\n101|4|RUNNING|0:09|n4|None\n"
      "101|5|PENDING|0:00||Resources\n102|N/A|PENDING|0:00||Dependency\n");
  const Submission again = send();
  EXPECT_THAT(again.sent, ElementsAre(2));
  EXPECT_EQ(again.queued, 4);
  // A new join waits for both arrays, in the place of the old one.
  EXPECT_THAT(slurm.calls(), Contains("sbatch --parsable --dependency=afterany:101:103 join.sh"));
  EXPECT_EQ(slurm.calls().back(), "scancel 102");
  EXPECT_THAT(readPlan(files)->jobs.arrays, ElementsAre("101", "103"));
}

// A cluster gives a task up whose node it lost five times: without an end, as long as it is held.
TEST_F(Submissions, SendWhatTheClusterHoldsAgain) {
  send();
  slurm.setQueue(
      "101|1|RUNNING|0:09|n1|None\n101|2|REQUEUE_HOLD|0:00||JobHoldMaxRequeue\n"
      "101|3|PENDING|0:00||launch failed requeued held\n101|4|RUNNING|0:09|n4|None\n"
      "101|5|PENDING|0:00||Resources\n102|N/A|PENDING|0:00||Dependency\n");
  const Submission again = send();
  EXPECT_THAT(again.sent, ElementsAre(2, 3));
  EXPECT_EQ(again.queued, 3);
  EXPECT_THAT(slurm.calls(), Contains("sbatch --parsable --dependency=afterany:101:103 join.sh"));
  EXPECT_EQ(slurm.calls().back(), "scancel 102 101_2 101_3");
}

TEST_F(Submissions, CancelWhatIsHeldThoughAnotherTryMadeItsResults) {
  send();
  leaveFrames(plan, {0, 1, 2, 3, 4, 5, 6, 7, 8, 9});
  slurm.setQueue("101|2|REQUEUE_HOLD|0:00||JobHoldMaxRequeue\n102|N/A|PENDING|0:00||Dependency\n");
  EXPECT_THAT(send().sent, IsEmpty());
  EXPECT_EQ(slurm.calls().back(), "scancel 101_2") << "for which the join waits";
}

TEST_F(Submissions, ReplaceAJoinThatIsHeld) {
  send();
  leaveFrames(plan, {0, 1, 2, 3, 4, 5, 6, 7, 8, 9});
  slurm.setQueue("102|N/A|REQUEUE_HOLD|0:00||JobHoldMaxRequeue\n");
  EXPECT_EQ(send().join, "103");
  EXPECT_EQ(slurm.calls().back(), "scancel 102");
}

TEST_F(Submissions, SayIfWhatIsHeldCannotBeCancelled) {
  send();
  slurm.setQueue("101|2|REQUEUE_HOLD|0:00||JobHoldMaxRequeue\n");
  slurm.fail("scancel", "scancel: error: Kill job error on job id 101_2");
  EXPECT_MESSAGE(messageOfSending());
}

TEST_F(Submissions, LeaveTheRestToAJoinThatRuns) {
  send();
  slurm.setQueue("101|2|FAILED|0:01|n2|NonZeroExitCode\n102|N/A|RUNNING|0:04|n1|None\n");
  const Submission again = send();
  EXPECT_THAT(again.sent, IsEmpty());
  EXPECT_EQ(again.join, "");
}

TEST_F(Submissions, LeaveNoWholeClipToAJoinThatRuns) {
  plan = planOfClips(folder / "out", {"a", "b"});
  plan.scenes[1].parts = 1;
  EXPECT_THAT(send().sent, ElementsAre(1, 2, 3, 4, 5, 6));
  slurm.setQueue("101|6|FAILED|0:01|n2|NonZeroExitCode\n102|N/A|RUNNING|0:04|n1|None\n");
  const Submission again = send();
  EXPECT_THAT(again.sent, ElementsAre(6));
  EXPECT_EQ(again.queued, 5);
  EXPECT_EQ(again.join, "") << "the one that runs goes on";
  EXPECT_EQ(slurm.calls().back(), "sbatch --parsable part.sh");
  EXPECT_EQ(readPlan(files)->jobs.join, "102");
}

TEST_F(Submissions, JoinNothingOnceItIsJoined) {
  plan = planOfClips(folder / "out", {"a", "b"});
  plan.scenes[1].parts = 1;
  leaveClip(plan);
  const Submission sent = send();
  EXPECT_THAT(sent.sent, ElementsAre(6));
  EXPECT_EQ(sent.join, "");
}

TEST_F(Submissions, OnlyJoinWhatIsThere) {
  leaveFrames(plan, {0, 1, 2, 3, 4, 5, 6, 7, 8, 9});
  const Submission sent = send();
  EXPECT_EQ(sent.array, "");
  EXPECT_EQ(sent.join, "101");
  EXPECT_THAT(slurm.calls(), ElementsAre("sbatch --parsable join.sh"));
}

TEST_F(Submissions, RepairTheirCommands) {
  send();
  const std::string tasks = textIn(files.tasks), join = textIn(files.join);
  fs::remove(files.tasks);
  std::ofstream(files.join) << "something else\n";
  send();
  EXPECT_EQ(textIn(files.tasks), tasks);
  EXPECT_EQ(textIn(files.join), join);
}

TEST_F(Submissions, SendNoStudyAgainWhoseCommandIsRepaired) {
  plan = planOfStudy(folder / "out");
  files = planFiles(plan.folder, plan.work);
  send();
  for (const fs::path& output : plan.scenes[0].outputs) std::ofstream(output) << "x";
  fs::remove(files.tasks);
  EXPECT_TRUE(send().isWhole);
}

TEST_F(Submissions, SendNothingIfAllIsThere) {
  leaveClip(plan);
  EXPECT_TRUE(send().isWhole);
  EXPECT_THAT(slurm.calls(), IsEmpty());
}

TEST_F(Submissions, AreCancelledIfTheJoinIsRefused) {
  slurm.fail("sbatch", "sbatch: error: QOSMaxSubmitJobPerUserLimit", 2);
  EXPECT_MESSAGE(messageOfSending());
  EXPECT_EQ(slurm.calls().back(), "scancel 101");
}

TEST_F(Submissions, ListWhatCannotBeCancelled) {
  slurm.fail("sbatch", "sbatch: error: no", 2);
  slurm.fail("scancel", "scancel: error: Kill job error on job id 101");
  EXPECT_MESSAGE(messageOfSending());
}

TEST_F(Submissions, SendNothingIfTheArrayIsRefused) {
  slurm.fail("sbatch", "sbatch: error: Invalid qos specification");
  EXPECT_MESSAGE(messageOfSending());
  EXPECT_THAT(slurm.calls(), ElementsAre("sbatch --parsable part.sh"));
  slurm.fail("sbatch", "", 99);
  EXPECT_EQ(send().sent.size(), 5U) << "and nothing of it is left";
}

TEST_F(Submissions, RefuseASceneThatChangedWhileItsJobsAreThere) {
  send();
  slurm.setQueue("101|1|RUNNING|0:09|n1|None\n102|N/A|PENDING|0:00||Dependency\n");
  plan.scenes[0].checksum = "changed";
  EXPECT_MESSAGE(messageOfSending());
  slurm.setQueue("101|1|REQUEUE_HOLD|0:00||JobHoldMaxRequeue\n");
  EXPECT_MESSAGE(messageOfSending());
  slurm.setQueue("");
  EXPECT_EQ(messageOfSending(), "") << "nothing of the earlier plan is left";
  EXPECT_EQ(readPlan(files)->plan, plan);
}

TEST_F(Submissions, RefuseASceneThatChangedOverItsFrames) {
  leaveFrames(plan, {0, 1});
  plan.scenes[0].checksum = "changed";
  EXPECT_MESSAGE(messageOfSending());
  EXPECT_THAT(slurm.calls(), IsEmpty());
  EXPECT_FALSE(fs::exists(files.folder));
}

TEST_F(Submissions, KeepTheirPartsIfTheRateIsMeasuredAnew) {
  send();
  Plan anew = plan;
  anew.scenes[0].parts = 2;
  EXPECT_EQ(continued(anew, files)->plan.scenes[0].parts, 5);
}

TEST_F(Submissions, OfStudiesNeedNoJoin) {
  plan = planOfStudy(folder / "out");
  files = planFiles(plan.folder, plan.work);
  EXPECT_EQ(send().join, "");
  EXPECT_THAT(slurm.calls(), ElementsAre("sbatch --parsable part.sh"));
}

}  // namespace
}  // namespace rotatebook::farm
