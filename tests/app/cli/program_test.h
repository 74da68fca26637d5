// A folder of its own for each test, and the program run in it.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/child_process.h"

namespace rotatebook::cli::testing {

/// 12 frames of 64x36 pixels that expect nothing. Its book is of plain cloth: reading the built-in
/// pictures would take half of a render's time.
inline constexpr const char* kTiny = R"(title = "Tiny"
book.color = "#2b5d8a"
initial.angular_velocity = [5.0, 0.0, 0.005]
[clip]
size = [64, 36]
duration = 0.2
)";

/// Settings on a machine that has no graphics, whatever this one has.
inline constexpr std::pair<const char*, const char*> kNoGraphics{"__EGL_VENDOR_LIBRARY_FILENAMES",
                                                                 "/nonexistent"};

class ProgramTest : public ::testing::Test {
 protected:
  /// Starts with an empty folder and tiny.toml in it.
  ProgramTest();

  /// Runs the program in the folder.
  ChildResult run(const std::vector<std::string>& arguments) const;
  ChildResult run(const std::vector<std::string>& arguments, ChildSettings settings) const;
  /// Runs the program in the folder with words as a shell takes them, as "check - < a.toml".
  ChildResult runWords(const std::string& words) const;
  /// Runs the program in the folder, without graphics.
  ChildResult runWithoutGraphics(const std::vector<std::string>& arguments) const;

  void write(const std::string& name, const std::string& content) const;
  std::string read(const std::string& name) const;
  bool has(const std::string& name) const;
  /// All files below the folder but tiny.toml, sorted, hidden ones too; folders end in '/'.
  std::vector<std::string> files() const;

  /// Expects the same names below both folders, and the same bytes in their files; returns how many
  /// files there are.
  int expectSameFiles(const std::string& folder, const std::string& other,
                      const std::string& when = "") const;

  /// The folder's path from the root.
  const std::filesystem::path& folder() const { return folder_; }

 private:
  std::vector<std::string> filesBelow(const std::string& folder) const;

  std::filesystem::path folder_;
};

/// `text` without its lines on how far a motion was from the exact one, whose last digit may be
/// another on another processor.
std::string withoutDistances(const std::string& text);

/// Counts how often `part` occurs in `text`.
int countOf(const std::string& part, const std::string& text);

}  // namespace rotatebook::cli::testing
