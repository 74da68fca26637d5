#include "cli/file_report.h"

#include <cstddef>

namespace rotatebook::cli {

void reportFiles(const std::vector<std::string>& things, std::ostream& out) {
  out << "  wrote ";
  for (std::size_t i = 0; i < things.size(); ++i) {
    const char* separator = i == 0 ? "" : i + 1 == things.size() ? " and " : ", ";
    out << separator << things[i];
  }
  out << (things.empty() ? "nothing" : "") << std::endl;
}

}  // namespace rotatebook::cli
