#include "cli/file_report.h"

#include <cstddef>

#include "base/number_text.h"

namespace rotatebook::cli {

void reportFiles(const std::vector<std::string>& things, std::ostream& out) {
  out << "  wrote ";
  for (std::size_t i = 0; i < things.size(); ++i) {
    const char* separator = i == 0 ? "" : i + 1 == things.size() ? " and " : ", ";
    out << separator << things[i];
  }
  out << (things.empty() ? "nothing" : "") << std::endl;
}

std::string spaceWarning(const pipeline::DiskSpace& space, const std::filesystem::path& folder) {
  if (space.needed <= space.free) return "";
  const auto gigabytes = [](double bytes) { return roundedText(bytes / 1e9, 2) + " GB"; };
  return "about " + gigabytes(space.needed) + " are needed in " + folder.string() + " and " +
         gigabytes(space.free) + " are free: make room, or leave PNGs out with --no-png";
}

}  // namespace rotatebook::cli
