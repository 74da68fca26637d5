// A library to be loaded before all others (LD_PRELOAD), which makes one call of the operating
// system fail, or kills the process in its place.
//
// ROTATEBOOK_FAULT is CALL:NUMBER:FAULT. CALL is open, write, flush, rename, remove or mkdir, or
// any; of the calls that change something below the folder ROTATEBOOK_FAULT_BELOW, the one of that
// NUMBER, from 1, and, but for kill, all later ones have the FAULT: kill, or the number of an
// error.
#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <dlfcn.h>
#include <fcntl.h>
#include <string>
#include <string_view>
#include <sys/stat.h>
#include <sys/uio.h>
#include <unistd.h>

namespace {

struct Fault {
  std::string call, below;
  long number = 0;
  int error = 0;  // 0: kill
};

std::string variable(const char* name) {
  const char* value = std::getenv(name);
  return value != nullptr ? value : "";
}

const Fault& fault() {
  static const Fault wanted = [] {
    Fault read;
    const std::string text = variable("ROTATEBOOK_FAULT");
    const std::size_t first = text.find(':'), second = text.find(':', first + 1);
    if (second == std::string::npos) return read;
    read.call = text.substr(0, first);
    read.number = std::strtol(&text[first + 1], nullptr, 10);
    read.error = static_cast<int>(std::strtol(&text[second + 1], nullptr, 10));
    read.below = variable("ROTATEBOOK_FAULT_BELOW");
    return read;
  }();
  return wanted;
}

bool isBelow(std::string path) {
  if (!path.starts_with('/')) {
    std::array<char, 4096> folder;
    if (getcwd(folder.data(), folder.size()) == nullptr) return false;
    path = std::string(folder.data()) + '/' + path;
  }
  return path.starts_with(fault().below);
}

std::string pathOf(int descriptor) {
  std::array<char, 4096> path;
  const std::string link = "/proc/self/fd/" + std::to_string(descriptor);
  const ssize_t length = readlink(link.c_str(), path.data(), path.size());
  return length > 0 ? std::string(path.data(), static_cast<std::size_t>(length)) : std::string();
}

/// Whether this call is to fail; sets errno then.
bool fails(std::string_view call, const std::string& path) {
  static std::atomic<long> count = 0;
  const Fault& wanted = fault();
  if (wanted.number == 0 || (wanted.call != call && wanted.call != "any")) return false;
  if (!isBelow(path) || ++count < wanted.number) return false;
  if (wanted.error == 0) raise(SIGKILL);
  errno = wanted.error;
  return true;
}

template <typename Function>
Function* next(const char* name) {
  return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

bool writes(int flags) {
  return (flags & O_ACCMODE) != O_RDONLY;
}

using Open = int(const char*, int, ...);

int openNext(const char* name, const char* path, int flags, mode_t mode) {
  if (writes(flags) && fails("open", path)) return -1;
  return next<Open>(name)(path, flags, mode);
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

ssize_t write(int file, const void* bytes, size_t size) {
  if (fails("write", pathOf(file))) return -1;
  return next<ssize_t(int, const void*, size_t)>("write")(file, bytes, size);
}

ssize_t writev(int file, const iovec* parts, int count) {
  if (fails("write", pathOf(file))) return -1;
  return next<ssize_t(int, const iovec*, int)>("writev")(file, parts, count);
}

int fsync(int file) {
  return fails("flush", pathOf(file)) ? -1 : next<int(int)>("fsync")(file);
}

int fdatasync(int file) {
  return fails("flush", pathOf(file)) ? -1 : next<int(int)>("fdatasync")(file);
}

int rename(const char* from, const char* to) {
  return fails("rename", from) ? -1 : next<int(const char*, const char*)>("rename")(from, to);
}

int remove(const char* path) {
  return fails("remove", path) ? -1 : next<int(const char*)>("remove")(path);
}

int mkdir(const char* path, mode_t mode) {
  return fails("mkdir", path) ? -1 : next<int(const char*, mode_t)>("mkdir")(path, mode);
}

}  // extern "C"
