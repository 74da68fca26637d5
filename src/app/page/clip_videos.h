// The videos of a clip: which of those in its folder are of its scene. Inside the room only.
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "scene/scene.h"
#include "store/clip_files.h"

namespace rotatebook::page {

struct ClipVideos {
  std::filesystem::path played;  ///< The MP4, which every browser plays, or else the WebM.
  /// Those to link to, with the format's name for people.
  std::vector<std::pair<std::filesystem::path, std::string>> linked;
  std::vector<std::string> leftOut;  ///< As Figure::leftOut.
};

inline constexpr const char* kOtherSettings = "it was made from another scene or with other settings";

/// Whether two of `files` were made of different scenes, as far as the clip's manifest knows.
bool areOfOtherScenes(const store::ClipFiles& files, const std::filesystem::path& one,
                      const std::filesystem::path& other);

/// Those of `files` that are of `scene`: an MP4 or WebM by its record and the size of its pictures,
/// a GIF or APNG, which holds no record, by the size and the clip's manifest. Throws InputError,
/// with the remedy, if there is none to be played.
ClipVideos videosOf(const scene::Scene& scene, const store::ClipFiles& files);

}  // namespace rotatebook::page
