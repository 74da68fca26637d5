#include "cli/clip_options.h"

#include <algorithm>
#include <filesystem>
#include <string_view>
#include <system_error>

#include <fmt/core.h>

#include "base/error.h"
#include "base/nearest_name.h"
#include "base/text.h"
#include "cli/commands.h"
#include "cli/exit_code.h"
#include "cli/option_checks.h"
#include "pipeline/stream_clip.h"

namespace rotatebook::cli {

void addClip(CLI::App& command, std::filesystem::path& clip) {
  const std::string kinds =
      listFormats(&video::FormatRow::title, "or", &video::FormatRow::holdsRecord);
  command.add_option("CLIP", clip, kinds + " that rotatebook made")
      ->required()
      ->check(notStandardInput);
}

void addTextureOptions(CLI::App& command, store::TextureLookup& textures) {
  addOption(
      command, "--scene-folder", "DIR", textures.folder,
      "Folder with the scene's textures, meshes and recordings; by default the clip's folder, "
      "the one above it, the current one or a folder in these that has them as they were");
  addAllowOutside(command, textures.allowOutside);
}

store::ClipPart partOf(const std::string& text) {
  if (const auto part = store::parsePart(text)) return *part;
  throw InputError(fmt::format(
      "--part {}: not a part; write its number and how many there are, 1/16 to 16/16 for 16 parts",
      text));
}

void addRetryStatus(CLI::App& command) {
  command.add_flag_callback("--retry-status", askForRetryStatus,
                            "End with 75 where trying again may help: after a signal, a full disk, "
                            "a lock of another process, a missing device");
}

CLI::Option* addAllowOutside(CLI::App& command, bool& allowOutside) {
  return command.add_flag("--allow-outside", allowOutside,
                          "Let the scene read textures and words from outside its folder");
}

namespace {

video::VideoFormat parseFormat(const std::string& name) {
  std::vector<std::string_view> names;
  for (const video::VideoFormat format : video::kVideoFormats) {
    if (name == nameOf(format)) return format;
    names.push_back(nameOf(format));
  }
  if (std::ranges::count(pipeline::kStreamNames, name) > 0) {
    throw InputError(
        fmt::format("--format {}: for the standard output alone; add --output - to render", name));
  }
  throw InputError(fmt::format("--format {}: unknown; there are {}{}", shellWord(name),
                               quotedList(names, "and"), didYouMean(name, names)));
}

}  // namespace

CLI::Option* addFormats(CLI::App& command, std::vector<std::string>& names) {
  const auto take = [&names](const std::vector<std::string>& lists) {
    names.clear();
    for (const std::string& list : lists)
      for (const std::string& name : itemsOf(list)) names.push_back(name);
  };
  return repeated(command.add_option_function<std::vector<std::string>>("--format", take))
      ->description(fmt::format("Videos to make, of {}, e.g. mp4,gif",
                                listFormats(&video::FormatRow::name, "and")))
      ->type_name("NAME,...")
      ->group("Clip")
      ->default_str(std::string(nameOf(video::VideoFormat::Mp4)));
}

std::vector<video::VideoFormat> videoFormatsOf(const std::vector<std::string>& names, bool noMp4) {
  std::vector<video::VideoFormat> formats;
  if (names.empty() && !noMp4) formats.push_back(video::VideoFormat::Mp4);
  for (const std::string& name : names) {
    const video::VideoFormat format = parseFormat(name);
    const bool left = format == video::VideoFormat::Mp4 && noMp4;
    if (!left && std::ranges::count(formats, format) == 0) formats.push_back(format);
  }
  return formats;
}

namespace {

namespace fs = std::filesystem;

bool isFolder(const std::string& output) {
  std::error_code ignored;
  return output.ends_with('/') || !fs::path(output).has_extension() ||
         fs::is_directory(output, ignored);
}

video::VideoFormat formatOf(const std::string& output) {
  return video::formatOfFile(output, fmt::format("; for a folder of this name, write {}/", output));
}

/// Returns the name of a video's file without the ending of its format.
std::string stemOf(const std::string& output) {
  const std::string name = fs::path(output).filename().string();
  return name.substr(0, name.size() - rowOf(formatOf(output)).ending.size());
}

/// Throws InputError if both folders and videos are named, of which a render makes one.
void refuseBoth(const std::vector<std::string>& outputs) {
  const auto folder = std::ranges::find_if(outputs, isFolder);
  const auto video = std::ranges::find_if_not(outputs, isFolder);
  if (folder == outputs.end() || video == outputs.end()) return;
  throw InputError(fmt::format(
      "--output {} and --output {}: a render fills a folder, or makes the videos that are named; "
      "name the folder alone, with --format, or the videos alone",
      *folder, *video));
}

}  // namespace

Destination destinationOf(const std::vector<std::string>& outputs, std::size_t scenes) {
  refuseBoth(outputs);
  if (isFolder(outputs.back())) return {outputs.back(), "", {}};
  if (scenes > 1) {
    throw InputError(
        fmt::format("--output {}: one video for {} scenes; name a folder", outputs.back(), scenes));
  }
  const fs::path last(outputs.back());
  const fs::path folder = last.has_parent_path() ? last.parent_path() : fs::path(".");
  Destination destination{folder, stemOf(outputs.back()), {}};
  for (const std::string& output : outputs) {
    const fs::path path(output);
    if (path.parent_path() != last.parent_path() || stemOf(output) != destination.name) {
      throw InputError(fmt::format(
          "--output {} and --output {}: the videos of a render have one name, but for the ending",
          output, last.string()));
    }
    const video::VideoFormat format = formatOf(output);
    if (std::ranges::count(destination.formats, format) == 0) destination.formats.push_back(format);
  }
  return destination;
}

void refuseOpaque(const scene::Scene& scene, const std::vector<video::VideoFormat>& formats) {
  if (!scene::isTransparent(scene)) return;
  for (const video::VideoFormat format : formats) {
    if (keepsTransparency(format)) continue;
    throw InputError(fmt::format(
        "{}: {} can't hold the transparent background of look.background; use {} as --format, or "
        "--no-mp4 for PNGs alone",
        scene.name, nameOf(format),
        listFormats(&video::FormatRow::name, "or", &video::FormatRow::keepsTransparency)));
  }
}

}  // namespace rotatebook::cli
