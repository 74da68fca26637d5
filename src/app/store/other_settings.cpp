#include "store/other_settings.h"

#include <algorithm>
#include <iterator>
#include <system_error>

#include <fmt/core.h>

#include "base/error.h"
#include "base/text.h"
#include "system/file_checksum.h"

namespace rotatebook::store {
namespace {

namespace fs = std::filesystem;

/// Returns the checksum of the file at `path`; empty if it isn't there or can't be read, so that
/// nothing is known about it.
std::string checksumOrEmpty(const fs::path& path) {
  try {
    return fs::is_regular_file(path) ? system::checksumOfFile(path) : "";
  } catch (const MachineError&) {
    return "";
  }
}

/// Returns all renders that a manifest lists.
std::vector<Manifest::Render> rendersOf(const Manifest& manifest) {
  std::vector<Manifest::Render> renders = manifest.others;
  renders.push_back(manifest.own);
  return renders;
}

/// Returns "720 frames in out/a/" if NAME/ holds frames of other settings; else empty.
std::string framesOfOtherSettings(const ClipFiles& files, const std::optional<Manifest>& there,
                                  const Manifest::Entries& made) {
  if (isMadeWith(there, made) || !hasFrames(files.frameFolder)) return "";
  return fmt::format("{} in {}/{}", countText(std::ssize(framesIn(files.frameFolder)), "frame"),
                     files.frameFolder.string(), knowsSettings(there) ? "" : kUnknownSettings);
}

/// Returns whether a render of the clip `clip` gives `file` its name: NAME.csv, NAME_LABEL.csv,
/// NAME.json.
bool isNamedAfter(const std::string& clip, const fs::path& file) {
  const std::string name = file.filename().string();
  return name.starts_with(clip + '.') || name.starts_with(clip + '_');
}

/// Returns whether one of the renders that `manifest` lists left `file` as it is.
bool isLeftBy(const Manifest& manifest, const fs::path& file) {
  for (const Manifest::Render& render : rendersOf(manifest)) {
    const auto entry = render.files.find(file.filename().string());
    if (entry != render.files.end() && isIntact(file, entry->second)) return true;
  }
  return false;
}

/// Returns whether `output` is the table or the result of a part of `clip`, whose manifest lists a
/// whole clip's files alone.
bool isOfPart(const std::string& clip, const Manifest& manifest, const fs::path& output) {
  const fs::path name = output.filename();
  return !manifest.finished && (name == clip + ".csv" || name == clip + ".json") &&
         fs::exists(output);
}

}  // namespace

bool isIntact(const fs::path& path, const std::string& checksum) {
  return !checksum.empty() && checksumOrEmpty(path) == checksum;
}

bool isMadeWith(const std::optional<Manifest>& manifest, const Manifest::Entries& made) {
  return manifest && manifest->own.made == made;
}

bool knowsSettings(const std::optional<Manifest>& manifest) {
  return manifest && !manifest->own.made.empty();
}

std::vector<std::string> keptOfOtherSettings(const ClipFiles& files,
                                             const Manifest::Entries& made) {
  const auto there = readManifest(files.frameFolder);
  if (!there) return {};

  // Collect the files of other renders that still are as these wrote them
  std::vector<std::string> kept;
  for (const Manifest::Render& render : rendersOf(*there)) {
    if (render.made == made) continue;
    for (const auto& [name, sum] : render.files) {
      const fs::path file = files.frameFolder.parent_path() / name;
      if (fs::path(name).filename() == name && isIntact(file, sum)) kept.push_back(file.string());
    }
  }
  std::ranges::sort(kept);

  // Add the frames of another render
  const std::string frames = framesOfOtherSettings(files, there, made);
  if (!frames.empty()) kept.push_back(frames);
  return kept;
}

void refuseFilesOfOtherClips(const ClipFiles& files, const std::vector<fs::path>& outputs,
                             const std::string& remedy) {
  const fs::path folder = files.frameFolder.parent_path();
  const auto own = readManifest(files.frameFolder);
  const std::string name = files.frameFolder.filename().string();
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder.empty() ? "." : folder, error)) {
    const std::string other = entry.path().filename().string();
    const auto manifest = other != name ? readManifest(entry.path()) : std::nullopt;
    if (!manifest) continue;
    for (const fs::path& output : outputs) {
      if (!isNamedAfter(other, output)) continue;
      if (!isLeftBy(*manifest, output) && !isOfPart(other, *manifest, output)) continue;
      // An equal table of both is no matter
      if (own && isLeftBy(*own, output)) continue;
      throw InputError(output.string() + " belongs to the clip " + other + ", and " + remedy);
    }
  }
}

ReplacedOutputs::ReplacedOutputs(const ClipFiles& files, const Manifest::Entries& made,
                                 const std::vector<fs::path>& outputs, bool frames) {
  const auto there = readManifest(files.frameFolder);
  for (const fs::path& file : outputs) {
    if (!fs::is_regular_file(file)) continue;
    Output output{file, checksumOrEmpty(file)};

    // Find the render that left it, and note it unless that had these settings
    bool isOwn = false;
    for (const Manifest::Render& render : rendersOf(there.value_or(Manifest{}))) {
      const auto entry = render.files.find(file.filename().string());
      if (entry == render.files.end() || entry->second != output.checksum) continue;
      output.isKnown = true;
      isOwn = render.made == made;
    }
    if (!isOwn) outputs_.push_back(output);
  }
  if (frames) frames_ = framesOfOtherSettings(files, there, made);
}

std::vector<std::string> ReplacedOutputs::items() const {
  std::vector<std::string> items;
  for (const Output& output : outputs_) {
    if (isIntact(output.file, output.checksum)) continue;
    items.push_back(output.file.string() + (output.isKnown ? "" : kUnknownSettings));
  }
  if (!frames_.empty()) items.push_back(frames_);
  return items;
}

}  // namespace rotatebook::store
