#include "cli/file_report.h"

#include <cstddef>
#include <iostream>

namespace rotatebook::cli {

void reportFiles(const std::vector<std::string>& things) {
  std::cout << "  wrote ";
  for (std::size_t i = 0; i < things.size(); ++i) {
    const char* separator = i == 0 ? "" : i + 1 == things.size() ? " and " : ", ";
    std::cout << separator << things[i];
  }
  std::cout << (things.empty() ? "nothing" : "") << std::endl;
}

}  // namespace rotatebook::cli
