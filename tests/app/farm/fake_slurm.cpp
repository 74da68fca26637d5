#include "farm/fake_slurm.h"

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <sstream>

#include <gtest/gtest.h>

#include "store/frame_checksums.h"
#include "store/manifest.h"
#include "system/atomic_file.h"

namespace rotatebook::farm::testing {
namespace {

namespace fs = std::filesystem;

// Notes its call; fails if it is to; else answers.
constexpr const char* kScript = R"sh(#!/bin/sh
here=$(dirname "$0")
me=$(basename "$0")
line=$me
for word in "$@"; do
  case $word in /*) word=$(basename "$word");; esac
  line="$line $word"
done
echo "$line" >> "$here/calls"
n=$(grep -c "^$me" "$here/calls")
if [ -f "$here/$me.fails" ] && [ "$n" -ge "$(head -n 1 "$here/$me.fails")" ]; then
  tail -n +2 "$here/$me.fails" >&2
  exit 1
fi
case $me in
  sbatch) echo $((100 + n));;
  squeue) cat "$here/queue";;
  sinfo) echo 'main*|2/4/1/7'; echo 'gpu|0/8/0/8';;
  scontrol) printf 'MaxArraySize            = 1001\nRequeueExit             = 75\n';;
esac
)sh";

store::Manifest manifestOf(const Plan& plan) {
  store::Manifest manifest;
  manifest.own.made = {{"build", plan.build}, {"scene", plan.scenes.front().checksum}};
  return manifest;
}

}  // namespace

fs::path emptyFolder() {
  const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
  const fs::path folder = fs::path(ROTATEBOOK_TEST_OUTPUT) / "farm" /
                          (std::string(test->test_suite_name()) + '.' + test->name());
  fs::remove_all(folder);
  fs::create_directories(folder);
  return folder;
}

std::string textIn(const fs::path& file) {
  std::ifstream stream(file);
  return {std::istreambuf_iterator<char>(stream), {}};
}

FakeSlurm::FakeSlurm(fs::path folder) : folder_(std::move(folder)), path_(std::getenv("PATH")) {
  fs::create_directories(folder_);
  for (const char* program : {"sbatch", "squeue", "sinfo", "scontrol", "scancel"}) {
    std::ofstream(folder_ / program) << kScript;
    fs::permissions(folder_ / program, fs::perms::owner_all);
  }
  setQueue("");
  setenv("PATH", (folder_.string() + ":/usr/bin:/bin").c_str(), 1);
}

FakeSlurm::~FakeSlurm() {
  setenv("PATH", path_.c_str(), 1);
}

void FakeSlurm::fail(const std::string& program, const std::string& message, int from) const {
  std::ofstream(folder_ / (program + ".fails")) << from << '\n' << message << '\n';
}

void FakeSlurm::setQueue(const std::string& lines) const {
  std::ofstream(folder_ / "queue") << lines;
}

void FakeSlurm::remove(const std::string& program) const {
  fs::remove(folder_ / program);
  // What the test's own scripts need stays; a real Slurm on this machine doesn't.
  const fs::path links = folder_ / "links";
  fs::create_directories(links);
  for (const char* tool : {"sh", "dirname", "basename", "grep", "head", "tail", "cat"})
    fs::create_symlink(fs::path("/usr/bin") / tool, links / tool);
  setenv("PATH", (folder_.string() + ':' + links.string()).c_str(), 1);
}

std::vector<std::string> FakeSlurm::calls() const {
  std::istringstream lines(textIn(folder_ / "calls"));
  std::vector<std::string> calls;
  for (std::string line; std::getline(lines, line);) calls.push_back(line);
  return calls;
}

Plan planOfClips(const fs::path& folder, const std::vector<std::string>& names) {
  Plan plan{.program = "/opt/rotatebook", .build = "b1", .folder = folder};
  for (const std::string& name : names) {
    PlannedScene scene{.file = "/scenes/" + name + ".toml", .name = name};
    scene.checksum = "sum-of-" + name;
    scene.units = 10;
    scene.parts = 5;
    scene.outputs = {folder / (name + ".mp4")};
    plan.scenes.push_back(scene);
  }
  return plan;
}

Plan planOfStudy(const fs::path& folder) {
  Plan plan = planOfClips(folder, {"law"});
  plan.work = Work::Study;
  plan.scenes[0].units = plan.scenes[0].parts = 1;
  plan.scenes[0].outputs = {folder / "law-study.csv", folder / "law-study.png"};
  return plan;
}

void leaveFrames(const Plan& plan, const std::vector<int>& frames) {
  const fs::path folder = plan.folder / plan.scenes.front().name;
  fs::create_directories(folder);
  store::writeManifest(folder, manifestOf(plan));
  store::FrameChecksums checksums(folder);
  for (const int frame : frames) {
    const std::string bytes = "frame " + std::to_string(frame);
    system::writeFileAtomically(folder / store::frameName(frame), bytes);
    checksums.add(frame, bytes);
  }
}

void leaveClip(const Plan& plan) {
  leaveFrames(plan, {0, 1, 2, 3, 4, 5, 6, 7, 8, 9});
  store::Manifest manifest = manifestOf(plan);
  manifest.finished = true;
  for (const fs::path& output : plan.scenes.front().outputs) {
    system::writeFileAtomically(output, "a file");
    manifest.own.files[output.filename().string()] = "its checksum";
  }
  store::writeManifest(plan.folder / plan.scenes.front().name, manifest);
}

}  // namespace rotatebook::farm::testing
