#include "farm/farm_report.h"

#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace rotatebook::farm {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

PlanState example() {
  PlanState state;
  state.plan.folder = "/out";
  state.scenes = {{"a", 30, 100, false}};
  state.tasks = {
      {.name = "part 1/3 of a", .kind = TaskState::Kind::Done},
      {.name = "part 2/3 of a", .kind = TaskState::Kind::Running, .node = "n2", .seconds = 75},
      {.name = "part 3/3 of a",
       .kind = TaskState::Kind::Failed,
       .node = "n4",
       .reason = "exit status 2: the renderer differs",
       .log = "/out/farm/render/log/3.txt"}};
  state.join = TaskState{.name = "join", .reason = "Dependency"};
  state.remaining = 400;
  return state;
}

std::string textOf(const PlanState& state) {
  std::ostringstream out;
  reportStates({state}, out);
  return out.str();
}

TEST(FarmReport, SaysWhatIsDoneWhoDoesWhatAndWhenItEnds) {
  EXPECT_EQ(textOf(example()),
            "render of a: 30 of 100 frames are there\n"
            "  done: 1 of 3 tasks\n"
            "  running: part 2/3 of a on n2 for 75 s\n"
            "  failed: part 3/3 of a on n4, exit status 2: the renderer differs "
            "(/out/farm/render/log/3.txt)\n"
            "  waiting: join, Dependency\n"
            "  the tasks end in about 7 min\n"
            "  the same 'rotatebook submit' sends what is missing once more\n");
}

TEST(FarmReport, ListsOnlySomeOfManyTasks) {
  PlanState state = example();
  state.tasks.assign(100, {.name = "part", .kind = TaskState::Kind::Running, .node = "n1"});
  EXPECT_THAT(textOf(state), HasSubstr("  running: 80 more\n"));
}

TEST(FarmReport, IsOneJsonObject) {
  std::ostringstream out;
  reportStatesAsJson({example()}, out);
  EXPECT_THAT(out.str(), AllOf(HasSubstr(R"("command":"render")"), HasSubstr(R"("failed":true)"),
                               HasSubstr(R"("remaining_s":400)"),
                               HasSubstr(R"("state":"running","node":"n2")")));
}

TEST(FarmReport, SaysWhatWasSent) {
  Plan plan;
  plan.folder = "/my out";
  std::ostringstream out;
  reportSubmission(
      plan, {.sent = {2, 3}, .tasks = 4, .done = 1, .queued = 1, .array = "17", .join = "18"}, out);
  EXPECT_EQ(out.str(),
            "1 task of 4 was done before\n1 task is in the queue already\nsent 2 tasks as job 17\n"
            "sent job 18, which joins the results after them\nsee rotatebook status '/my out'\n");
  std::ostringstream whole;
  reportSubmission(plan, {.isWhole = true}, whole);
  EXPECT_THAT(whole.str(), AllOf(HasSubstr("nothing was sent"), Not(HasSubstr("status"))));
}

}  // namespace
}  // namespace rotatebook::farm
