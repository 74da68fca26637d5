#include "farm/plan.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "farm/fake_slurm.h"

namespace rotatebook::farm {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using testing::planOfClips;
using testing::planOfStudy;

TEST(Plan, CountsTasksThroughAllScenes) {
  const Plan plan = planOfClips("/out", {"a", "b"});
  const std::vector<Task> tasks = tasksOf(plan);
  ASSERT_EQ(tasks.size(), 10U);
  EXPECT_EQ(tasks[6].number, 7);
  EXPECT_EQ(tasks[6].scene, 1U);
  EXPECT_EQ(tasks[6].part.number, 2);
  EXPECT_EQ(describe(plan, tasks[6]), "part 2/5 of b");
}

TEST(Plan, HasCommandsThatMayRunTwice) {
  Plan plan = planOfClips("/out", {"a"});
  plan.arguments = {"--set", "clip.duration=2"};
  plan.cores = 4;
  const std::vector<std::string> command = commandOf(plan, tasksOf(plan)[2]);
  EXPECT_THAT(command, ElementsAre("/opt/rotatebook", "render", "/scenes/a.toml", "--part", "3/5",
                                   "--resume", "-o", "/out", "--retry-status", "--scene-checksum",
                                   "sum-of-a", "--set", "clip.duration=2"));
  EXPECT_EQ(shellLine(plan, {"/opt/my book", "render"}), "LP_NUM_THREADS=4 '/opt/my book' render");
}

TEST(Plan, JoinsAllScenesInTheEnd) {
  Plan plan = planOfClips("/out", {"a", "b"});
  plan.joinArguments = {"--format", "gif"};
  EXPECT_THAT(joinCommandOf(plan),
              ElementsAre("/opt/rotatebook", "render", "/scenes/a.toml", "/scenes/b.toml",
                          "--resume", "-o", "/out", "--retry-status", "--scene-checksum",
                          "sum-of-a,sum-of-b", "--format", "gif"));
}

TEST(Plan, OfShortClipsMakesThemWholeWithoutAJoin) {
  Plan plan = planOfClips("/out", {"a", "b", "c"});
  EXPECT_FALSE(makesWholeClips(plan));
  for (PlannedScene& scene : plan.scenes) scene.parts = 1;
  plan.scenes[1].startsTask = false;
  plan.joinArguments = {"--format", "gif", "--no-png"};
  EXPECT_TRUE(makesWholeClips(plan));
  EXPECT_FALSE(leavesFrames(plan));
  EXPECT_EQ(countTasks(plan), 2);
  EXPECT_EQ(describe(plan, tasksOf(plan)[0]), "a and 1 more");
  EXPECT_THAT(commandOf(plan, tasksOf(plan)[0]),
              ElementsAre("/opt/rotatebook", "render", "/scenes/a.toml", "/scenes/b.toml",
                          "--resume", "-o", "/out", "--retry-status", "--scene-checksum",
                          "sum-of-a,sum-of-b", "--format", "gif", "--no-png", "--jobs", "1"));
  EXPECT_EQ(commandOf(plan, tasksOf(plan)[1])[2], "/scenes/c.toml");
  EXPECT_THAT(joinCommandOf(plan), IsEmpty());
}

TEST(Plan, OfAMapHasAThreadForEachCore) {
  Plan plan = planOfClips("/out", {"a"});
  plan.work = Work::Map;
  plan.cores = 3;
  const std::vector<std::string> command = commandOf(plan, tasksOf(plan)[0]);
  EXPECT_THAT(command, ::testing::IsSupersetOf({"map", "--threads", "3", "--part", "1/5"}));
  EXPECT_EQ(shellLine(plan, {"x"}), "x");
}

TEST(Plan, OfAStudyIsOneTaskWithoutAJoin) {
  const Plan plan = planOfStudy("/out");
  const std::vector<std::string> command = commandOf(plan, tasksOf(plan)[0]);
  EXPECT_THAT(command, ElementsAre("/opt/rotatebook", "study", "/scenes/law.toml", "-o", "/out",
                                   "--retry-status", "--scene-checksum", "sum-of-law"));
  EXPECT_THAT(joinCommandOf(plan), IsEmpty());
  EXPECT_EQ(describe(plan, tasksOf(plan)[0]), "law");
}

TEST(Plan, IsTheSameWorkInOtherParts) {
  const Plan plan = planOfClips("/out", {"a"});
  Plan other = plan;
  other.scenes[0].parts = 2;
  EXPECT_TRUE(isSameWork(plan, other));
  other.scenes[0].checksum = "changed";
  EXPECT_FALSE(isSameWork(plan, other));
  EXPECT_FALSE(isSameWork(plan, planOfClips("/out", {"a", "b"})));
  Plan rebuilt = plan;
  rebuilt.build = "b2";
  EXPECT_FALSE(isSameWork(plan, rebuilt));
}

}  // namespace
}  // namespace rotatebook::farm
