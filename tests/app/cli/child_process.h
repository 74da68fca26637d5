// The program as a user starts it: in a process of its own, with everything that it says kept.
#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace rotatebook::cli::testing {

/// Circumstances in which a program starts.
struct ChildSettings {
  std::filesystem::path folder;                                    ///< Its working folder; exists.
  std::vector<std::pair<std::string, std::string>> environment{};  ///< Added to ours.
  std::string outputFile{};            ///< Takes its standard output instead of us.
  bool terminal = false;               ///< Its standard error is a pseudo-terminal.
  unsigned short columns = 0;          ///< Of the terminal; 0 if it doesn't say.
  bool obeysPermissions = false;       ///< A file's mode counts even if the superuser runs it.
  std::vector<int> closed{};           ///< Descriptors that are closed from the start.
  int ignoredSignal = 0;               ///< Ignored from the start.
  std::optional<long> largestFile{};   ///< Writing beyond this fails with EFBIG. [bytes]
  std::optional<long> stack{};         ///< Growing beyond this ends it. [bytes]
  std::function<bool()> signalWhen{};  ///< Asked again and again until it says yes, ...
  std::string signalUpon{};            ///< Or until its standard error has this, ...
  int signal = 0;                      ///< ... which sends this signal.
  std::chrono::seconds timeout{120};   ///< After which it is killed.
};

/// Result of a program's run.
struct ChildResult {
  int status = -1;     ///< Exit status; 128 + signal if a signal ended it, 137 after the timeout.
  std::string output;  ///< Its standard output.
  std::string error;   ///< Its standard error; line ends of a terminal are "\r\n".
};

/// Says why this machine has no pseudo-terminal to give; empty if it has.
std::string whyNoTerminal();

/// Runs `program` with `arguments` to its end. Throws std::system_error if it can't be started.
ChildResult runChild(const std::filesystem::path& program,
                     const std::vector<std::string>& arguments, const ChildSettings& settings);

}  // namespace rotatebook::cli::testing
