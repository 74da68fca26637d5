// Files that are either complete or absent.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "system/file_descriptor.h"

namespace rotatebook::system {

/// A file that is written under a temporary name beside the final one and renamed by commit().
/// Without commit() the destructor removes it, so that a final name never holds half a file.
///
/// The temporary file is locked (flock) while this object lives. The first file that a process
/// writes into a folder removes those that killed processes left there; see temporary_files.h.
class AtomicFile {
 public:
  /// Creates the temporary file. Throws MachineError if the folder of `finalPath` doesn't exist or
  /// can't be written, or if `finalPath` exists but isn't a regular file.
  explicit AtomicFile(std::filesystem::path finalPath);
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;
  ~AtomicFile();

  /// The temporary name, temporaryNameFor(), for a caller that writes the content itself.
  const std::filesystem::path& temporaryPath() const { return temporaryPath_; }
  const std::filesystem::path& finalPath() const { return finalPath_; }

  /// Appends to the content. Throws MachineError.
  void write(std::string_view content);

  /// Flushes the content to the disk and renames the file, replacing an older one. A caller that
  /// wrote through temporaryPath() must have closed it. Throws MachineError.
  void commit() { commitAs(finalPath_); }
  /// Like commit(), but leaves the flushing to the system: after a power cut, the name may hold
  /// half of the content, or none. For what is checked when it is read, and can be made again.
  void commitUnflushed();
  /// Like commit(), under another name in the same folder.
  void commitAs(const std::filesystem::path& path);
  /// Like commit(), but replaces nothing: returns false, and leaves what is there, if the name is
  /// taken. Of several processes, also on several machines, one alone gets true; on file systems
  /// that have neither hard links nor renames without replacing, those at the same instant may all.
  bool commitIfNew();

 private:
  void renameTo(const std::filesystem::path& path);
  bool renameIfNew();

  std::filesystem::path finalPath_;
  std::filesystem::path temporaryPath_;
  FileDescriptor held_;
  bool committed_ = false;
};

/// Marks a path as in use, for other processes, while this object lives: by a locked file beside
/// it, lockNameFor(). Does nothing where the file system has no locks.
class AdvisoryLock {
 public:
  /// Locks `path`, which needn't exist, though its folder must. Throws MachineError if another
  /// process has an exclusive lock on it, or any lock if this one is to be exclusive.
  AdvisoryLock(const std::filesystem::path& path, Lock lock);
  AdvisoryLock(const AdvisoryLock&) = delete;
  AdvisoryLock& operator=(const AdvisoryLock&) = delete;
  ~AdvisoryLock();

 private:
  std::filesystem::path path_;
  FileDescriptor file_;
};

/// Flushes the names of the files in `folder` to the disk, after renames. Throws MachineError.
void flushFolder(const std::filesystem::path& folder);

/// Throws MachineError if `path` is a folder, a device or a pipe, which no file may replace.
void requireReplaceable(const std::filesystem::path& path);

/// Writes `content` to `path`, all of it or nothing. Throws MachineError.
void writeFileAtomically(const std::filesystem::path& path, std::string_view content);

/// Writes `content` to `path` unless that exists, as AtomicFile::commitIfNew() does; returns
/// whether it did. Throws MachineError.
bool createFileAtomically(const std::filesystem::path& path, std::string_view content);

/// Removes `path` if it exists. Throws MachineError.
void removeFile(const std::filesystem::path& path);

/// Creates `folder` and its parents. Throws MachineError.
void createFolders(const std::filesystem::path& folder);

}  // namespace rotatebook::system
