#include "farm/plan.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "farm/fake_slurm.h"

namespace rotatebook::farm {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::EndsWith;
using ::testing::IsEmpty;
using ::testing::Not;
using testing::planOfClips;
using testing::planOfStudy;
using ::testing::StartsWith;

TEST(Plan, CountsTasksThroughAllScenes) {
  const Plan plan = planOfClips("/out", {"a", "b"});
  const std::vector<Task> tasks = tasksOf(plan);
  ASSERT_EQ(tasks.size(), 10U);
  EXPECT_EQ(tasks[6].number, 7);
  EXPECT_THAT(tasks[6].scenes, ElementsAre(1));
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
  plan.program = "/opt/my book";
  EXPECT_THAT(lineOf(plan, tasksOf(plan)[2]),
              StartsWith("LP_NUM_THREADS=4 '/opt/my book' render /scenes/a.toml --part 3/5"));
  EXPECT_THAT(joinLineOf(plan), StartsWith("LP_NUM_THREADS=4 '/opt/my book' render"));
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
  for (PlannedScene& scene : plan.scenes) scene.parts = 1;
  plan.scenes[1].startsTask = false;
  plan.joinArguments = {"--format", "gif", "--no-png"};
  EXPECT_FALSE(leavesFrames(plan));
  EXPECT_EQ(countTasks(plan), 2);
  EXPECT_EQ(describe(plan, tasksOf(plan)[0]), "a and 1 more");
  EXPECT_THAT(commandOf(plan, tasksOf(plan)[0]),
              ElementsAre("/opt/rotatebook", "render", "/scenes/a.toml", "/scenes/b.toml",
                          "--resume", "-o", "/out", "--retry-status", "--scene-checksum",
                          "sum-of-a,sum-of-b", "--format", "gif", "--no-png", "--jobs", "1"));
  EXPECT_EQ(commandOf(plan, tasksOf(plan)[1])[2], "/scenes/c.toml");
  EXPECT_THAT(joinCommandOf(plan), IsEmpty());
  EXPECT_EQ(joinLineOf(plan), "");
}

TEST(Plan, OfShortAndLongClipsJoinsTheLongOnesAlone) {
  Plan plan = planOfClips("/out", {"long", "short", "film", "brief"});
  for (const int whole : {1, 3}) plan.scenes[static_cast<std::size_t>(whole)].parts = 1;
  plan.scenes[3].startsTask = false;
  const std::vector<Task> tasks = tasksOf(plan);
  ASSERT_EQ(tasks.size(), 11U);
  EXPECT_EQ(describe(plan, tasks[4]), "part 5/5 of long");
  EXPECT_EQ(describe(plan, tasks[5]), "short and 1 more");
  EXPECT_THAT(tasks[5].scenes, ElementsAre(1, 3));
  EXPECT_EQ(tasks[10].number, 11);
  EXPECT_EQ(describe(plan, tasks[10]), "part 5/5 of film");
  EXPECT_THAT(joinCommandOf(plan),
              AllOf(Contains("sum-of-long,sum-of-film"), Not(Contains("/scenes/short.toml"))));
}

TEST(Plan, SharesTheCoresOfATaskAmongItsClips) {
  Plan plan = planOfClips("/out", {"a", "b", "c"});
  for (PlannedScene& scene : plan.scenes) scene.parts = 1;
  plan.scenes[1].startsTask = false;
  plan.cores = 4;
  EXPECT_THAT(lineOf(plan, tasksOf(plan)[0]),
              AllOf(StartsWith("LP_NUM_THREADS=2 "), EndsWith(" --jobs 2")));
  EXPECT_THAT(lineOf(plan, tasksOf(plan)[1]),
              AllOf(StartsWith("LP_NUM_THREADS=4 "), EndsWith(" --jobs 1")))
      << "one clip";
}

TEST(Plan, OfAMapHasAThreadForEachCore) {
  Plan plan = planOfClips("/out", {"a"});
  plan.work = Work::Map;
  plan.cores = 3;
  const std::vector<std::string> command = commandOf(plan, tasksOf(plan)[0]);
  EXPECT_THAT(command, ::testing::IsSupersetOf({"map", "--threads", "3", "--part", "1/5"}));
  EXPECT_THAT(lineOf(plan, tasksOf(plan)[0]), StartsWith("/opt/rotatebook map"));
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
