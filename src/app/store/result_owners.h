// The owners of results in a folder: clips, maps, films of maps and studies may give files the same
// names.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "store/clip_files.h"
#include "store/map_files.h"
#include "store/study_files.h"

namespace rotatebook::store {

/// Kinds of results, which are named after a scene.
enum class ResultKind { Clip, Map, Film, Study, Still };

/// Results of a scene.
struct Results {
  ResultKind kind = ResultKind::Clip;
  std::string name;  ///< The scene's.

  friend bool operator==(const Results&, const Results&) = default;
};

/// Throws InputError if one of `outputs`, all in one folder, was left there by others than `own`:
/// by another clip, which its manifest says; by a map, which its JSON says; by a film, which its
/// record says; or by a study, whose table begins as such do. The message ends with `remedy`, which
/// also says what would replace it.
void refuseResultsOfOthers(const Results& own, const std::vector<std::filesystem::path>& outputs,
                           const std::string& remedy);

/// Throws InputError if one of `outputs` of the clip `files`, all in one folder, is a table, video
/// result or poster that no render left: tables and results begin as such do, MP4s and WebMs hold a
/// record, and the others the program's mark; or the manifest lists them. The message ends
/// with `remedy`, as above.
void refuseNoResultsOfClip(const ClipFiles& files,
                           const std::vector<std::filesystem::path>& outputs,
                           const std::string& remedy);

/// Throws InputError if a map would replace or remove a table, JSON or picture that no map left:
/// pictures have the program's mark, and the array is the one that the JSON describes.
void refuseNoResultsOfMap(const MapFiles& files);

/// Throws InputError if a study would replace a file that no study left. The message ends with
/// `remedy`, as above.
void refuseNoResultsOfStudy(const StudyFiles& files, const std::string& remedy);

/// Throws InputError if there is a file at `picture` without the program's mark. The message ends
/// with `remedy`, as above.
void refusePictureOfOthers(const std::filesystem::path& picture, const std::string& remedy);

}  // namespace rotatebook::store
