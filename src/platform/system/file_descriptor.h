// File descriptors: their ownership, locks, reading and writing.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <unistd.h>
#include <utility>

#include "base/error.h"

namespace rotatebook::system {

/// Owns a file descriptor, or none (-1).
class FileDescriptor {
 public:
  FileDescriptor() = default;
  explicit FileDescriptor(int number) : number_(number) {}
  FileDescriptor(FileDescriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  FileDescriptor& operator=(FileDescriptor&& other) noexcept {
    std::swap(number_, other.number_);
    return *this;
  }
  ~FileDescriptor() {
    if (isOpen()) close(number_);
  }

  bool isOpen() const { return number_ >= 0; }
  int number() const { return number_; }

 private:
  int number_ = -1;
};

/// Kinds of lock: any number of Shared ones at a time, or one Exclusive.
enum class Lock { Shared, Exclusive };

/// The result of tryLock().
enum class Locking {
  Held,      ///< The descriptor has the lock.
  Refused,   ///< Another process, or another descriptor of this one, has a conflicting lock.
  Lockless,  ///< The file system has no locks.
};

/// Locks the file, if no other lock is in the way, until the descriptor is closed.
Locking tryLock(const FileDescriptor& file, Lock lock);

/// Opens a file for writing, created or emptied, and locks it, where the file system has locks.
/// Returns a closed descriptor and sets errno if it can't be opened (the cause; ENXIO for pipes and
/// devices) or locked (EWOULDBLOCK).
FileDescriptor createLocked(const std::filesystem::path& path, Lock lock);

/// Creates a file without a name, for reading and writing, which disappears once nobody has it
/// open. `purpose` is a label for debugging. Throws MachineError.
FileDescriptor createMemoryFile(const char* purpose);

/// Writes all of `content`, also to a pipe that is full and doesn't wait. Throws MachineError
/// "can't write `path`: CAUSE".
void writeAll(const FileDescriptor& file, std::string_view content,
              const std::filesystem::path& path);

/// Passes the file's content to `take`, from its start, block by block. Returns false and sets
/// errno if it can't be read.
bool readBlocks(const FileDescriptor& file, const std::function<void(std::string_view)>& take);

/// Returns the file's content, from its start, even if its name was removed. Throws MachineError
/// "can't read `path`: CAUSE".
std::string readAll(const FileDescriptor& file, const std::filesystem::path& path);

/// Returns whether what failed with the number `error` of the operating system may succeed another
/// time, or on another machine: a full disk or none that answers, a lack of memory, of files that
/// may be open.
ErrorKind kindOfError(int error);

/// Throws MachineError "can't `action` `path`: CAUSE", with the cause that errno names, of the kind
/// kindOfError().
[[noreturn]] void throwLastError(const std::filesystem::path& path, std::string_view action);

}  // namespace rotatebook::system
