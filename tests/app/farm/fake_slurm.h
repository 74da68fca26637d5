// A cluster of shell scripts, and plans for it.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "farm/plan.h"
#include "farm/plan_file.h"

namespace rotatebook::farm::testing {

/// An empty folder of the running test.
std::filesystem::path emptyFolder();
std::string textIn(const std::filesystem::path& file);

/// Slurm's commands as scripts that come first on PATH while this lives. They note how they are
/// called; sbatch numbers jobs from 101.
class FakeSlurm {
 public:
  explicit FakeSlurm(std::filesystem::path folder);
  FakeSlurm(const FakeSlurm&) = delete;
  FakeSlurm& operator=(const FakeSlurm&) = delete;
  ~FakeSlurm();

  /// Has `program` print a message to the standard error, and fail, from its call `from` on.
  void fail(const std::string& program, const std::string& message, int from = 1) const;
  /// Sets what squeue prints.
  void setQueue(const std::string& lines) const;
  /// Takes a program away.
  void remove(const std::string& program) const;
  /// Returns the calls so far, a line each: "sbatch --parsable part.sh"; of paths only the names.
  std::vector<std::string> calls() const;

 private:
  std::filesystem::path folder_;
  std::string path_;
};

/// Returns a plan of clips into `folder`, of 10 frames in 5 parts each.
Plan planOfClips(const std::filesystem::path& folder, const std::vector<std::string>& names);
/// Returns a plan of one study.
Plan planOfStudy(const std::filesystem::path& folder);
/// Leaves a frame of the plan's first scene as a task does.
void leaveFrames(const Plan& plan, const std::vector<int>& frames);
/// Leaves all frames and outputs of the plan's first scene as the join does.
void leaveClip(const Plan& plan);

}  // namespace rotatebook::farm::testing
