#include "base/read_file.h"

#include <fstream>
#include <iterator>

namespace rotatebook {

std::string readFileOrEmpty(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

}  // namespace rotatebook
