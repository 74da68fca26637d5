// Files that are complete or not there at all.
#pragma once

#include <filesystem>
#include <string_view>

namespace rotatebook {

/// A file on its way: written under a temporary name beside the final one, renamed by commit().
/// Without commit() the destructor removes it, so that a final name never holds half a file.
class AtomicFile {
 public:
  /// Throws MachineError if the folder of `finalPath` doesn't exist or can't be written, or if
  /// `finalPath` is there but no regular file.
  explicit AtomicFile(std::filesystem::path finalPath);
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;
  ~AtomicFile();

  /// The temporary name, `.NAME.tmp-PID`, for whoever writes the content.
  const std::filesystem::path& temporaryPath() const { return temporaryPath_; }
  const std::filesystem::path& finalPath() const { return finalPath_; }

  /// Flushes the content to the disk and renames it, replacing an older file. Whoever wrote the
  /// content has closed it before. Throws MachineError.
  void commit() { commitAs(finalPath_); }
  /// The same under another name in the same folder.
  void commitAs(const std::filesystem::path& path);

 private:
  std::filesystem::path finalPath_;
  std::filesystem::path temporaryPath_;
  bool committed_ = false;
};

/// Writes `content` to `path`, all of it or nothing. Throws MachineError.
void writeFileAtomically(const std::filesystem::path& path, std::string_view content);

/// Makes `folder` and its parents. Throws MachineError, naming the part that stands in the way.
void createFolders(const std::filesystem::path& folder);

}  // namespace rotatebook
