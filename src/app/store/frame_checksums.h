// Checksums of a folder's frames.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "store/clip_files.h"
#include "system/file_descriptor.h"

namespace rotatebook::store {

/// The file frames.xxh128: one line a frame, in the format of xxh128sum, added once the frame is
/// complete. A killed run leaves the lines of the frames that it finished.
class FrameChecksums {
 public:
  /// Reads the existing lines and ignores one that was cut off. `folder` must exist. Throws
  /// MachineError.
  explicit FrameChecksums(std::filesystem::path folder);

  const std::filesystem::path& folder() const { return folder_; }

  /// Returns the bytes of frame `index` if its file still has its checksum.
  std::optional<std::string> intact(std::int64_t index) const;
  /// Returns whether frame `index` has a line.
  bool contains(std::int64_t index) const { return checksums_.contains(index); }

  /// Returns the indices of the frames that have a line, ascending.
  std::vector<std::int64_t> indices() const;

  /// Appends the line of frame `index`, whose file has these bytes. May be called from any thread;
  /// the other functions don't see the line before sort(). Throws MachineError.
  void add(std::int64_t index, std::string_view bytes);

  /// Throws MachineError if the file of one of these frames is gone, and names the first.
  void requireFiles(FrameRange frames) const;

  /// Rewrites the file with one line a frame, in order, even if it was removed meanwhile. Throws
  /// MachineError, also if one of these frames has no line.
  void sort(FrameRange frames);

 private:
  using Checksums = std::map<std::int64_t, std::string>;

  static Checksums parse(const std::string& text);
  void openFile();

  std::filesystem::path folder_, path_;
  Checksums checksums_;
  std::mutex mutex_;
  system::FileDescriptor file_;  // Open from the first added line until sort().
};

}  // namespace rotatebook::store
