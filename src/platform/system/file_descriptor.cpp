#include "system/file_descriptor.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <poll.h>
#include <sys/file.h>
#include <sys/mman.h>
#include <sys/stat.h>

#include <fmt/core.h>

#include "base/error.h"

namespace rotatebook::system {
namespace {

struct stat statusOf(const FileDescriptor& file) {
  struct stat status {};
  fstat(file.number(), &status);
  return status;
}

/// Returns whether `path` still is the name of the file.
bool isNamed(const FileDescriptor& file, const std::filesystem::path& path) {
  struct stat there {};
  const struct stat here = statusOf(file);
  return lstat(path.c_str(), &there) == 0 && there.st_dev == here.st_dev &&
         there.st_ino == here.st_ino;
}

}  // namespace

Locking tryLock(const FileDescriptor& file, Lock lock) {
  const int operation = lock == Lock::Shared ? LOCK_SH : LOCK_EX;
  if (flock(file.number(), operation | LOCK_NB) == 0) return Locking::Held;
  return errno == EWOULDBLOCK ? Locking::Refused : Locking::Lockless;
}

FileDescriptor createLocked(const std::filesystem::path& path, Lock lock) {
  while (true) {
    // O_NOFOLLOW: no link may redirect it. O_NONBLOCK: it doesn't wait for a pipe's reader.
    FileDescriptor file(
        open(path.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK, 0666));
    if (!file.isOpen()) return {};
    if (!S_ISREG(statusOf(file).st_mode)) {
      errno = ENXIO;
      return {};
    }
    if (tryLock(file, lock) == Locking::Refused) return {};
    // Another process or thread may have removed it, or given it its final name, before it was
    // locked: then this is somebody's finished file.
    if (!isNamed(file, path)) continue;
    if (ftruncate(file.number(), 0) != 0) return {};
    return file;
  }
}

FileDescriptor createMemoryFile(const char* purpose) {
  FileDescriptor file(memfd_create(purpose, MFD_CLOEXEC));
  if (!file.isOpen()) {
    throw MachineError(std::string("can't make a file in memory: ") + std::strerror(errno));
  }
  return file;
}

namespace {

/// Returns whether what failed to be written can be tried again, for a pipe that doesn't wait once
/// there is room in it.
bool canTryAgain(const FileDescriptor& file) {
  if (errno == EINTR) return true;
  if (errno != EAGAIN) return false;
  constexpr int kForEver = -1;
  pollfd room{file.number(), POLLOUT, 0};
  poll(&room, 1, kForEver);
  return true;
}

}  // namespace

void writeAll(const FileDescriptor& file, std::string_view content,
              const std::filesystem::path& path) {
  while (!content.empty()) {
    const ssize_t written = ::write(file.number(), content.data(), content.size());
    if (written < 0 && canTryAgain(file)) continue;
    if (written < 0) throwLastError(path, "write");
    content.remove_prefix(static_cast<std::size_t>(written));
  }
}

bool readBlocks(const FileDescriptor& file, const std::function<void(std::string_view)>& take) {
  std::array<char, 65536> block;
  for (off_t at = 0;;) {
    const ssize_t size = pread(file.number(), block.data(), block.size(), at);
    if (size == 0) return true;
    if (size < 0 && errno == EINTR) continue;
    if (size < 0) return false;
    take({block.data(), static_cast<std::size_t>(size)});
    at += size;
  }
}

std::string readAll(const FileDescriptor& file, const std::filesystem::path& path) {
  std::string bytes;
  if (!readBlocks(file, [&](std::string_view block) { bytes += block; })) {
    throwLastError(path, "read");
  }
  return bytes;
}

ErrorKind kindOfError(int error) {
  constexpr std::array kTransient{EAGAIN, EBUSY,  EDQUOT, EHOSTDOWN, EINTR,  EIO,      EMFILE,
                                  ENFILE, ENOLCK, ENOMEM, ENOSPC,    ESTALE, ETIMEDOUT};
  return std::ranges::count(kTransient, error) > 0 ? ErrorKind::Transient : ErrorKind::Machine;
}

void throwLastError(const std::filesystem::path& path, std::string_view action) {
  const int error = errno;
  throw MachineError(fmt::format("can't {} {}: {}", action, path.string(), std::strerror(error)),
                     kindOfError(error));
}

}  // namespace rotatebook::system
