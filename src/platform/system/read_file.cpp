#include "system/read_file.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <string_view>
#include <sys/stat.h>
#include <unistd.h>

#include "base/error.h"

namespace rotatebook::system {
namespace {

[[noreturn]] void fail(int error) {
  throw InputError(std::strerror(error));
}

[[noreturn]] void failLong(const std::string& size, std::uintmax_t most) {
  throw InputError("it has " + size + " bytes; the limit is " + std::to_string(most));
}

}  // namespace

FileDescriptor openFile(const std::filesystem::path& path) {
  // A pipe that nobody writes into would be waited for otherwise.
  FileDescriptor file(open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC));
  struct stat status {};
  if (!file.isOpen() || fstat(file.number(), &status) != 0) fail(errno);
  if (S_ISDIR(status.st_mode)) fail(EISDIR);
  if (S_ISFIFO(status.st_mode)) throw InputError("it is a pipe, not a file");
  if (!S_ISREG(status.st_mode)) throw InputError("it is a device, not a file");
  return file;
}

std::string readFile(const std::filesystem::path& path, std::uintmax_t most) {
  const FileDescriptor file = openFile(path);
  const auto size =
      static_cast<std::uintmax_t>(std::max<off_t>(lseek(file.number(), 0, SEEK_END), 0));
  if (size > most) failLong(std::to_string(size), most);
  std::string bytes;
  bytes.reserve(size);
  const auto take = [&](std::string_view block) {
    bytes += block;
    // It may grow, and some of the kernel's don't tell their size.
    if (bytes.size() > most) failLong("over " + std::to_string(most), most);
  };
  if (!readBlocks(file, take)) throwLastError(path, "read");
  return bytes;
}

std::string readFileOrEmpty(const std::filesystem::path& path, std::uintmax_t most) {
  try {
    return readFile(path, most);
  } catch (const Error&) {
    return {};
  }
}

}  // namespace rotatebook::system
