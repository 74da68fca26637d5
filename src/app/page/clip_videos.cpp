#include "page/clip_videos.h"

#include "base/error.h"
#include "page/figure.h"
#include "store/clip_record.h"
#include "store/fingerprint.h"
#include "store/manifest.h"
#include "system/read_file.h"
#include "video/clip_reader.h"

namespace rotatebook::page {
namespace {

namespace fs = std::filesystem;
using video::FormatRow;

/// Returns whether the manifest says that `file` was made with the record that is in the folder of
/// frames, and that is a record of `scene`.
bool isMadeWithRecord(const fs::path& file, const scene::Scene& scene,
                      const store::ClipFiles& files) {
  const auto manifest = store::readManifest(files.frameFolder);
  if (!manifest || !store::isRecordOfClip(scene, system::readFileOrEmpty(files.sceneCopy))) {
    return false;
  }
  const auto made = manifest->own.made.find("scene");
  return made != manifest->own.made.end() &&
         store::sceneChecksumOf(files.frameFolder, file) == made->second;
}

/// Returns why the file isn't the scene's; empty if it is. `played` is the scene's, unless empty.
std::string differenceOf(const fs::path& file, const FormatRow& format, const scene::Scene& scene,
                         const store::ClipFiles& files, const fs::path& played) {
  try {
    const std::string size = otherSizeText(video::readPictureSize(file), scene);
    if (!size.empty()) return size;
    const bool same = format.holdsRecord
                          ? store::isRecordOfClip(scene, video::readClipMetadata(file).comment)
                      : played.empty() ? isMadeWithRecord(file, scene, files)
                                       : !areOfOtherScenes(files, played, file);
    return same ? "" : kOtherSettings;
  } catch (const InputError& error) {
    const std::string problem = error.what(), name = file.string() + " ";
    return problem.starts_with(name) ? "it " + problem.substr(name.size()) : problem;
  }
}

std::string recordedMotion(const fs::path& clip) {
  return store::parseRecord(video::readClipMetadata(clip).comment, clip, clip.parent_path())
      .provenance.motion;
}

}  // namespace

bool areOfOtherScenes(const store::ClipFiles& files, const fs::path& one, const fs::path& other) {
  const std::string first = store::sceneChecksumOf(files.frameFolder, one);
  const std::string second = store::sceneChecksumOf(files.frameFolder, other);
  return !first.empty() && !second.empty() && first != second;
}

ClipVideos videosOf(const scene::Scene& scene, const store::ClipFiles& files) {
  ClipVideos videos;
  std::string problem;
  for (const FormatRow& format : video::kFormatRows) {
    const fs::path file = files.video(format.format);
    if (format.isForEditors || !fs::exists(file)) continue;
    const std::string difference = differenceOf(file, format, scene, files, videos.played);
    if (difference.empty()) {
      if (videos.played.empty()) {
        videos.played = file;
        videos.isMovingPicture = !format.holdsRecord;
        if (format.holdsRecord) videos.motion = recordedMotion(file);
      }
      videos.linked.emplace_back(file, format.title);
      continue;
    }
    videos.leftOut.push_back(file.string() + " isn't linked: " + difference);
    if (problem.empty()) problem = file.string() + ": " + difference;
  }
  if (!videos.played.empty()) return videos;
  const fs::path mp4 = files.video(video::VideoFormat::Mp4);
  if (problem.empty()) requireFile(mp4, scene, "render");
  throw InputError(problem + "; " + renderAgain(scene, mp4.parent_path()));
}

}  // namespace rotatebook::page
