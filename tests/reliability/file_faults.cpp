// Calls of the operating system that change files, or read them.
#include <array>
#include <cstdarg>
#include <fcntl.h>
#include <string>
#include <sys/stat.h>
#include <sys/uio.h>
#include <unistd.h>

#include "reliability/faults.h"

namespace {

using rotatebook::faults::failsAt;
using rotatebook::faults::isWanted;
using rotatebook::faults::next;
using rotatebook::faults::redirected;

std::string pathOf(int descriptor) {
  std::array<char, 4096> path;
  const std::string link = "/proc/self/fd/" + std::to_string(descriptor);
  const ssize_t length = readlink(link.c_str(), path.data(), path.size());
  return length > 0 ? std::string(path.data(), static_cast<std::size_t>(length)) : std::string();
}

bool writes(int flags) {
  return (flags & O_ACCMODE) != O_RDONLY;
}

using Open = int(const char*, int, ...);

int openNext(const char* name, const char* path, int flags, mode_t mode) {
  if (writes(flags)) rotatebook::faults::meet(path);
  if (writes(flags) && failsAt("open", path)) return -1;
  return next<Open>(name)(redirected(path), flags, mode);
}

/// Not one of any change.
bool readFails(int file) {
  return isWanted("read") && failsAt("read", pathOf(file));
}

}  // namespace

extern "C" {

int open(const char* path, int flags, ...) {
  va_list arguments;
  va_start(arguments, flags);
  const mode_t mode = (flags & O_CREAT) != 0 ? va_arg(arguments, mode_t) : 0;
  va_end(arguments);
  return openNext("open", path, flags, mode);
}

int open64(const char* path, int flags, ...) {
  va_list arguments;
  va_start(arguments, flags);
  const mode_t mode = (flags & O_CREAT) != 0 ? va_arg(arguments, mode_t) : 0;
  va_end(arguments);
  return openNext("open64", path, flags, mode);
}

ssize_t read(int file, void* bytes, size_t size) {
  if (readFails(file)) return -1;
  return next<ssize_t(int, void*, size_t)>("read")(file, bytes, size);
}

ssize_t pread(int file, void* bytes, size_t size, off_t at) {
  if (readFails(file)) return -1;
  return next<ssize_t(int, void*, size_t, off_t)>("pread")(file, bytes, size, at);
}

ssize_t pread64(int file, void* bytes, size_t size, off_t at) {
  if (readFails(file)) return -1;
  return next<ssize_t(int, void*, size_t, off_t)>("pread64")(file, bytes, size, at);
}

ssize_t write(int file, const void* bytes, size_t size) {
  if (failsAt("write", pathOf(file))) return -1;
  return next<ssize_t(int, const void*, size_t)>("write")(file, bytes, size);
}

ssize_t writev(int file, const iovec* parts, int count) {
  if (failsAt("write", pathOf(file))) return -1;
  return next<ssize_t(int, const iovec*, int)>("writev")(file, parts, count);
}

int fsync(int file) {
  return failsAt("flush", pathOf(file)) ? -1 : next<int(int)>("fsync")(file);
}

int fdatasync(int file) {
  return failsAt("flush", pathOf(file)) ? -1 : next<int(int)>("fdatasync")(file);
}

int rename(const char* from, const char* to) {
  return failsAt("rename", from) ? -1 : next<int(const char*, const char*)>("rename")(from, to);
}

int link(const char* from, const char* to) {
  return failsAt("link", from) ? -1 : next<int(const char*, const char*)>("link")(from, to);
}

int remove(const char* path) {
  return failsAt("remove", path) ? -1 : next<int(const char*)>("remove")(path);
}

int mkdir(const char* path, mode_t mode) {
  return failsAt("mkdir", path) ? -1 : next<int(const char*, mode_t)>("mkdir")(path, mode);
}

}  // extern "C"
