#include "farm/plan_file.h"

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
  const StoredPlan read = parsePlan(planText(stored), "plan.json");
  EXPECT_EQ(read.plan, stored.plan);
  EXPECT_EQ(read.jobs.arrays, stored.jobs.arrays);
  EXPECT_EQ(read.jobs.join, stored.jobs.join);
}

/// Returns why a plan is refused whose first member `key` has this value; "" if it isn't.
std::string refusalOf(const std::string& key, const std::string& value) {
  std::string text = planText(example("/out"));
  const std::size_t begin = text.find('"' + key + "\": ") + key.size() + 4;
  text.replace(begin, text.find_first_of(",\n", begin) - begin, value);
  try {
    parsePlan(text, "plan.json");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(PlanFile, RefusesWhatIsNoPlan) {
  for (const char* text :
       {"", "title = 1\n", "{}", "[2]", "{\"work\": \"map\"}", "{\"rotatebook_plan"})
    EXPECT_THROW(parsePlan(text, "f"), InputError) << text;
  EXPECT_THROW(parsePlan(std::string(1 << 16, '['), "f"), InputError);
  EXPECT_MESSAGE(refusalOf("work", "\"maps\""));
  EXPECT_MESSAGE(refusalOf("name", "7"));
  EXPECT_MESSAGE(refusalOf("name", "\"\\u001b\""));
  EXPECT_THAT(refusalOf("folder", "\"/x\", \"folders\": 1"), "");
}

TEST(PlanFile, OfAnotherVersionIsRefusedByItsVersion) {
  EXPECT_MESSAGE(refusalOf("rotatebook_plan", "4"));
  const fs::path folder = emptyFolder();
  const PlanFiles files = planFiles(folder, Work::Map);
  fs::create_directories(files.folder);
  std::ofstream(files.folder / "plan.txt") << "rotatebook plan 1\n";
  EXPECT_THROW(readPlan(files), InputError);
}

TEST(PlanFile, BelievesNoNumbersThatNoPlanHas) {
  for (const char* number :
       {"0", "-1", "1000001", "9000000000000000000", "9223372036854775807", "18446744073709551615",
        "99999999999999999999", "1e3", "true", "null"}) {
    for (const char* key : {"units", "parts"}) EXPECT_MESSAGE(refusalOf(key, number)) << number;
  }
  EXPECT_MESSAGE(refusalOf("cores", "1025"));
  EXPECT_MESSAGE(refusalOf("parts", "11"));
  EXPECT_THAT(refusalOf("parts", "10"), "");
  EXPECT_THAT(refusalOf("units", "1000000"), "");
}

TEST(PlanFile, HasNoMoreTasksThanSubmitMakes) {
  StoredPlan stored{planOfClips("/out", {"a", "b"})};
  for (PlannedScene& scene : stored.plan.scenes) scene.units = scene.parts = 500'000;
  EXPECT_EQ(countTasks(parsePlan(planText(stored), "f").plan), kMaxTasks);
  stored.plan.scenes.push_back({.file = "/c.toml"});
  EXPECT_THROW(planText(stored), InputError);
  stored.plan = planOfClips("/out", std::vector<std::string>(101, "a"));
  for (PlannedScene& scene : stored.plan.scenes) scene.units = 1'000'000;
  EXPECT_THROW(planText(stored), InputError) << "more frames than memory";
}

TEST(PlanFile, IsNotReadIfItIsLongerThanAnyPlan) {
  const fs::path folder = emptyFolder();
  const PlanFiles files = planFiles(folder, Work::Map);
  writeNewPlan(files, example(folder));
  fs::resize_file(files.plan, std::uintmax_t{20} << 30);  // Sparse: it takes no room.
  EXPECT_THROW(readPlan(files), InputError);
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
  std::ofstream(files.ends / "03") << "0 n1 1\n";
  const auto ends = readEnds(files);
  EXPECT_EQ(ends.size(), 2U);
  EXPECT_EQ(ends.at(3).status, 75);
  EXPECT_EQ(ends.at(3).node, "n2");
  EXPECT_EQ(ends.at(3).seconds, 14);
  EXPECT_EQ(ends.at(0).status, 0);
  writeNewPlan(files, example(folder));
  EXPECT_TRUE(readEnds(files).empty());
}

}  // namespace
}  // namespace rotatebook::farm
