#include "farm/progress.h"

#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

#include "base/error.h"
#include "farm/fake_slurm.h"
#include "farm/plan_folder.h"
#include "store/map_tiles.h"

namespace rotatebook::farm {
namespace {

namespace fs = std::filesystem;
using testing::emptyFolder;
using testing::leaveClip;
using testing::leaveFrames;
using testing::planOfClips;
using testing::planOfStudy;

SceneProgress progressOfFirst(const Plan& plan) {
  return progressOf(plan, planFiles(plan.folder, plan.work)).front();
}

TEST(Progress, CountsFramesThatAreThereAndListed) {
  const Plan plan = planOfClips(emptyFolder(), {"a"});
  EXPECT_EQ(progressOfFirst(plan).count(), 0);
  leaveFrames(plan, {0, 1, 2, 5});
  fs::remove(plan.folder / "a/frame_00002.png");          // listed, but gone
  std::ofstream(plan.folder / "a/frame_00007.png") << 7;  // there, but not listed
  const SceneProgress progress = progressOfFirst(plan);
  EXPECT_EQ(progress.count(), 3);
  EXPECT_TRUE(progress.has({1, 5}));   // 0 and 1
  EXPECT_FALSE(progress.has({2, 5}));  // 2 is missing
  EXPECT_FALSE(progress.has({4, 5}));
  EXPECT_FALSE(progress.isWhole);
}

TEST(Progress, IgnoresWhatOtherScenesOrProgramsMade) {
  const Plan plan = planOfClips(emptyFolder(), {"a"});
  leaveClip(plan);
  EXPECT_TRUE(progressOfFirst(plan).isWhole);
  EXPECT_NO_THROW(requireSameResults(plan));
  Plan changed = plan;
  changed.scenes[0].checksum = "changed";
  EXPECT_EQ(progressOfFirst(changed).count(), 0);
  EXPECT_THROW(requireSameResults(changed), InputError);
  Plan rebuilt = plan;
  rebuilt.build = "b2";
  EXPECT_FALSE(progressOfFirst(rebuilt).isWhole);
  EXPECT_THROW(requireSameResults(rebuilt), InputError);
}

TEST(Progress, IsWholeOnceAllOutputsAreThere) {
  Plan plan = planOfClips(emptyFolder(), {"a"});
  leaveClip(plan);
  fs::remove(plan.folder / "a.mp4");
  EXPECT_FALSE(progressOfFirst(plan).isWhole);
  leaveClip(plan);
  plan.scenes[0].outputs.push_back(plan.folder / "a.gif");
  EXPECT_FALSE(progressOfFirst(plan).isWhole) << "another format is wanted now";
  EXPECT_TRUE(progressOfFirst(plan).has({2, 5})) << "but no frame is drawn again";
}

TEST(Progress, OfWholeClipsIsThatOfTheirFiles) {
  Plan plan = planOfClips(emptyFolder(), {"a", "b"});
  for (PlannedScene& scene : plan.scenes) scene.parts = 1;
  plan.scenes[1].startsTask = false;
  const auto isFirstDone = [&] {
    return isDone(plan, tasksOf(plan)[0], progressOf(plan, planFiles(plan.folder, plan.work)));
  };
  leaveClip(plan);
  EXPECT_FALSE(isFirstDone()) << "b is missing";
  plan.scenes[1].startsTask = true;
  EXPECT_TRUE(isFirstDone());
  fs::remove(plan.folder / "a/frame_00002.png");
  EXPECT_FALSE(isFirstDone()) << "a frame is missing";
  EXPECT_FALSE(progressOfFirst(plan).isWhole);
  plan.joinArguments = {kNoPng};
  EXPECT_TRUE(progressOfFirst(plan).isWhole) << "no frame is wanted";
  EXPECT_EQ(progressOfFirst(plan).count(), plan.scenes[0].units);
  fs::remove(plan.folder / "a.mp4");
  EXPECT_FALSE(progressOfFirst(plan).isWhole);
}

TEST(Progress, CountsTilesOfAMap) {
  Plan plan = planOfClips(emptyFolder(), {"m"});
  plan.work = Work::Map;
  plan.scenes[0].values = "abc";
  plan.scenes[0].outputs = {plan.folder / "m.json"};
  fs::create_directories(plan.folder / "m.tiles");
  store::MapTiles(plan.folder / "m.tiles", "abc").write(3, "tile");
  EXPECT_NO_THROW(requireSameResults(plan));
  store::MapTiles(plan.folder / "m.tiles", "other").write(4, "tile");
  const SceneProgress progress = progressOfFirst(plan);
  EXPECT_EQ(progress.count(), 1);
  EXPECT_TRUE(progress.units[3]);
  EXPECT_THROW(requireSameResults(plan), InputError);
  std::ofstream(plan.folder / "m.json") << R"({"fingerprint": "abc"})";
  EXPECT_TRUE(progressOfFirst(plan).isWhole);
}

TEST(Progress, TakesAStudyForDoneIfItIsNewerThanThePlan) {
  const Plan plan = planOfStudy(emptyFolder());
  const PlanFiles files = planFiles(plan.folder, plan.work);
  for (const fs::path& output : plan.scenes[0].outputs) std::ofstream(output) << "old";
  writeNewPlan(files, {plan});
  fs::last_write_time(files.tasks, fs::last_write_time(files.tasks) + std::chrono::seconds(10));
  EXPECT_FALSE(progressOfFirst(plan).isWhole);
  fs::last_write_time(files.tasks, fs::last_write_time(files.tasks) - std::chrono::hours(1));
  EXPECT_TRUE(progressOfFirst(plan).isWhole);
  fs::remove(plan.scenes[0].outputs[1]);
  EXPECT_FALSE(progressOfFirst(plan).isWhole);
}

}  // namespace
}  // namespace rotatebook::farm
