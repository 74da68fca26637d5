#include "store/clip_files.h"

#include <algorithm>
#include <cctype>
#include <optional>
#include <regex>
#include <string_view>
#include <system_error>

#include <fmt/core.h>

#include "base/error.h"
#include "base/parsed_number.h"
#include "base/text.h"
#include "timeline/clip_tables.h"

namespace rotatebook::store {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kPrefix = "frame_";
constexpr std::string_view kSuffix = ".png";
constexpr std::string_view kChecksumsPrefix = "frames.";
constexpr std::string_view kChecksumsSuffix = ".xxh128";

bool isPartChecksumsName(std::string_view name) {
  return name.starts_with(kChecksumsPrefix) && name.ends_with(kChecksumsSuffix) &&
         name.size() > kChecksumsPrefix.size() + kChecksumsSuffix.size();
}

/// Returns whether a letter of UTF-8, which has several bytes, is a mark rather than one of a word:
/// of Latin-1's signs, or of the general punctuation, arrows and symbols of U+2000 to U+2BFF.
bool isMark(std::string_view letter) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(letter[i]); };
  if (letter.size() == 3 && byte(0) == 0xE2) return byte(1) < 0xB0;
  return letter == "×" || letter == "÷" ||
         (byte(0) == 0xC2 && letter != "ª" && letter != "µ" && letter != "º");
}

/// Returns `label` with a hyphen in place of blanks and signs, A to Z small.
std::string slugOf(const std::string& label) {
  std::string slug;
  for (std::string_view rest = label; !rest.empty();) {
    const std::string_view letter = firstCharacters(rest, 1);
    rest.remove_prefix(letter.size());
    const bool isAscii = letter.size() == 1;
    const bool isWord =
        isAscii ? std::isalnum(static_cast<unsigned char>(letter[0])) != 0 : !isMark(letter);
    if (isWord) {
      slug += lowerCase(letter);
    } else if (!slug.empty() && slug.back() != '-') {
      slug += '-';
    }
  }
  if (slug.ends_with('-')) slug.pop_back();
  return slug;
}

}  // namespace

std::string rangeText(FrameRange range) {
  return fmt::format("{}:{}", range.first, range.end);
}

std::optional<FrameRange> parseRange(const std::string& text) {
  std::smatch match;
  if (!std::regex_match(text, match, std::regex("([0-9]{1,12}):([0-9]{1,12})"))) return {};
  return FrameRange{std::stoll(match[1]), std::stoll(match[2])};
}

std::optional<ClipPart> parsePart(const std::string& text) {
  std::smatch match;
  if (!std::regex_match(text, match, std::regex("([0-9]{1,6})/([0-9]{1,6})"))) return {};
  const ClipPart part{std::stoll(match[1]), std::stoll(match[2])};
  if (part.number < 1 || part.number > part.count) return {};
  return part;
}

FrameRange framesOf(const ClipPart& part, std::int64_t frames) {
  return {(part.number - 1) * frames / part.count, part.number * frames / part.count};
}

std::string frameName(std::int64_t index) {
  return fmt::format("{}{:05}{}", kPrefix, index, kSuffix);
}

std::optional<std::int64_t> frameIndex(const std::string& name) {
  if (!name.starts_with(kPrefix) || !name.ends_with(kSuffix)) return {};
  const std::size_t length = name.size() - std::min(name.size(), kPrefix.size() + kSuffix.size());
  const auto index =
      parsedNumber<std::int64_t>(std::string_view(name).substr(kPrefix.size(), length));
  return index >= 0 && name == frameName(*index) ? index : std::nullopt;
}

std::vector<std::int64_t> framesIn(const fs::path& folder) {
  std::error_code error;
  std::vector<std::int64_t> indices;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    if (const auto index = frameIndex(entry.path().filename().string())) indices.push_back(*index);
  }
  if (error)
    throw InputError(fmt::format("can't read the folder {}: {}", folder.string(), error.message()));
  std::sort(indices.begin(), indices.end());
  return indices;
}

bool hasFrames(const fs::path& folder) {
  return fs::is_directory(folder) && !framesIn(folder).empty();
}

std::string partChecksumsName(const std::string& process) {
  return std::string(kChecksumsPrefix) + process + std::string(kChecksumsSuffix);
}

std::vector<std::string> partChecksumsIn(const fs::path& folder) {
  std::error_code error;
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    const std::string name = entry.path().filename().string();
    if (isPartChecksumsName(name)) names.push_back(name);
  }
  std::sort(names.begin(), names.end());
  return names;
}

fs::path ClipFiles::video(video::VideoFormat format) const {
  return videoStem.string() + std::string(rowOf(format).ending);
}

fs::path ClipFiles::partialVideo(video::VideoFormat format) const {
  return videoStem.string() + kPartialEnding + std::string(rowOf(format).ending);
}

ClipFiles clipFiles(const fs::path& folder, const std::string& name) {
  const fs::path frames = folder / name;
  return {.frameFolder = frames,
          .partialFrameFolder = folder / (name + kPartialEnding),
          .replacedFolder = folder / (name + kReplacedEnding),
          .sceneCopy = frames / kSceneCopyName,
          .videoStem = frames,
          .csv = folder / (name + ".csv"),
          .json = folder / (name + ".json"),
          .captions = folder / (name + ".vtt"),
          .poster = folder / (name + ".poster.png"),
          .thumbnail = folder / (name + ".thumbnail.png")};
}

ClipFiles clipFiles(const fs::path& folder, const std::string& name, FrameRange part) {
  ClipFiles files = clipFiles(folder, name);
  files.videoStem = folder / fmt::format("{}_{:05}-{:05}", name, part.first, part.end);
  files.captions.clear();
  files.poster.clear();
  return files;
}

ClipFiles clipFiles(const fs::path& folder, const std::string& name, const ClipPart& /*part*/) {
  ClipFiles files = clipFiles(folder, name);
  files.csv.clear();
  files.json.clear();
  files.captions.clear();
  files.poster.clear();
  return files;
}

std::vector<fs::path> csvFiles(const fs::path& csv, const scene::Scene& scene) {
  if (csv.empty()) return {};
  if (timeline::tableCount(scene) == 1) return {csv};
  std::vector<fs::path> files;
  for (std::size_t i = 0; i < scene.motions.size(); ++i) {
    std::string name = csv.stem().string() + "_" + slugOf(scene.motions[i].label);
    const auto path = [&] { return csv.parent_path() / (name + csv.extension().string()); };
    const auto taken = [&] { return std::ranges::count(files, path()) > 0; };
    if (name.ends_with('_') || taken()) name += std::to_string(i + 1);
    while (taken()) name += fmt::format("-{}", i + 1);
    files.push_back(path());
  }
  return files;
}

std::vector<fs::path> outputFiles(const ClipFiles& files, const scene::Scene& scene,
                                  const std::vector<video::VideoFormat>& formats) {
  std::vector<fs::path> outputs = csvFiles(files.csv, scene);
  if (!files.json.empty()) outputs.push_back(files.json);
  if (!files.captions.empty() && !scene.cues.empty()) outputs.push_back(files.captions);
  if (!files.poster.empty()) outputs.push_back(files.poster);
  for (const video::VideoFormat format : formats) outputs.push_back(files.video(format));
  return outputs;
}

bool isNameInFrameFolder(const std::string& name) {
  return name == kSceneCopyName || name == kManifestName || name == kFrameChecksumsName ||
         isPartChecksumsName(name) || frameIndex(name);
}

}  // namespace rotatebook::store
