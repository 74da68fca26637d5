#include "reliability/faults.h"

#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <mutex>
#include <set>
#include <unistd.h>
#include <vector>

namespace rotatebook::faults {
namespace {

// Views, for there may be no memory yet.
struct Fault {
  std::string_view call, below;
  long number = 0;
  int error = 0;
};

std::string_view variable(const char* name) {
  const char* value = std::getenv(name);
  return value != nullptr ? value : "";
}

Fault readFault() {
  Fault read;
  const std::string_view text = variable("ROTATEBOOK_FAULT");
  const std::size_t first = text.find(':'), second = text.find(':', first + 1);
  if (second == text.npos) return read;
  read.call = text.substr(0, first);
  read.number = std::strtol(&text[first + 1], nullptr, 10);
  read.error = static_cast<int>(std::strtol(&text[second + 1], nullptr, 10));
  read.below = variable("ROTATEBOOK_FAULT_BELOW");
  return read;
}

const Fault& fault() {
  static const Fault wanted = readFault();
  return wanted;
}

/// `path` from the root; empty if that can't be told.
std::string absolute(const std::string& path) {
  if (path.starts_with('/')) return path;
  std::array<char, 4096> folder;
  if (getcwd(folder.data(), folder.size()) == nullptr) return "";
  return std::string(folder.data()) + '/' + path;
}

std::atomic<long> count = 0;

/// Calls that have changed files below the folder.
struct Changes {
  std::mutex mutex;
  std::string lines;
};

Changes& changes() {
  // Never destroyed: libraries go on until the end.
  static auto& all = *new Changes;
  return all;
}

void addChange(std::string_view call, const std::string& path) {
  const std::lock_guard lock(changes().mutex);
  changes().lines.append(call).append(" ").append(path).append("\n");
}

/// Places at which memory was asked for, in the order of the first requests.
struct Places {
  std::mutex mutex;
  std::set<long> known;
  std::vector<long> inOrder;
};

Places& places() {
  // Never destroyed: libraries go on until the end.
  static auto& all = *new Places;
  return all;
}

/// Returns whether it is this call's turn.
bool isDue() {
  const long now = ++count;
  return fault().call == "graphics" ? now == fault().number : now >= fault().number;
}

__attribute__((destructor)) void writeChanges() {
  const std::string_view path = variable("ROTATEBOOK_FAULT_CHANGES");
  if (path.empty()) return;
  if (std::FILE* file = std::fopen(path.data(), "w")) {
    std::fputs(changes().lines.c_str(), file);
    std::fclose(file);
  }
}

__attribute__((destructor)) void writeCount() {
  const std::string_view path = variable("ROTATEBOOK_FAULT_COUNT");
  if (path.empty()) return;
  if (std::FILE* file = std::fopen(path.data(), "w")) {
    if (fault().call == "memory") {
      for (const long place : places().inOrder) std::fprintf(file, "%ld\n", place);
    } else {
      std::fprintf(file, "%ld\n", count.load());
    }
    std::fclose(file);
  }
}

}  // namespace

bool isWanted(std::string_view call) {
  // Sanitizers look functions up before there are variables.
  if (environ == nullptr) return false;
  return fault().number > 0 && fault().call == call;
}

bool fails(std::string_view call) {
  if (!isWanted(call) || !isDue()) return false;
  if (fault().error <= 0) raise(fault().error == 0 ? SIGKILL : -fault().error);
  errno = fault().error;
  return true;
}

bool failsAtPlace(long place) {
  const std::lock_guard lock(places().mutex);
  if (!places().known.insert(place).second) return false;
  places().inOrder.push_back(place);
  return place == fault().number;
}

bool failsAt(std::string_view call, const std::string& path) {
  if (!isWanted(call) && !isWanted("any")) return false;
  const std::string place = absolute(path);
  if (!place.starts_with(fault().below)) return false;
  if (isWanted("any") && !variable("ROTATEBOOK_FAULT_CHANGES").empty()) addChange(call, place);
  return fails(fault().call);
}

}  // namespace rotatebook::faults
