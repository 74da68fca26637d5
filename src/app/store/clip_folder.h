// The folder of a clip's frames: who has it, what of it may stay, and how it takes the place of an
// earlier one.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "scene/scene.h"
#include "store/clip_files.h"
#include "store/frame_checksums.h"
#include "store/manifest.h"
#include "system/atomic_file.h"

namespace rotatebook::store {

/// What to do with what an earlier render left unfinished. Neither: it is an error if there is
/// something.
struct EarlierFrames {
  /// Go on with it if its settings are the same, else it is an error, though it were finished.
  bool resume = false;
  bool overwrite = false;  ///< Discard it; with `resume`, only if its settings differ.
};

/// Where a render puts its frames. Those of a whole clip go to NAME.partial/, which takes the place
/// of NAME/ once all is done, in one step: files of two renders never mix, whenever the process is
/// killed. What was begun by a process that was killed is brought to its end by the next.
///
/// While this lives, other processes may not render the same clip there, but parts of it beside
/// parts.
class ClipFolder {
 public:
  struct Settings {
    const scene::Scene& scene;
    std::string record;  ///< For its scene.toml.
    Manifest::Entries made;
    EarlierFrames earlier{};
    bool part = false;  ///< Some frames, which go to NAME/ beside others of the same settings.
    bool png = true;    ///< Whether there will be frames; a part without leaves nothing in NAME/.
  };

  /// Throws InputError if there are frames that must not be lost or mixed, MachineError if another
  /// process is rendering into the folder, or it can't be written.
  ClipFolder(const ClipFiles& files, const Settings& settings);
  ClipFolder(const ClipFolder&) = delete;
  ClipFolder& operator=(const ClipFolder&) = delete;
  /// Takes NAME.partial/ away if it holds no frames.
  ~ClipFolder();

  /// Of the frames in path(), those of an earlier run among them.
  FrameChecksums& sums() { return *sums_; }
  const std::filesystem::path& path() const { return path_; }

  /// How many frames a render that couldn't go on leaves to one that resumes it.
  std::size_t resumableFrames() const noexcept;

  /// Whether an earlier render finished `files`, and `frames` too, if they are asked for, and all
  /// is as it left them.
  bool isDone(const std::vector<std::filesystem::path>& files,
              std::optional<FrameRange> frames) const;

  /// Brings the clip under its final name. `files` are what was made with it, `frames` those that
  /// were written, if they were: without them the frames of an earlier render stay in NAME/. Throws
  /// MachineError.
  void finish(const std::vector<std::filesystem::path>& files, std::optional<FrameRange> frames);

  /// What is left of renders of other settings, once this one is finished: "out/a.mp4",
  /// "720 frames in out/a/".
  std::vector<std::string> keptOfOtherSettings() const;

 private:
  void openPart(const Settings& settings);
  void openWhole(const Settings& settings);
  void begin(const std::filesystem::path& folder, const std::string& record);
  void finishWithFrames(const Manifest::Entries& written);
  void finishWithoutFrames(const Manifest::Entries& written);
  std::size_t frameCount() const;
  void discardIfEmpty() const noexcept;

  system::AdvisoryLock lock_;
  ClipFiles files_;
  Manifest manifest_;
  std::filesystem::path path_;
  std::optional<FrameChecksums> sums_;
};

}  // namespace rotatebook::store
