// Outputs of renders with other settings, and of other clips, beside a clip.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "store/clip_files.h"
#include "store/manifest.h"

namespace rotatebook::store {

/// The end of the names of outputs that no manifest lists, in ReplacedOutputs::items().
inline constexpr const char* kUnknownSettings = " (with unknown settings)";

/// Returns whether the folder's own frames have the fingerprint `made`.
bool isMadeWith(const std::optional<Manifest>& manifest, const Manifest::Entries& made);
/// Returns whether the manifest states the settings of the folder's frames.
bool knowsSettings(const std::optional<Manifest>& manifest);

/// Returns whether the file at `path` has this checksum; false if it can't be read.
bool isIntact(const std::filesystem::path& path, const std::string& checksum);

/// Returns the outputs that remain from renders with other settings than `made`, once the render
/// with these is finished: "out/a.mp4", "720 frames in out/a/".
std::vector<std::string> keptOfOtherSettings(const ClipFiles& files, const Manifest::Entries& made);

/// Throws InputError if one of `outputs` was left by another clip in the same folder: if that
/// clip's manifest lists it, and it still has its checksum, or it is a part's table. The message
/// ends with `remedy`, which also says what would replace it.
void refuseFilesOfOtherClips(const ClipFiles& files,
                             const std::vector<std::filesystem::path>& outputs,
                             const std::string& remedy);

/// The outputs that a render finds and is going to replace.
class ReplacedOutputs {
 public:
  /// Notes those of `outputs` that renders with the fingerprint `made` didn't leave, or that were
  /// changed since or can't be read; and, if `frames`, the frames of other settings.
  ReplacedOutputs(const ClipFiles& files, const Manifest::Entries& made,
                  const std::vector<std::filesystem::path>& outputs, bool frames);

  /// Returns those that have other bytes now, like keptOfOtherSettings().
  std::vector<std::string> items() const;

 private:
  struct Output {
    std::filesystem::path file;
    std::string checksum;  ///< Empty if it can't be read.
    bool isKnown = false;  ///< A manifest lists it with this checksum.
  };

  std::vector<Output> outputs_;
  std::string frames_;  ///< Empty if no frames are replaced.
};

}  // namespace rotatebook::store
