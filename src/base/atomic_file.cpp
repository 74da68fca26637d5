#include "base/atomic_file.h"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <fstream>
#include <system_error>
#include <unistd.h>
#include <utility>

#include "base/error.h"

namespace rotatebook {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void throwLastError(const fs::path& path, const char* action) {
  throw MachineError("can't " + std::string(action) + " " + path.string() + ": " +
                     std::strerror(errno));
}

fs::path temporaryNameFor(const fs::path& path) {
  const std::string name = "." + path.filename().string() + ".tmp-" + std::to_string(getpid());
  return path.parent_path() / name;
}

// A rename is only safe against a power cut once the content itself has reached the disk.
void flushToDisk(const fs::path& path) {
  const int descriptor = open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) throwLastError(path, "reopen");
  const int failed = fdatasync(descriptor);
  const int error = errno;
  close(descriptor);
  errno = error;
  if (failed != 0) throwLastError(path, "flush");
}

}  // namespace

AtomicFile::AtomicFile(fs::path finalPath)
    : finalPath_(std::move(finalPath)), temporaryPath_(temporaryNameFor(finalPath_)) {
  // A rename would put a plain file in the place of a device or a pipe.
  if (fs::exists(finalPath_) && !fs::is_regular_file(finalPath_)) {
    throw MachineError("can't write " + finalPath_.string() + ": it is " +
                       (fs::is_directory(finalPath_) ? "a folder" : "not a regular file"));
  }
  const int flags = O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC;
  const int descriptor = open(temporaryPath_.c_str(), flags, 0666);
  if (descriptor < 0) throwLastError(finalPath_, "write");
  close(descriptor);
}

AtomicFile::~AtomicFile() {
  std::error_code ignored;
  if (!committed_) fs::remove(temporaryPath_, ignored);
}

void AtomicFile::commitAs(const fs::path& path) {
  flushToDisk(temporaryPath_);
  if (std::rename(temporaryPath_.c_str(), path.c_str()) != 0) {
    throwLastError(path, "rename the finished file to");
  }
  committed_ = true;
}

void writeFileAtomically(const fs::path& path, std::string_view content) {
  AtomicFile file(path);
  std::ofstream stream(file.temporaryPath(), std::ios::binary);
  stream.write(content.data(), static_cast<std::streamsize>(content.size()));
  stream.close();
  if (!stream) throwLastError(path, "write");
  file.commit();
}

void createFolders(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error)
    throw MachineError("can't make the folder " + folder.string() + ": " + error.message());
  if (!fs::is_directory(folder)) {
    throw MachineError("can't make the folder " + folder.string() + ": a file has that name");
  }
}

}  // namespace rotatebook
