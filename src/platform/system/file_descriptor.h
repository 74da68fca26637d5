// Files as the operating system has them.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <unistd.h>
#include <utility>

namespace rotatebook::system {

/// Owns a descriptor, or none, which is -1.
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

/// Who else may lock a file while it is locked.
enum class Lock { Shared, Exclusive };

/// False if another process, or another descriptor of this one, has a lock that forbids it. True
/// where the file system has no locks, too.
bool tryLock(const FileDescriptor& file, Lock lock);

/// Opens an empty file of that name for writing, new or in the place of an old one, and locks it.
/// A closed descriptor, and errno, if it can't be opened (its cause; ENXIO for pipes and devices)
/// or locked (EWOULDBLOCK).
FileDescriptor createLocked(const std::filesystem::path& path, Lock lock);

/// A file without a name, for reading and writing, that is gone once nobody has it open. `purpose`
/// is for who debugs. Throws MachineError.
FileDescriptor createMemoryFile(const char* purpose);

/// Writes all of `content`. Throws MachineError "can't write `path`: CAUSE".
void writeAll(const FileDescriptor& file, std::string_view content,
              const std::filesystem::path& path);

/// Gives `take` all that the file holds, from its start, block by block. False, and errno, if it
/// can't be read.
bool readBlocks(const FileDescriptor& file, const std::function<void(std::string_view)>& take);

/// All that the file holds, from its start, even if it was removed. Throws MachineError "can't read
/// `path`: CAUSE".
std::string readAll(const FileDescriptor& file, const std::filesystem::path& path);

/// Throws MachineError "can't `action` `path`: CAUSE", the cause being that of errno.
[[noreturn]] void throwLastError(const std::filesystem::path& path, std::string_view action);

}  // namespace rotatebook::system
