#include "farm/plan_texts.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "farm/fake_slurm.h"

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
  EXPECT_EQ(planFormat("openjd").text, openJobText);
  try {
    planFormat("opendj");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), AllOf(HasSubstr("\"list\", \"parallel\" and \"openjd\""),
                                    HasSubstr("did you mean \"openjd\"")));
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

TEST(PlanTexts, AreJobTemplates) {
  const Plan plan = planOfClips("/out", {"a", "b"});
  const std::string text = openJobText(plan, without(tasksOf(plan), 2));
  for (const char* piece :
       {R"("specificationVersion": "jobtemplate-2023-09")", R"("name": "a 1")",
        R"({"name": "Part", "type": "INT", "range": "1,3-5"})",
        R"("--part", "{{Task.Param.Part}}/5")", R"("variables": {"LP_NUM_THREADS": "1"})",
        R"("dependencies": [{"dependsOn": "a 1"}, {"dependsOn": "b 2"}])",
        R"("command": "/opt/rotatebook")"})
    EXPECT_THAT(text, HasSubstr(piece));
}

TEST(PlanTexts, OfStudiesHaveNoParameters) {
  const std::string text = openJobText(planOfStudy("/out"), tasksOf(planOfStudy("/out")));
  EXPECT_THAT(text, AllOf(Not(HasSubstr("parameterSpace")), Not(HasSubstr("\"join\"")),
                          Not(HasSubstr("stepEnvironments"))));
}

TEST(PlanTexts, RefuseWhatATemplateWouldReplace) {
  Plan plan = planOfClips("/out/{{x}}", {"a"});
  EXPECT_THROW(openJobText(plan, tasksOf(plan)), InputError);
}

}  // namespace
}  // namespace rotatebook::farm
