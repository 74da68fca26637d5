#include "page/clip_videos.h"

#include "base/error.h"
#include "page/figure.h"
#include "store/clip_record.h"
#include "store/fingerprint.h"
#include "video/clip_reader.h"

namespace rotatebook::page {
namespace {

namespace fs = std::filesystem;
using video::FormatRow;

/// Returns why the file isn't the scene's; empty if it is. `played` is the scene's, unless empty.
std::string differenceOf(const fs::path& file, const FormatRow& format, const scene::Scene& scene,
                         const store::ClipFiles& files, const fs::path& played) {
  try {
    const std::string size = otherSizeText(video::readPictureSize(file), scene);
    if (!size.empty()) return size;
    const bool same = format.holdsRecord
                          ? store::isRecordOfClip(scene, video::readClipMetadata(file).comment)
                          : played.empty() || !areOfOtherScenes(files, played, file);
    return same ? "" : kOtherSettings;
  } catch (const InputError& error) {
    return error.what();
  }
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
    if (!fs::exists(file)) continue;
    const std::string difference = differenceOf(file, format, scene, files, videos.played);
    if (difference.empty()) {
      if (format.holdsRecord && videos.played.empty()) videos.played = file;
      videos.linked.emplace_back(file, format.title);
      continue;
    }
    videos.leftOut.push_back(file.string() + " isn't linked: " + difference);
    if (format.holdsRecord && problem.empty()) problem = file.string() + ": " + difference;
  }
  if (!videos.played.empty()) return videos;
  const fs::path mp4 = files.video(video::VideoFormat::Mp4);
  if (problem.empty()) requireFile(mp4, scene, "render");
  throw InputError(problem + "; " + renderAgain(scene, mp4.parent_path()));
}

}  // namespace rotatebook::page
