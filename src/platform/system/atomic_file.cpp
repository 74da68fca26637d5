#include "system/atomic_file.h"

#include <cerrno>
#include <chrono>
#include <cstdio>
#include <fcntl.h>
#include <mutex>
#include <set>
#include <string>
#include <sys/stat.h>
#include <system_error>
#include <thread>
#include <unistd.h>
#include <utility>

#include <fmt/core.h>

#include "base/error.h"
#include "system/temporary_files.h"

namespace rotatebook::system {
namespace {

namespace fs = std::filesystem;

/// Names what exists at `path` or above it but is not a folder, with the remedy; else empty.
std::string obstacleOn(const fs::path& path) {
  fs::path prefix;
  for (const fs::path& part : path) {
    prefix /= part;
    std::error_code unknown;
    if (!fs::exists(fs::symlink_status(prefix, unknown)) || fs::is_directory(prefix, unknown)) {
      continue;
    }
    const bool link = fs::is_symlink(prefix, unknown) && !fs::exists(prefix, unknown);
    return prefix.string() + (link ? " is a link whose target doesn't exist" : " is not a folder") +
           "; move it out of the way, or choose another path";
  }
  return "";
}

/// Removes stale temporaries, once per folder in the life of the process.
void tidyOnce(const fs::path& folder) {
  static std::mutex mutex;
  static std::set<fs::path> tidied;
  const std::lock_guard lock(mutex);
  if (tidied.insert(folder).second) removeStaleTemporaries(folder.empty() ? "." : folder);
}

/// Calls createLocked() with retries: a process that tidies up locks a file for an instant.
FileDescriptor createLockedWithRetries(const fs::path& path, Lock lock) {
  FileDescriptor file = createLocked(path, lock);
  for (int tries = 1; tries < 5 && !file.isOpen() && errno == EWOULDBLOCK; ++tries) {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    file = createLocked(path, lock);
  }
  return file;
}

// A rename is only safe against a power cut once the content itself has reached the disk.
void flushToDisk(const FileDescriptor& file, const fs::path& path) {
  if (fdatasync(file.number()) != 0) throwLastError(path, "flush");
}

nlink_t linkCount(const FileDescriptor& file) {
  struct stat status {};
  return fstat(file.number(), &status) == 0 ? status.st_nlink : 0;
}

}  // namespace

AtomicFile::AtomicFile(fs::path finalPath)
    : finalPath_(std::move(finalPath)), temporaryPath_(temporaryNameFor(finalPath_)) {
  requireReplaceable(finalPath_);
  tidyOnce(finalPath_.parent_path());
  held_ = createLockedWithRetries(temporaryPath_, Lock::Exclusive);
  if (!held_.isOpen()) throwLastError(finalPath_, "write");
}

void requireReplaceable(const fs::path& path) {
  // A rename would replace a device or a pipe by a plain file.
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (status.type() == fs::file_type::not_found || fs::is_regular_file(status)) return;
  const std::string kind = fs::is_directory(status) ? "a folder" : "not a regular file";
  throw MachineError(
      fmt::format("can't write {}: {}", path.string(), error ? error.message() : "it is " + kind));
}

AtomicFile::~AtomicFile() {
  std::error_code ignored;
  if (!committed_) fs::remove(temporaryPath_, ignored);
}

void AtomicFile::write(std::string_view content) {
  writeAll(held_, content, finalPath_);
}

void AtomicFile::commitAs(const fs::path& path) {
  flushToDisk(held_, path);
  renameTo(path);
}

void AtomicFile::commitUnflushed() {
  renameTo(finalPath_);
}

void AtomicFile::renameTo(const fs::path& path) {
  if (std::rename(temporaryPath_.c_str(), path.c_str()) != 0) {
    throwLastError(path, "rename the finished file to");
  }
  committed_ = true;
}

bool AtomicFile::commitIfNew() {
  flushToDisk(held_, finalPath_);
  if (link(temporaryPath_.c_str(), finalPath_.c_str()) == 0) return true;
  switch (errno) {
    case EEXIST:
      // A server's lost answer makes a link that was made be tried again
      return linkCount(held_) == 2;
    case EPERM:
    case EOPNOTSUPP:
    case ENOSYS:
      return renameIfNew();
    default:
      throwLastError(finalPath_, "write");
  }
}

bool AtomicFile::renameIfNew() {
  committed_ = renameat2(AT_FDCWD, temporaryPath_.c_str(), AT_FDCWD, finalPath_.c_str(),
                         RENAME_NOREPLACE) == 0;
  if (committed_ || errno == EEXIST) return committed_;
  if (errno != EINVAL && errno != ENOSYS) throwLastError(finalPath_, "write");
  if (fs::exists(fs::symlink_status(finalPath_))) return false;
  commit();
  return true;
}

bool createFileAtomically(const fs::path& path, std::string_view content) {
  AtomicFile file(path);
  file.write(content);
  return file.commitIfNew();
}

void writeFileAtomically(const fs::path& path, std::string_view content) {
  AtomicFile file(path);
  file.write(content);
  file.commit();
}

AdvisoryLock::AdvisoryLock(const fs::path& path, Lock lock)
    : path_(lockNameFor(path)), file_(createLockedWithRetries(path_, lock)) {
  if (file_.isOpen()) return;
  if (errno != EWOULDBLOCK) throwLastError(path, "write");
  throw MachineError(
      fmt::format("another process is writing {}; wait for it to end", path.string()),
      ErrorKind::Transient);
}

AdvisoryLock::~AdvisoryLock() {
  // Of the processes that share the lock, the last one removes its file.
  if (tryLock(file_, Lock::Exclusive) == Locking::Refused) return;
  std::error_code ignored;
  fs::remove(path_, ignored);
}

void flushFolder(const fs::path& folder) {
  const FileDescriptor file(open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (!file.isOpen() || fsync(file.number()) != 0) throwLastError(folder, "flush the folder");
}

void removeFile(const fs::path& path) {
  std::error_code error;
  fs::remove(path, error);
  if (!error) return;
  throw MachineError(fmt::format("can't remove {}: {}", path.string(), error.message()),
                     kindOfError(error.value()));
}

void createFolders(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (!error) return;
  const std::string obstacle = obstacleOn(folder);
  throw MachineError(fmt::format("can't make the folder {}: {}", folder.string(),
                                 obstacle.empty() ? error.message() : obstacle),
                     kindOfError(error.value()));
}

}  // namespace rotatebook::system
