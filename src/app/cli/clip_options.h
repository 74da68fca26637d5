// Options that every command takes that reads a clip's record. Inside the room only.
#pragma once

#include <filesystem>

#include <CLI/CLI.hpp>

#include "store/clip_record.h"

namespace rotatebook::cli {

/// CLIP, a file that holds a record.
void addClip(CLI::App& command, std::filesystem::path& clip);

/// --scene-folder and --allow-outside.
void addTextureOptions(CLI::App& command, store::TextureLookup& textures);

/// --allow-outside alone, as commands that read scenes have it.
void addAllowOutside(CLI::App& command, bool& allowOutside);

}  // namespace rotatebook::cli
