// Options that every command takes that reads a clip's record.
#pragma once

#include <CLI/CLI.hpp>

#include "pipeline/clip_record.h"

namespace rotatebook::cli {

/// --scene-folder and --allow-outside.
void addTextureOptions(CLI::App& command, pipeline::TexturePlace& textures);

/// --allow-outside alone, as commands that read scenes have it.
void addAllowOutside(CLI::App& command, bool& allowOutside);

}  // namespace rotatebook::cli
