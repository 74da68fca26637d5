#include "store/result_owners.h"

#include <algorithm>
#include <fstream>
#include <optional>
#include <string_view>
#include <system_error>

#include <fmt/core.h>

#include "base/error.h"
#include "base/json.h"
#include "store/clip_files.h"
#include "store/clip_record.h"
#include "store/fingerprint.h"
#include "store/manifest.h"
#include "store/other_settings.h"
#include "store/study_files.h"
#include "study/map_files.h"
#include "study/study_csv.h"
#include "system/file_checksum.h"
#include "system/program_mark.h"
#include "system/read_file.h"
#include "timeline/clip_tables.h"
#include "timeline/web_vtt.h"

namespace rotatebook::store {
namespace {

namespace fs = std::filesystem;

const char* titleOf(ResultKind kind) {
  constexpr const char* kTitles[] = {"the clip", "the map", "the film of the map", "the study of",
                                     "the still"};
  return kTitles[static_cast<int>(kind)];
}

bool isFile(const fs::path& path) {
  std::error_code missing;
  return fs::is_regular_file(path, missing);
}

/// Returns the header row of a table; empty if there is none.
std::string headerOf(const fs::path& csv) {
  constexpr std::size_t kMaxHeader = 10'000;
  if (!isFile(csv)) return "";
  std::string start(kMaxHeader, '\0');
  std::ifstream file(csv, std::ios::binary);
  file.read(start.data(), std::ssize(start));
  start.resize(static_cast<std::size_t>(file.gcount()));
  return start.substr(0, start.find('\n'));
}

/// Returns whether an array is the one that the map's JSON describes, or may be, without that.
bool isArrayOfMap(const MapFiles& map) {
  const study::MapChecksums made = study::checksumsIn(system::readFileOrEmpty(map.json));
  return made.npy.empty() || made.npy == system::checksumOfFile(map.npy);
}

/// Returns whether a file is the result of a command, by its beginning.
bool isResult(std::string_view kind, const fs::path& json) {
  return isResultOf(kind, headerOf(json));
}

bool isOfMap(const MapFiles& map, const fs::path& file) {
  const std::vector<fs::path> all = allOf(map);
  if (std::ranges::find(all, file) == all.end() || !isResult("map", map.json)) return false;
  return file != map.csv || study::isMapHeader(headerOf(file));
}

bool isFilm(const fs::path& file) {
  return isRecordOfFilm(recordIn(file));
}

/// Returns whether a file is the table of a clip's motion or grid, by its header.
bool isTable(const fs::path& csv) {
  return timeline::isTableHeader(headerOf(csv));
}

/// Returns whether files of this ending hold records.
bool holdsRecords(const fs::path& file) {
  return file.extension() == ".mp4" || file.extension() == ".webm";
}

/// Returns whether a file is one of a clip's folder: a frame, its record or its checksums.
bool isInFrameFolder(const fs::path& file) {
  return isNameInFrameFolder(file.filename().string()) &&
         readManifest(file.parent_path()).has_value();
}

bool isOfStudy(const StudyFiles& study, const fs::path& file) {
  const std::vector<fs::path> all = allOf(study);
  return std::ranges::find(all, file) != all.end() && study::isStudyHeader(headerOf(study.csv));
}

/// Returns whether a page shows the clip `name` by this thumbnail.
bool isThumbnail(const ClipFiles& clip, const fs::path& file) {
  return file == clip.thumbnail && readManifest(clip.frameFolder).has_value();
}

/// Returns the map, film or study called `name` that left the file; nothing if none did.
std::optional<Results> ownerNamed(const std::string& name, const fs::path& file) {
  const MapFiles map = mapFiles(file.parent_path(), name);
  if (isOfMap(map, file)) return Results{ResultKind::Map, name};
  if (file == map.film && isFilm(file)) return Results{ResultKind::Film, name};
  if (isOfStudy(studyFiles(file.parent_path(), name), file))
    return Results{ResultKind::Study, name};
  return std::nullopt;
}

/// Returns whether the clip called `name` left the file, or a page shows the clip by it.
bool isOfClip(const std::string& name, const fs::path& file) {
  const ClipFiles clip = clipFiles(file.parent_path(), name);
  return isThumbnail(clip, file) || !sceneChecksumOf(clip.frameFolder, file).empty();
}

/// Returns the results that a file belongs to, as the names of scenes may begin its own. Those of
/// clips are known to another by their manifests, which refuseFilesOfOtherClips() reads.
std::vector<Results> ownersOf(const fs::path& file, bool isForClip) {
  const std::string name = file.filename().string();
  std::vector<Results> owners;
  if (!isForClip && isInFrameFolder(file))
    owners.push_back({ResultKind::Clip, fs::absolute(file).parent_path().filename().string()});
  for (std::size_t end = name.find_first_of(".-", 1); end != name.npos;
       end = name.find_first_of(".-", end + 1)) {
    const std::string start = name.substr(0, end);
    if (const auto owner = ownerNamed(start, file)) owners.push_back(*owner);
    if (!isForClip && isOfClip(start, file)) owners.push_back({ResultKind::Clip, start});
  }
  return owners;
}

}  // namespace

void refuseResultsOfOthers(const Results& own, const std::vector<fs::path>& outputs,
                           const std::string& remedy) {
  if (outputs.empty()) return;
  refuseFilesOfOtherClips(clipFiles(outputs.front().parent_path(), own.name), outputs, remedy);
  for (const fs::path& file : outputs) {
    if (!isFile(file)) continue;
    const std::vector<Results> owners = ownersOf(file, own.kind == ResultKind::Clip);
    if (owners.empty() || std::ranges::count(owners, own) > 0) continue;
    throw InputError(fmt::format("{} belongs to {} {}, and {}", file.string(),
                                 titleOf(owners.front().kind), owners.front().name, remedy));
  }
}

void refuseNoResultsOfClip(const ClipFiles& files, const std::vector<fs::path>& outputs,
                           const std::string& remedy) {
  for (const fs::path& file : outputs) {
    if (!isFile(file)) continue;
    const bool isKnown = file.extension() == ".csv"    ? isTable(file)
                         : file.extension() == ".json" ? isResult("clip", file)
                         : file.extension() == ".vtt"  ? headerOf(file) == timeline::kVttHead
                         : system::hasProgramMark(file)
                             ? true
                             : holdsRecords(file) && looksLikeRecord(recordIn(file));
    if (isKnown || !sceneChecksumOf(files.frameFolder, file).empty()) continue;
    throw InputError(file.string() + " was left by no render, and " + remedy);
  }
}

void refuseNoResultsOfMap(const MapFiles& files) {
  const auto refuse = [&](const fs::path& file, bool isKnown) {
    if (isKnown || !isFile(file)) return;
    throw InputError(file.string() +
                     " is no map's, and would be replaced or removed; move it away, or name "
                     "another folder with -o");
  };
  refuse(files.csv, study::isMapHeader(headerOf(files.csv)));
  refuse(files.json, isResult("map", files.json));
  if (isFile(files.npy)) refuse(files.npy, isArrayOfMap(files));
  for (const fs::path& file : files.plots) refuse(file, system::hasProgramMark(file));
  refuse(files.plain, system::hasProgramMark(files.plain));
}

void refuseNoResultsOfStudy(const StudyFiles& files, const std::string& remedy) {
  for (const fs::path& file : allOf(files)) {
    if (!isFile(file)) continue;
    const bool isKnown = file == files.csv    ? study::isStudyHeader(headerOf(file))
                         : file == files.json ? isResult("study", file)
                                              : system::hasProgramMark(file);
    if (!isKnown) throw InputError(file.string() + " was left by no study, and " + remedy);
  }
}

void refusePictureOfOthers(const fs::path& picture, const std::string& remedy) {
  if (!isFile(picture) || system::hasProgramMark(picture)) return;
  throw InputError(picture.string() + " has no mark of rotatebook, and " + remedy);
}

}  // namespace rotatebook::store
