#include "cli/installed_file.h"

#include <system_error>

namespace rotatebook::cli {

namespace fs = std::filesystem;

fs::path programPrefix() {
  std::error_code error;
  return fs::read_symlink("/proc/self/exe", error).parent_path().parent_path();
}

std::optional<fs::path> installedFile(const std::string& name) {
  std::error_code error;
  fs::path file = programPrefix() / "share/rotatebook" / name;
  if (!fs::is_regular_file(file, error)) return std::nullopt;
  return file;
}

}  // namespace rotatebook::cli
