// The videos in a clip's folder that are of its scene. Inside the room only.
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "scene/scene.h"
#include "store/clip_files.h"

namespace rotatebook::page {

/// The videos that the page shows or leaves out.
struct ClipVideos {
  /// The MP4, which every browser plays, or else the WebM, the GIF or the APNG.
  std::filesystem::path played;
  bool isMovingPicture = false;  ///< True if `played` is a GIF or an APNG, which no <video> plays.
  /// The checksum of the motion by the record of `played`; empty if it has none.
  std::string motion{};
  /// The videos to link to, with the title of each format.
  std::vector<std::pair<std::filesystem::path, std::string>> linked;
  std::vector<std::string> leftOut;  ///< As Figure::leftOut.
};

inline constexpr const char* kOtherSettings =
    "it was made from another scene or with other settings";

/// Returns whether two of `files` were made from different scenes, as far as the clip's manifest
/// knows.
bool areOfOtherScenes(const store::ClipFiles& files, const std::filesystem::path& one,
                      const std::filesystem::path& other);

/// Returns the videos among `files` that are of `scene`: an MP4 or WebM by its record and the size
/// of its pictures, a GIF or APNG, which holds no record, by the size and the clip's manifest.
/// Throws InputError, with the remedy, if there are none.
ClipVideos videosOf(const scene::Scene& scene, const store::ClipFiles& files);

}  // namespace rotatebook::page
