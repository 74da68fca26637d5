// How the frames of a render take the place of an earlier one's.
#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "pipeline/clip_files.h"

namespace rotatebook::pipeline {

/// Makes NAME.partial/ ready for the frames of a whole clip, with `record` as its scene.toml.
/// Throws MachineError, also if NAME is there but no folder.
void startWholeClip(const ClipFiles& files, const std::string& record);

/// Makes NAME/ ready for some frames of a clip, beside those of the same settings. Throws
/// InputError if it holds frames of others.
void startPart(const ClipFiles& files, const std::string& record);

/// Moves the frames from NAME.partial/ to NAME/, in the place of those that were there. Throws
/// MachineError.
void replaceFrames(const ClipFiles& files);

/// Removes what an earlier render with other settings left and this one didn't make: its frames
/// unless `png`, its videos but those of `formats`. Throws MachineError.
void removeOutdated(const ClipFiles& files, const std::string& record, bool png,
                    std::span<const video::VideoFormat> formats);

/// Throws InputError if NAME/ holds frames of settings other than `record`.
void refuseForeignFrames(const ClipFiles& files, const std::string& record);

/// Removes `path` if it is there. Throws MachineError.
void removeFile(const std::filesystem::path& path);

}  // namespace rotatebook::pipeline
