#include "farm/plan_texts.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "farm/fake_slurm.h"
#include "messages.h"

namespace rotatebook::farm {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;
using testing::planOfClips;
using testing::planOfStudy;

std::vector<Task> without(std::vector<Task> tasks, std::int64_t number) {
  std::erase_if(tasks, [number](const Task& task) { return task.number == number; });
  return tasks;
}

TEST(PlanTexts, HaveNames) {
  EXPECT_EQ(planFormat("parallel").text, parallelText);
  try {
    planFormat("paralel");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_MESSAGE(error.what());
  }
}

TEST(PlanTexts, ListWhatIsMissingAndTheJoin) {
  const Plan plan = planOfClips("/out", {"a"});
  const std::string text = listText(plan, without(tasksOf(plan), 2));
  EXPECT_THAT(text, AllOf(HasSubstr("--part 1/5"), Not(HasSubstr("--part 2/5"))));
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 6);  // four, a comment, and the join
  EXPECT_EQ(listText(planOfStudy("/out"), {}), "") << "nothing to join";
}

TEST(PlanTexts, AreReadByGnuParallel) {
  const Plan plan = planOfClips("/out", {"a"});
  const std::string text = parallelText(plan, tasksOf(plan));
  EXPECT_THAT(text, AllOf(HasSubstr("parallel --retries 3 \"$@\" <<'TASKS'"),
                          HasSubstr("\nTASKS\nLP_NUM_THREADS=1 /opt/rotatebook render "
                                    "/scenes/a.toml --resume")));
  EXPECT_THAT(parallelText(plan, {}), Not(HasSubstr("TASKS"))) << "only the join";
}

}  // namespace
}  // namespace rotatebook::farm
