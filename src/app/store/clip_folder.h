// Management of the folder of a clip's frames: locks, earlier frames, replacement of an earlier
// clip.
#pragma once

#include <filesystem>
#include <list>
#include <optional>
#include <string>
#include <vector>

#include "store/clip_files.h"
#include "store/clip_settings.h"
#include "store/frame_checksums.h"
#include "store/manifest.h"
#include "store/other_settings.h"
#include "system/atomic_file.h"

namespace rotatebook::store {

/// The folder into which a render writes its frames. The frames of a whole clip go to
/// NAME.partial/, which replaces NAME/ in one step once all is done: files of two renders never
/// mix, whenever the process is killed. A replacement that a killed process began is completed by
/// the next one.
///
/// While this lives, no other process can render the same clip there; only parts of it may be
/// rendered side by side.
class ClipFolder {
 public:
  using Settings = ClipSettings;

  /// Throws InputError if there are frames that must not be lost or mixed, or another clip's file
  /// under the name of an output; MachineError if another process is rendering into the folder, or
  /// it can't be written, or not be replaced in the end.
  ClipFolder(const ClipFiles& files, const Settings& settings);
  ClipFolder(const ClipFolder&) = delete;
  ClipFolder& operator=(const ClipFolder&) = delete;
  /// Removes NAME.partial/ if it holds no frames.
  ~ClipFolder();

  /// Checksums of the frames in path(), including those of an earlier run.
  FrameChecksums& checksums() { return *checksums_; }
  const std::filesystem::path& path() const { return path_; }

  /// Returns how many frames a later render could resume from if this one failed now.
  std::size_t resumableFrames() const noexcept;

  /// Returns whether an earlier render finished the outputs, and `frames` if given, and none of
  /// them has changed since.
  bool isDone(std::optional<FrameRange> frames) const;

  /// Throws MachineError if an output, or one of `more` files that will be removed, can't be
  /// replaced: before the first frame rather than after all is drawn.
  void requireReplaceableOutputs(const std::vector<std::filesystem::path>& more) const;

  /// Moves the clip to its final name. `frames` is the range of PNGs that were written; without it,
  /// the frames of an earlier render stay in NAME/. Throws MachineError, also if a frame was
  /// removed or changed since it was written.
  void finish(std::optional<FrameRange> frames);
  /// Finishes a part, whose frames stay where they are. Throws likewise.
  void finishPart(FrameRange frames);

  /// Returns the outputs that remain from renders with other settings, once this one is finished:
  /// "out/a.mp4", "720 frames in out/a/".
  std::vector<std::string> keptOfOtherSettings() const;
  /// Returns those that this render, which is finished, replaced.
  std::vector<std::string> replacedOfOtherSettings() const;
  /// Returns why the clip that an earlier render replaced couldn't be removed; empty if it could.
  const std::string& remainder() const { return remainder_; }

 private:
  void openPart(const Settings& settings);
  void openWhole(const Settings& settings);
  void begin(const std::filesystem::path& folder, const std::string& record);
  void beginPart(std::optional<Manifest> there, const Settings& settings);
  Manifest manifestOfPart(const std::optional<Manifest>& there, const Settings& settings) const;
  void requireReplaceableFolder(bool png) const;
  void finishWithFrames(const Manifest::Entries& written);
  void finishWithoutFrames(const Manifest::Entries& written);
  std::size_t frameCount() const;
  void discardIfEmpty() const noexcept;

  system::AdvisoryLock lock_;
  std::list<system::AdvisoryLock> locks_;  ///< Of the outputs.
  ClipFiles files_;
  std::vector<std::filesystem::path> outputs_;
  std::string remainder_;
  Manifest manifest_;
  std::filesystem::path path_;
  std::optional<FrameChecksums> checksums_;
  std::optional<ReplacedOutputs> replaced_;
};

}  // namespace rotatebook::store
