#include "farm/plan_file.h"

#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "farm/fake_slurm.h"

namespace rotatebook::farm {
namespace {

namespace fs = std::filesystem;
using testing::emptyFolder;
using ::testing::HasSubstr;
using testing::planOfClips;
using testing::textIn;

StoredPlan example(const fs::path& folder) {
  StoredPlan stored{planOfClips(folder, {"a", "b"}), {{"17", "21"}, "22"}};
  stored.plan.work = Work::Map;
  stored.plan.cores = 2;
  stored.plan.arguments = {"--set", "title=\"two words\""};
  stored.plan.joinArguments = {"--no-mp4"};
  stored.plan.scenes[1].values = "0123";
  return stored;
}

TEST(PlanFile, ReadsBackWhatItWrites) {
  const StoredPlan stored = example("/out");
  const StoredPlan read = parsePlan(planText(stored), "plan.txt");
  EXPECT_EQ(read.plan, stored.plan);
  EXPECT_EQ(read.jobs.arrays, stored.jobs.arrays);
  EXPECT_EQ(read.jobs.join, stored.jobs.join);
}

TEST(PlanFile, RefusesWhatIsNoPlan) {
  EXPECT_THROW(parsePlan("title = 1\n", "f"), InputError);
  EXPECT_THROW(parsePlan("", "f"), InputError);
  std::string text = planText(example("/out"));
  EXPECT_THROW(parsePlan(text + "colour blue\n", "f"), InputError);
  text.replace(text.find("parts 5"), 7, "parts 0");
  EXPECT_THROW(parsePlan(text, "f"), InputError);
}

TEST(PlanFile, RefusesPathsOfSeveralLines) {
  StoredPlan stored = example("/out");
  stored.plan.folder = "/two\nlines";
  EXPECT_THROW(planText(stored), InputError);
}

TEST(PlanFile, HasACommandALine) {
  const fs::path folder = emptyFolder();
  const StoredPlan stored = example(folder);
  const PlanFiles files = planFiles(folder, Work::Map);
  writeNewPlan(files, stored);
  const std::string tasks = textIn(files.tasks);
  EXPECT_EQ(std::count(tasks.begin(), tasks.end(), '\n'), 10);
  EXPECT_THAT(tasks, HasSubstr("'title=\"two words\"'"));
  EXPECT_THAT(textIn(files.join), HasSubstr("/scenes/a.toml /scenes/b.toml --resume"));
  EXPECT_EQ(readPlan(files)->plan, stored.plan);
}

TEST(PlanFile, ForgetsTheEndsOfAnEarlierPlan) {
  const fs::path folder = emptyFolder();
  const PlanFiles files = planFiles(folder, Work::Map);
  writeNewPlan(files, example(folder));
  std::ofstream(files.ends / "3") << "75 n2 14\n";
  std::ofstream(files.ends / "join") << "0 n1 1\n";
  EXPECT_EQ(readEnd(files, 3)->status, 75);
  EXPECT_EQ(readEnd(files, 3)->node, "n2");
  EXPECT_EQ(readEnd(files, 3)->seconds, 14);
  EXPECT_EQ(readEnd(files, 0)->status, 0);
  EXPECT_FALSE(readEnd(files, 4));
  writeNewPlan(files, example(folder));
  EXPECT_FALSE(readEnd(files, 3));
}

}  // namespace
}  // namespace rotatebook::farm
