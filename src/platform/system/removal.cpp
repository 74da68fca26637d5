#include "system/removal.h"

#include <cerrno>
#include <fcntl.h>
#include <optional>
#include <pwd.h>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>

#include <fmt/core.h>

namespace rotatebook::system {
namespace {

namespace fs = std::filesystem;

/// Returns the name of the user with this number, or the number.
std::string userName(uid_t user) {
  const passwd* entry = getpwuid(user);
  return entry != nullptr ? entry->pw_name : fmt::format("user {}", user);
}

std::optional<struct stat> statusOf(const fs::path& path) {
  struct stat status {};
  if (lstat(path.c_str(), &status) != 0) return std::nullopt;
  return status;
}

/// Returns why this user can't change the names in `folder`.
std::string obstacleIn(const fs::path& folder) {
  if (faccessat(AT_FDCWD, folder.c_str(), W_OK | X_OK, AT_EACCESS) == 0) return "";
  const std::string cause = std::generic_category().message(errno);
  struct stat status {};
  if (stat(folder.c_str(), &status) != 0) return cause;
  return fmt::format("{}; {} belongs to {}", cause, folder.string(), userName(status.st_uid));
}

/// Returns why this user can't remove the file at `path` from `folder`, whose names they may
/// change.
std::string obstacleByOwner(const fs::path& folder, const fs::path& path) {
  struct stat above {};
  const auto own = statusOf(path);
  if (!own || stat(folder.c_str(), &above) != 0 || (above.st_mode & S_ISVTX) == 0) return "";
  const uid_t user = geteuid();
  if (user == 0 || user == above.st_uid || user == own->st_uid) return "";
  return fmt::format("{} belongs to {}, and {} lets users remove only their own files",
                     path.string(), userName(own->st_uid), folder.string());
}

}  // namespace

bool isOccupied(const fs::path& path) {
  std::error_code ignored;
  return fs::exists(fs::symlink_status(path, ignored));
}

bool isPlainFile(const fs::path& path) {
  std::error_code ignored;
  return fs::is_regular_file(fs::symlink_status(path, ignored));
}

std::string obstacleToRemoval(const fs::path& path) {
  if (!statusOf(path)) return "";
  const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
  const std::string obstacle = obstacleIn(folder);
  return obstacle.empty() ? obstacleByOwner(folder, path) : obstacle;
}

std::string obstacleToEmptying(const fs::path& folder) {
  std::string obstacle = obstacleIn(folder);
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    if (!obstacle.empty()) break;
    obstacle = obstacleByOwner(folder, entry.path());
  }
  return error ? error.message() : obstacle;
}

// A folder that moves to another one changes, as it names the folder that it is in.
std::string obstacleToMovingFolders(const fs::path& folder) {
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    if (entry.symlink_status(error).type() != fs::file_type::directory) continue;
    const std::string obstacle = obstacleIn(entry.path());
    if (!obstacle.empty()) return obstacle;
  }
  return error ? error.message() : "";
}

}  // namespace rotatebook::system
