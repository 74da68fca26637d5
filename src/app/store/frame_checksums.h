// The checksums of a folder's frames.
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

/// frames.xxh128: a line for each frame, as xxh128sum writes and checks it, added once the frame is
/// whole. A run that is killed leaves the lines of what it finished.
class FrameChecksums {
 public:
  /// Reads the lines that are there; one that was cut off is let go. `folder` exists. Throws
  /// MachineError.
  explicit FrameChecksums(std::filesystem::path folder);

  const std::filesystem::path& folder() const { return folder_; }

  /// The bytes of frame `index` if its file is there as it was written.
  std::optional<std::string> intact(std::int64_t index) const;
  /// Whether frame `index` has a line.
  bool knows(std::int64_t index) const { return sums_.contains(index); }

  /// The frames that have a line, ascending.
  std::vector<std::int64_t> known() const;

  /// Adds that frame `index` was written with these bytes. From any thread, but no line that is
  /// added is known to intact(). Throws MachineError.
  void add(std::int64_t index, std::string_view bytes);

  /// Throws MachineError, naming the first, if the file of one of these frames is gone.
  void requireFiles(FrameRange frames) const;

  /// Writes the file anew, one line a frame, in order, though it were removed meanwhile. Throws
  /// MachineError, also if one of these frames has no line.
  void sort(FrameRange frames);

 private:
  using Sums = std::map<std::int64_t, std::string>;

  static Sums parse(const std::string& text);
  void openFile();

  std::filesystem::path folder_, path_;
  Sums sums_;
  std::mutex mutex_;
  system::FileDescriptor file_;  // Open once a line was added.
};

/// The name of the file.
inline constexpr const char* kFrameSumsName = "frames.xxh128";

}  // namespace rotatebook::store
