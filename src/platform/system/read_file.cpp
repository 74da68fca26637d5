#include "system/read_file.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <string_view>
#include <sys/stat.h>
#include <unistd.h>

#include <fmt/core.h>

#include "base/error.h"

namespace rotatebook::system {
namespace {

[[noreturn]] void fail(int error) {
  throw InputError(std::strerror(error));
}

[[noreturn]] void failLong(const std::string& size, std::uintmax_t limit) {
  throw InputError(fmt::format("it has {} bytes; the limit is {}", size, limit));
}

}  // namespace

std::string nameOfInput(const std::string& path) {
  return path == kStandardInput ? kNameOfInput : path;
}

FileDescriptor openFile(const std::filesystem::path& path) {
  // O_NONBLOCK: otherwise opening a pipe waits for its writer.
  FileDescriptor file(open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC));
  struct stat status {};
  if (!file.isOpen() || fstat(file.number(), &status) != 0) fail(errno);
  if (S_ISDIR(status.st_mode)) fail(EISDIR);
  if (S_ISFIFO(status.st_mode)) throw InputError("it is a pipe, not a file");
  if (!S_ISREG(status.st_mode)) throw InputError("it is a device, not a file");
  return file;
}

std::string readFile(const std::filesystem::path& path, std::uintmax_t limit) {
  const FileDescriptor file = openFile(path);
  const auto size =
      static_cast<std::uintmax_t>(std::max<off_t>(lseek(file.number(), 0, SEEK_END), 0));
  if (size > limit) failLong(std::to_string(size), limit);
  std::string bytes;
  bytes.reserve(size);
  const auto take = [&](std::string_view block) {
    bytes += block;
    // A file may grow, and some of the kernel's don't report their size.
    if (bytes.size() > limit) failLong(fmt::format("over {}", limit), limit);
  };
  if (!readBlocks(file, take)) throwLastError(path, "read");
  return bytes;
}

namespace {

std::string readStandardInput(std::uintmax_t limit) {
  std::string bytes;
  for (char block[1 << 16];;) {
    const ssize_t size = read(STDIN_FILENO, block, sizeof(block));
    if (size < 0 && errno == EINTR) continue;
    if (size < 0) fail(errno);
    if (size == 0) break;
    bytes.append(block, static_cast<std::size_t>(size));
    if (bytes.size() > limit) failLong(fmt::format("over {}", limit), limit);
  }
  if (bytes.empty()) throw InputError("it is empty, or was read already");
  return bytes;
}

}  // namespace

std::string readFileOrInput(const std::filesystem::path& path, std::uintmax_t limit) {
  return path == kStandardInput ? readStandardInput(limit) : readFile(path, limit);
}

std::string readInput(const std::filesystem::path& path, std::uintmax_t limit) {
  try {
    return readFile(path, limit);
  } catch (const InputError& error) {
    throw InputError(fmt::format("can't read {}: {}", path.string(), error.what()));
  }
}

std::string readFileOrEmpty(const std::filesystem::path& path, std::uintmax_t limit) {
  try {
    return readFile(path, limit);
  } catch (const Error&) {
    return {};
  }
}

}  // namespace rotatebook::system
