// Options about clips: their records, parts and videos. Inside the room only.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "scene/scene.h"
#include "store/clip_files.h"
#include "store/clip_record.h"
#include "video/video_format.h"

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

/// Adds --format, with the formats' names.
CLI::Option* addFormats(CLI::App& command, std::vector<std::string>& names);

/// Returns the formats that --format names, each once, without MP4 if `noMp4`; MP4 if it names
/// none. Throws InputError.
std::vector<video::VideoFormat> videoFormatsOf(const std::vector<std::string>& names, bool noMp4);

/// The place of a clip's files, and the videos among them.
struct Destination {
  std::filesystem::path folder;
  /// The name of the files, without ending, in place of the scene's; empty if a folder was named.
  std::string name;
  std::vector<video::VideoFormat> formats;  ///< Of the named videos.
};

/// Takes the values of --output for so many `scenes`: folders, of which the last is taken, or
/// videos of the only scene, all of which are made. A name with an ending is a folder if that
/// exists, or if a slash follows. Throws InputError for folders beside videos, for endings of no
/// format, and unless the videos have one name and one folder.
Destination destinationOf(const std::vector<std::string>& outputs, std::size_t scenes);

/// Throws InputError if a video of a scene would lose its transparency.
void refuseOpaque(const scene::Scene& scene, const std::vector<video::VideoFormat>& formats);

}  // namespace rotatebook::cli
