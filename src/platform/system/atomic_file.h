// Files that are complete or not there at all.
#pragma once

#include <filesystem>
#include <string_view>

#include "system/file_descriptor.h"

namespace rotatebook::system {

/// A file on its way: written under a temporary name beside the final one, renamed by commit().
/// Without commit() the destructor removes it, so that a final name never holds half a file.
///
/// The temporary file is locked (flock) while this lives: one that nobody holds was left by a
/// process that was killed. The first file that a process writes into a folder takes those away.
class AtomicFile {
 public:
  /// Throws MachineError if the folder of `finalPath` doesn't exist or can't be written, or if
  /// `finalPath` is there but no regular file.
  explicit AtomicFile(std::filesystem::path finalPath);
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;
  ~AtomicFile();

  /// The temporary name, `.NAME.rotatebook-PID`, for whoever writes the content otherwise.
  const std::filesystem::path& temporaryPath() const { return temporaryPath_; }
  const std::filesystem::path& finalPath() const { return finalPath_; }

  /// Appends to the content. Throws MachineError.
  void write(std::string_view content);

  /// Flushes the content to the disk and renames it, replacing an older file. Whoever wrote the
  /// content has closed it before. Throws MachineError.
  void commit() { commitAs(finalPath_); }
  /// The same under another name in the same folder.
  void commitAs(const std::filesystem::path& path);

 private:
  std::filesystem::path finalPath_;
  std::filesystem::path temporaryPath_;
  FileDescriptor held_;
  bool committed_ = false;
};

/// Says to other processes that something is in use, while this lives: by a locked file beside it,
/// `.NAME.rotatebook-0`. Does nothing where the file system has no locks.
class AdvisoryLock {
 public:
  /// `path` names what is used, which needn't be there, but its folder. Throws MachineError if
  /// another process has an exclusive lock of it, or any lock and this one is to be exclusive.
  AdvisoryLock(const std::filesystem::path& path, Lock lock);
  AdvisoryLock(const AdvisoryLock&) = delete;
  AdvisoryLock& operator=(const AdvisoryLock&) = delete;
  ~AdvisoryLock();

 private:
  std::filesystem::path path_;
  FileDescriptor file_;
};

/// Removes the temporary files in `folder` whose writers are dead. What can't be removed stays; it
/// hurts nobody. Nothing happens if there is no such folder.
void removeStaleTemporaries(const std::filesystem::path& folder);

/// Brings the names of what is in `folder` to the disk, after renames. Throws MachineError.
void flushFolder(const std::filesystem::path& folder);

/// Throws MachineError if `path` is a folder, a device or a pipe, which no file may take the place
/// of.
void requireReplaceable(const std::filesystem::path& path);

/// Writes `content` to `path`, all of it or nothing. Throws MachineError.
void writeFileAtomically(const std::filesystem::path& path, std::string_view content);

/// Removes `path` if it is there. Throws MachineError.
void removeFile(const std::filesystem::path& path);

/// Makes `folder` and its parents. Throws MachineError.
void createFolders(const std::filesystem::path& folder);

}  // namespace rotatebook::system
