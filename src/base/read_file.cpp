#include "base/read_file.h"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/error.h"
#include "base/file_descriptor.h"

namespace rotatebook {
namespace {

[[noreturn]] void fail(int error) {
  throw InputError(std::strerror(error));
}

[[noreturn]] void failLong(const std::string& size, std::uintmax_t most) {
  throw InputError("it has " + size + " bytes; the limit is " + std::to_string(most));
}

/// Its size; refuses what is no file, or too long.
std::uintmax_t checkedSize(const FileDescriptor& file, std::uintmax_t most) {
  struct stat status {};
  if (fstat(file.number(), &status) != 0) fail(errno);
  if (S_ISDIR(status.st_mode)) fail(EISDIR);
  if (S_ISFIFO(status.st_mode)) throw InputError("it is a pipe, not a file");
  if (!S_ISREG(status.st_mode)) throw InputError("it is a device, not a file");
  const auto size = static_cast<std::uintmax_t>(status.st_size);
  if (size > most) failLong(std::to_string(size), most);
  return size;
}

}  // namespace

std::string readFile(const std::filesystem::path& path, std::uintmax_t most) {
  // A pipe that nobody writes into would be waited for otherwise.
  const FileDescriptor file(open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC));
  if (!file.isOpen()) fail(errno);
  std::string bytes;
  bytes.reserve(checkedSize(file, most));
  for (ssize_t size = 0; (size = appendBlock(file, bytes)) != 0;) {
    if (size < 0) fail(errno);
    // It may grow, and some of the kernel's don't tell their size.
    if (bytes.size() > most) failLong("over " + std::to_string(most), most);
  }
  return bytes;
}

std::string readFileOrEmpty(const std::filesystem::path& path, std::uintmax_t most) {
  try {
    return readFile(path, most);
  } catch (const InputError&) {
    return {};
  }
}

}  // namespace rotatebook
