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
///
/// Processes on several machines can't add to one file: network file systems lose lines then. Each
/// has a file of its own, partChecksumsName(), and all are read as one until sort() joins them.
class FrameChecksums {
 public:
  /// The file to which lines are added: that of all processes, or one of this process alone.
  enum class File { Shared, Own };

  /// Reads the existing lines and ignores one that was cut off. `folder` must exist. Throws
  /// MachineError.
  explicit FrameChecksums(std::filesystem::path folder, File file = File::Shared);

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

  /// Rewrites the file with one line a frame, in order, even if it was removed meanwhile, and
  /// removes those of single processes. Throws MachineError, also if one of these frames has no
  /// line.
  void sort(FrameRange frames);

  /// Completes a file of this process alone, if there is one: removes it if sort() of another
  /// process has taken its lines, else rewrites it with one line a frame. Throws MachineError.
  void finishOwn();

  /// Returns whether there are such files in `folder`.
  static bool existIn(const std::filesystem::path& folder);
  /// Removes the files in `folder`. Throws MachineError.
  static void removeFrom(const std::filesystem::path& folder);
  /// Returns the name of the files in `folder`, for a message: with a star if there are several.
  static std::filesystem::path filesIn(const std::filesystem::path& folder);

 private:
  using Checksums = std::map<std::int64_t, std::string>;

  /// The state of a file that changes whenever somebody writes to it.
  struct Stamp {
    std::uint64_t inode = 0;  ///< 0 where there is no file.
    std::int64_t size = 0, modified = 0, changed = 0;

    friend bool operator==(const Stamp&, const Stamp&) = default;
  };

  static Checksums parse(const std::string& text);
  static std::string textOf(const Checksums& checksums);
  static void readParts(const std::filesystem::path& folder, Checksums& checksums);
  static Stamp stampOf(const std::filesystem::path& file);
  void keepStamp(std::int64_t index, const Stamp& stamp) const;
  void openFile();
  Checksums present() const;

  std::filesystem::path folder_, path_;  // path_: of the file to which lines are added.
  Checksums checksums_;
  mutable std::mutex mutex_;
  mutable std::vector<Stamp> stamps_;  // By frame, of those that were written or found intact.
  system::FileDescriptor file_;        // Open from the first added line until sort().
};

}  // namespace rotatebook::store
