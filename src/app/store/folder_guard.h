// Checks that a render loses no frames, records or files that must not be lost, before its first
// frame. Inside the room only.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "store/clip_settings.h"
#include "store/manifest.h"

namespace rotatebook::store {

/// Returns whether `folder` has a scene.toml that no render of this program left there.
bool hasForeignRecord(const std::filesystem::path& folder);

/// Throws InputError if `folder` has a scene.toml, or beside the frames of a finished clip others,
/// that no render left there, unless --overwrite allows to replace them. Frames that were changed
/// since count, too, unless the render goes on with that clip, which draws them again.
void refuseForeignFiles(const std::filesystem::path& folder, const std::optional<Manifest>& there,
                        const ClipSettings& settings);

/// Throws InputError unless the frames in `folder` may be discarded. Unfinished frames may not,
/// nor, if the render is to resume, a clip; --overwrite allows both.
void requireDiscardable(const std::filesystem::path& folder, const std::optional<Manifest>& there,
                        const ClipSettings& settings);

/// Throws InputError if `folder` holds frames with other settings, or they have begun, which a part
/// can't join.
void requireJoinable(const std::filesystem::path& folder, const std::optional<Manifest>& there,
                     const ClipSettings& settings, const std::string& remedy);

/// Throws MachineError, with the remedy, if one of `files` can't be replaced or removed: it is a
/// folder, or this user may not.
void requireReplaceableFiles(const std::vector<std::filesystem::path>& files);

}  // namespace rotatebook::store
