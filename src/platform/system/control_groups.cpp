#include "system/control_groups.h"

#include <algorithm>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "base/parsed_number.h"
#include "base/text.h"
#include "system/read_file.h"

namespace rotatebook::system {
namespace {

namespace fs = std::filesystem;

/// A hierarchy of control groups that is mounted.
struct Hierarchy {
  std::string controllers;  ///< ",cpu,cpuacct,"; empty for version 2, which has all.
  std::string group;        ///< The group that the mount shows at its top.
  fs::path folder;
};

std::vector<std::string> wordsOf(const std::string& line) {
  std::istringstream words(line);
  std::vector<std::string> all;
  for (std::string word; words >> word;) all.push_back(word);
  return all;
}

std::vector<std::string> linesOf(const fs::path& file) {
  return itemsOf(readFileOrEmpty(file), '\n');
}

bool has(const std::string& controllers, std::string_view controller) {
  return controllers.find("," + std::string(controller) + ",") != std::string::npos;
}

/// Reads the mounts: "36 35 98:0 /GROUP /FOLDER rw,... - cgroup2 cgroup2 rw,cpu".
std::vector<Hierarchy> hierarchies(const fs::path& root) {
  std::vector<Hierarchy> found;
  for (const std::string& line : linesOf(root / "proc/self/mountinfo")) {
    const std::vector<std::string> words = wordsOf(line);
    const auto dash = std::ranges::find(words, "-");
    if (words.size() < 5 || words.end() - dash < 4) continue;
    const std::string& type = *(dash + 1);
    if (type != "cgroup" && type != "cgroup2") continue;
    found.push_back({type == "cgroup" ? "," + *(dash + 3) + "," : "", words[3],
                     root / fs::path(words[4]).relative_path()});
  }
  return found;
}

/// Returns the group of this process in a hierarchy with these controllers: "4:cpu,cpuacct:/GROUP",
/// or of version 2 "0::/GROUP". Returns "/" if none is listed.
std::string groupOf(const fs::path& root, const Hierarchy& hierarchy) {
  for (const std::string& line : linesOf(root / "proc/self/cgroup")) {
    const std::size_t first = line.find(':'), second = line.find(':', first + 1);
    if (second == std::string::npos) continue;
    const std::string controllers = line.substr(first + 1, second - first - 1);
    const bool isSame = controllers.empty() ? hierarchy.controllers.empty()
                                            : has(hierarchy.controllers,
                                                  controllers.substr(0, controllers.find(',')));
    if (isSame) return line.substr(second + 1);
  }
  return "/";
}

/// Returns the folder of this process's group and those above it, up to the hierarchy's own.
std::vector<fs::path> foldersOf(const fs::path& root, const Hierarchy& hierarchy) {
  fs::path below = groupOf(root, hierarchy);
  // A container sees its group at the top, whether or not its name is that of the machine
  const fs::path shown = below.lexically_relative(hierarchy.group);
  if (!shown.empty() && *shown.begin() != "..") below = shown;
  std::vector<fs::path> folders{hierarchy.folder};
  for (const fs::path& part : below.relative_path()) {
    if (part != "." && part != "..") folders.push_back(folders.back() / part);
  }
  return folders;
}

/// Returns the number that the first word of `file`, or of its `index`-th, is; nothing for others,
/// such as max, and for those below 1.
std::optional<double> numberIn(const fs::path& file, std::size_t index = 0) {
  const std::vector<std::string> words = wordsOf(readFileOrEmpty(file));
  if (words.size() <= index) return std::nullopt;
  const auto number = parsedNumber<long long>(words[index]);
  return number > 0 ? std::optional<double>(static_cast<double>(*number)) : std::nullopt;
}

void lower(std::optional<double>& limit, const std::optional<double>& other) {
  if (other) limit = std::min(*other, limit.value_or(*other));
}

/// Returns `time` of each `period`.
std::optional<double> ratio(const std::optional<double>& time,
                            const std::optional<double>& period) {
  return time && period ? std::optional<double>(*time / *period) : std::nullopt;
}

}  // namespace

ControlGroupLimits controlGroupLimits(const fs::path& root) {
  ControlGroupLimits limits;
  for (const Hierarchy& hierarchy : hierarchies(root)) {
    for (const fs::path& folder : foldersOf(root, hierarchy)) {
      if (hierarchy.controllers.empty()) {
        lower(limits.cores, ratio(numberIn(folder / "cpu.max"), numberIn(folder / "cpu.max", 1)));
        lower(limits.memory, numberIn(folder / "memory.max"));
      } else {
        lower(limits.cores,
              ratio(numberIn(folder / "cpu.cfs_quota_us"), numberIn(folder / "cpu.cfs_period_us")));
        lower(limits.memory, numberIn(folder / "memory.limit_in_bytes"));
      }
    }
  }
  return limits;
}

}  // namespace rotatebook::system
