// Options of the commands that read a clip's record. Inside the room only.
#pragma once

#include <filesystem>

#include <CLI/CLI.hpp>

#include "store/clip_files.h"
#include "store/clip_record.h"

namespace rotatebook::cli {

/// Adds CLIP, a file that holds a record.
void addClip(CLI::App& command, std::filesystem::path& clip);

/// Adds --scene-folder and --allow-outside.
void addTextureOptions(CLI::App& command, store::TextureLookup& textures);

/// Adds --allow-outside alone, for commands that read scenes.
CLI::Option* addAllowOutside(CLI::App& command, bool& allowOutside);

/// Returns the part that --part names. Throws InputError.
store::ClipPart partOf(const std::string& text);

/// Adds --retry-status, which asks for kTryAgain as the exit status.
void addRetryStatus(CLI::App& command);

}  // namespace rotatebook::cli
