// Replacement of the folder of a clip's frames, which a killed process may leave half done. Inside
// the room only.
#pragma once

#include <filesystem>
#include <string>

#include "store/clip_files.h"

namespace rotatebook::store {

/// Removes everything that a render wrote into `folder`, and `folder` itself if that empties it.
/// Throws MachineError.
void discard(const std::filesystem::path& folder);

/// Returns why NAME.replaced/ can't be removed; empty if it can or there is none.
std::string obstacleToDiscarding(const ClipFiles& files);

/// Replaces NAME/ by NAME.partial/, which is complete. If the process is killed on the way,
/// recover() does the rest. Throws MachineError.
void replaceFolder(const ClipFiles& files);

/// Completes or undoes a replacement that a killed process left half done, unless NAME.replaced/
/// can't be removed. Throws InputError if that would remove what no render left, unless
/// `overwrite`.
void recover(const ClipFiles& files, bool overwrite);

/// Moves the intact frames of `from` that `to` lacks into `to`, which has the same settings, and
/// discards `from`. Throws MachineError.
void moveFrames(const std::filesystem::path& from, const std::filesystem::path& to);

}  // namespace rotatebook::store
