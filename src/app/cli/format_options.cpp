#include "cli/format_options.h"

#include <algorithm>
#include <string_view>

#include "base/error.h"
#include "base/nearest_name.h"

namespace rotatebook::cli {
namespace {

video::VideoFormat parseFormat(const std::string& name) {
  std::vector<std::string_view> names;
  for (const video::VideoFormat format : video::kVideoFormats) {
    if (name == nameOf(format)) return format;
    names.push_back(nameOf(format));
  }
  throw InputError("--format " + name + ": unknown; there are " + quotedList(names, "and") +
                   didYouMean(name, names));
}

}  // namespace

CLI::Option* addFormats(CLI::App& command, std::vector<std::string>& names) {
  return command
      .add_option(
          "--format", names,
          "Videos to make, of " + listFormats(&video::FormatRow::name, "and") + ", e.g. mp4,gif")
      ->type_name("NAME,...")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->capture_default_str()
      ->group("Clip");
}

std::vector<video::VideoFormat> videoFormatsOf(const std::vector<std::string>& names, bool noMp4) {
  std::vector<video::VideoFormat> formats;
  for (const std::string& name : names) {
    const video::VideoFormat format = parseFormat(name);
    const bool left = format == video::VideoFormat::Mp4 && noMp4;
    if (!left && std::ranges::count(formats, format) == 0) formats.push_back(format);
  }
  return formats;
}

void refuseOpaque(const scene::Scene& scene, const std::vector<video::VideoFormat>& formats) {
  if (!scene::isTransparent(scene)) return;
  for (const video::VideoFormat format : formats) {
    if (keepsTransparency(format)) continue;
    throw InputError(
        scene.name + ": " + std::string(nameOf(format)) +
        " can't hold the transparent background of look.background; use " +
        listFormats(&video::FormatRow::name, "or", &video::FormatRow::keepsTransparency) +
        " as --format, or --no-mp4 for PNGs alone");
  }
}

}  // namespace rotatebook::cli
