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

  /// Returns the frames in folder() that have no line and, if `changed`, those that have other
  /// bytes than were listed, ascending. Reads only files that were written or moved since the lines
  /// were.
  std::vector<std::int64_t> foreignFrames(bool changed) const;

  /// Appends the line of frame `index`, whose file has just been written with these bytes, unless
  /// the line was there from the start. May be called from any thread; the other functions don't
  /// see the line before sort(). Throws MachineError.
  void add(std::int64_t index, std::string_view bytes);

  /// Throws MachineError if the file of one of these frames is gone, or has other bytes than were
  /// passed to add() or found by intact(), and names the first. Reads only files whose size, times
  /// or inode changed since.
  void requireUnchanged(FrameRange frames) const;

  /// Rewrites the file with one line a frame, in order, even if it was removed meanwhile. Throws
  /// MachineError, also if one of these frames has no line.
  void sort(FrameRange frames);

 private:
  using Checksums = std::map<std::int64_t, std::string>;

  /// The state of a file that changes whenever somebody writes to it.
  struct Stamp {
    std::uint64_t inode = 0;  ///< 0 where there is no file.
    std::int64_t size = 0, modified = 0, changed = 0;

    friend bool operator==(const Stamp&, const Stamp&) = default;
  };

  static Checksums parse(const std::string& text);
  static Stamp stampOf(const std::filesystem::path& file);
  void keepStamp(std::int64_t index, const Stamp& stamp) const;
  void openFile();
  Checksums present() const;

  std::filesystem::path folder_, path_;
  Checksums checksums_;
  mutable std::mutex mutex_;
  mutable std::vector<Stamp> stamps_;  // By frame, of those that were written or found intact.
  system::FileDescriptor file_;        // Open from the first added line until sort().
};

}  // namespace rotatebook::store
