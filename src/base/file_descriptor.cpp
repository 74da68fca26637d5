#include "base/file_descriptor.h"

#include <array>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/mman.h>
#include <sys/stat.h>

#include "base/error.h"

namespace rotatebook {
namespace {

/// Whether somebody removed it before it was locked.
bool wasRemoved(const FileDescriptor& file) {
  struct stat status {};
  return fstat(file.number(), &status) == 0 && status.st_nlink == 0;
}

}  // namespace

bool tryLock(const FileDescriptor& file, Lock lock) {
  const int operation = lock == Lock::Shared ? LOCK_SH : LOCK_EX;
  return flock(file.number(), operation | LOCK_NB) == 0 || errno != EWOULDBLOCK;
}

FileDescriptor createLocked(const std::filesystem::path& path, Lock lock) {
  while (true) {
    // Nobody may lead it elsewhere by a link.
    FileDescriptor file(open(path.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0666));
    if (!file.isOpen() || !tryLock(file, lock)) return {};
    if (wasRemoved(file)) continue;
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

void writeAll(const FileDescriptor& file, std::string_view content,
              const std::filesystem::path& path) {
  while (!content.empty()) {
    const ssize_t written = ::write(file.number(), content.data(), content.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) throwLastError(path, "write");
    content.remove_prefix(static_cast<std::size_t>(written));
  }
}

ssize_t appendBlock(const FileDescriptor& file, std::string& bytes) {
  std::array<char, 65536> block;
  ssize_t size = 0;
  do {
    size = pread(file.number(), block.data(), block.size(), static_cast<off_t>(bytes.size()));
  } while (size < 0 && errno == EINTR);
  if (size > 0) bytes.append(block.data(), static_cast<std::size_t>(size));
  return size;
}

std::string readAll(const FileDescriptor& file, const std::filesystem::path& path) {
  std::string bytes;
  ssize_t size = 0;
  while ((size = appendBlock(file, bytes)) > 0) continue;
  if (size < 0) throwLastError(path, "read");
  return bytes;
}

void throwLastError(const std::filesystem::path& path, std::string_view action) {
  throw MachineError("can't " + std::string(action) + " " + path.string() + ": " +
                     std::strerror(errno));
}

}  // namespace rotatebook
