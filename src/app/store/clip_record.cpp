#include "store/clip_record.h"

#include <algorithm>
#include <iterator>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "base/checksum.h"
#include "base/error.h"
#include "base/text.h"
#include "base/version.h"
#include "picture/texture_files.h"
#include "scene/scene_text.h"
#include "store/scene_file.h"
#include "store/scene_name.h"
#include "video/video_writer.h"

namespace rotatebook::store {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kMadeBy = "# Made by rotatebook ";
constexpr std::string_view kFromScene = " from the scene ";
constexpr std::string_view kRenderer = "# Renderer: ";
constexpr std::string_view kFfmpeg = "# FFmpeg: ";
constexpr std::string_view kMotion = "# Motion: ";
constexpr std::string_view kTextures = "# Textures: ";
constexpr std::string_view kFrames = "# Frames: ";
constexpr std::string_view kHeaderEnd = "\n\n";
constexpr std::string_view kBrowser = "a browser, ";  // So a live book's renderer begins.

constexpr std::size_t kLargestRecord = 1 << 20;  // Scenes take a few thousand. [bytes]

std::string line(std::string_view name, const std::string& value) {
  return fmt::format("{}{}\n", name, oneLine(value));
}

/// Returns what follows `name` on its line; empty if `header` has no such line.
std::string valueIn(std::string_view header, std::string_view name) {
  const std::size_t begin = header.starts_with(name) ? 0 : header.find('\n' + std::string(name));
  if (begin == header.npos) return "";
  const std::string_view rest = header.substr(begin + name.size() + (begin == 0 ? 0 : 1));
  return std::string(rest.substr(0, rest.find('\n')));
}

[[noreturn]] void throwDamaged(const fs::path& clip, const std::string& problem) {
  throw InputError(fmt::format("the record in {} is damaged: {}", clip.string(), problem));
}

/// Reads the program's version and the scene's name from the first line.
void readOrigin(std::string_view header, const fs::path& clip, Provenance& provenance) {
  const std::string origin = valueIn(header, kMadeBy);
  const std::size_t middle = origin.find(kFromScene);
  if (middle == origin.npos) throwDamaged(clip, "it doesn't name its scene");
  provenance.program = origin.substr(0, middle);
  provenance.scene = origin.substr(middle + kFromScene.size());
  if (const std::string problem = problemOfName(provenance.scene); !problem.empty()) {
    throwDamaged(clip,
                 fmt::format("its scene's name {} {}", quotedText(provenance.scene), problem));
  }
}

/// Refuses a head that isn't safe to print.
void checkHeader(std::string_view header, const fs::path& clip) {
  std::string lines(header);
  std::ranges::replace(lines, '\n', ' ');
  if (!isOneLine(lines)) {
    throwDamaged(clip, "its head holds control characters, or isn't UTF-8");
  }
}

std::optional<FrameRange> partIn(std::string_view header, const fs::path& clip) {
  const std::string text = valueIn(header, kFrames);
  if (text.empty()) return std::nullopt;
  const std::optional<FrameRange> part = parseRange(text);
  if (part && part->first < part->end) return part;
  throwDamaged(clip, "its frames aren't a range");
}

scene::Scene sceneIn(const std::string& text, const std::string& name, const fs::path& clip,
                     const fs::path& folder) {
  try {
    scene::Scene scene = scene::parseScene(text, clip);
    scene.name = name;
    scene.folder = folder;
    return scene;
  } catch (const InputError& error) {
    throwDamaged(clip, error.what());
  }
}

void compareTools(const char* tool, const std::string& there, const std::string& here,
                  std::vector<std::string>& found) {
  if (there == here) return;
  found.push_back(
      fmt::format("{} was {}, here it is {}", tool, there.empty() ? "not recorded" : there, here));
}

/// Returns whether the file of a texture or of a recording is missing.
bool lacksFiles(const scene::Scene& scene) {
  const auto isMissing = [&](const std::string& file) {
    std::error_code error;
    return file != scene::kBuiltin && !fs::exists(scene.folder / file, error);
  };
  for (const scene::Panel& panel : scene.motions) {
    const auto& simulation = panel.simulation;
    if (simulation.model == physics::Model::Recorded && isMissing(simulation.recorded.file)) {
      return true;
    }
    if (!panel.solid.mesh.name.empty() && isMissing(panel.solid.mesh.name)) return true;
  }
  const scene::BookSettings& book = scene.book;
  return isMissing(book.front) || isMissing(book.spine) || isMissing(book.back);
}

std::string texturesText(const picture::TextureChecksums& textures) {
  return joinedOf(textures, [](const auto& texture) {
    const auto& [key, sum] = texture;
    return sum == picture::kBuiltinTexture ? "" : key + " " + sum;
  });
}

/// Returns the folders in `folder`, in the order of their names; the first kMaxFolders of them.
std::vector<fs::path> foldersIn(const fs::path& folder) {
  constexpr std::size_t kMaxFolders = 1000;
  std::vector<fs::path> folders;
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(folder, ignored)) {
    if (folders.size() == kMaxFolders) break;
    if (entry.is_directory(ignored)) folders.push_back(entry.path());
  }
  std::ranges::sort(folders);
  return folders;
}

/// Returns the folders near a clip where its scene may be: its own, the one above, as a render
/// leaves clips in out/, the current one, and the folders in these.
std::vector<fs::path> foldersNear(const fs::path& clip) {
  const fs::path own = clip.parent_path().empty() ? "." : clip.parent_path();
  std::vector<fs::path> folders{own, own / "..", "."};
  for (const fs::path& parent : std::vector(folders)) {
    std::ranges::copy(foldersIn(parent), std::back_inserter(folders));
  }
  return folders;
}

/// Reads the files that a record's scene names.
void readFiles(RecordedClip& clip) {
  readMotionFiles(clip.record.scene);
  clip.textures = picture::readTextures(clip.record.scene);
}

/// Reads them from a folder near the clip that has all of them as they were. Returns false, and
/// leaves `recorded` as it is, if none has.
bool readFilesNear(const fs::path& clip, RecordedClip& recorded) {
  for (const fs::path& folder : foldersNear(clip)) {
    RecordedClip there = recorded;
    there.record.scene.folder = folder;
    if (lacksFiles(there.record.scene)) continue;
    try {
      readFiles(there);
    } catch (const InputError&) {
      continue;
    }
    const std::string& wanted = recorded.record.provenance.textures;
    if (!wanted.empty() &&
        wanted != texturesText(picture::checksumsOf(there.record.scene, there.textures)))
      continue;
    recorded = std::move(there);
    return true;
  }
  return false;
}

/// Returns the text of all that the clip of `scene` depends on.
std::string clipText(scene::Scene scene) {
  scene.motion.expectations.clear();
  for (scene::Panel& panel : scene.motions) panel.expectations.clear();
  if (scene.grid) scene.grid->expected.clear();
  scene.study.reset();
  return sceneText(scene);
}

}  // namespace

bool Provenance::isOfBrowser() const {
  return renderer.starts_with(kBrowser);
}

Provenance provenanceOf(const scene::Scene& scene, const std::string& motionSum,
                        const std::map<std::string, std::string>& textures,
                        const std::string& renderer, const std::string& ffmpeg) {
  return {.scene = oneLine(scene.name),
          .program = kVersion,
          .renderer = oneLine(renderer),
          .ffmpeg = ffmpeg,
          .motion = motionSum,
          .textures = texturesText(textures)};
}

std::vector<std::string> differencesOfTools(const Provenance& there, const Provenance& here) {
  std::vector<std::string> found;
  compareTools("rotatebook", there.program, here.program, found);
  compareTools("the renderer", there.renderer, here.renderer, found);
  compareTools("FFmpeg", there.ffmpeg, here.ffmpeg, found);
  if (!there.textures.empty() && there.textures != here.textures) {
    found.push_back(
        fmt::format("the textures were {}, here they are {}", there.textures, here.textures));
  }
  return found;
}

std::string sceneRecord(const scene::Scene& scene, const Provenance& provenance) {
  return line(kMadeBy, provenance.program + std::string(kFromScene) + provenance.scene) +
         line(kRenderer, provenance.renderer) +
         (provenance.ffmpeg.empty() ? "" : line(kFfmpeg, provenance.ffmpeg)) +
         line(kMotion, provenance.motion) +
         (provenance.textures.empty() ? "" : line(kTextures, provenance.textures)) + '\n' +
         sceneText(scene);
}

std::string recordOfPart(const std::string& record, FrameRange part) {
  const std::size_t end = record.find(kHeaderEnd);
  if (!record.starts_with(kMadeBy) || end == record.npos) return record;
  return record.substr(0, end + 1) + line(kFrames, rangeText(part)) + record.substr(end + 1);
}

std::string recordOfVideo(const std::string& record, const std::string& ffmpeg) {
  const std::size_t end = record.find(kHeaderEnd);
  if (!record.starts_with(kMadeBy) || end == record.npos) return record;
  const std::string_view header = std::string_view(record).substr(0, end);
  if (!valueIn(header, kFfmpeg).empty()) return record;
  const std::size_t place = std::min(header.find('\n' + std::string(kMotion)), end) + 1;
  return record.substr(0, place) + line(kFfmpeg, ffmpeg) + record.substr(place);
}

ClipRecord parseRecord(const std::string& text, const fs::path& clip, const fs::path& sceneFolder) {
  if (!text.starts_with(kMadeBy)) {
    throw InputError(clip.string() + " isn't a clip of rotatebook: its metadata holds no scene");
  }
  if (text.size() > kLargestRecord) throwDamaged(clip, "no scene is that long");
  const std::string_view header = std::string_view(text).substr(0, text.find(kHeaderEnd));
  checkHeader(header, clip);
  ClipRecord record;
  readOrigin(header, clip, record.provenance);
  record.provenance.renderer = valueIn(header, kRenderer);
  record.provenance.ffmpeg = valueIn(header, kFfmpeg);
  record.provenance.motion = valueIn(header, kMotion);
  record.provenance.textures = valueIn(header, kTextures);
  record.part = partIn(header, clip);
  record.scene = sceneIn(text, record.provenance.scene, clip, sceneFolder);
  return record;
}

bool isPlainRecord(const ClipRecord& record, const std::string& text) {
  if (record.provenance.program != kVersion) return true;
  const std::string whole = sceneRecord(record.scene, record.provenance);
  return text == (record.part ? recordOfPart(whole, *record.part) : whole);
}

std::string recordIn(const fs::path& video) {
  try {
    return video::readClipMetadata(video).comment;
  } catch (const InputError&) {
    return "";
  }
}

bool looksLikeRecord(const std::string& text) {
  return text.starts_with(kMadeBy);
}

bool isRecordOf(const scene::Scene& scene, const std::string& text) {
  try {
    return sceneText(parseRecord(text, scene.name, scene.folder).scene) == sceneText(scene);
  } catch (const InputError&) {
    return false;
  }
}

bool isRecordOfClip(const scene::Scene& scene, const std::string& text) {
  try {
    const ClipRecord record = parseRecord(text, scene.name, scene.folder);
    return !record.part && clipText(record.scene) == clipText(scene);
  } catch (const InputError&) {
    return false;
  }
}

RecordedClip readRecordedClip(const fs::path& clip, const TextureLookup& textures) {
  const video::ClipMetadata metadata = video::readClipMetadata(clip);
  const fs::path folder = textures.folder.empty() ? clip.parent_path() : textures.folder;
  RecordedClip recorded{metadata.format, parseRecord(metadata.comment, clip, folder)};
  recorded.text = metadata.comment;
  scene::Scene& scene = recorded.record.scene;
  scene.allowOutside = textures.allowOutside;
  // A file of that name beside the clip may be another, such as the clip's own table.
  if (textures.folder.empty() && readFilesNear(clip, recorded)) return recorded;
  try {
    readFiles(recorded);
  } catch (const InputError& error) {
    if (!lacksFiles(scene)) throw;
    throw InputError(std::string(error.what()) +
                     "; name its scene's folder with --scene-folder DIR");
  }
  return recorded;
}

}  // namespace rotatebook::store
