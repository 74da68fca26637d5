#include "pipeline/frame_folder.h"

#include <algorithm>
#include <cstdint>
#include <system_error>

#include "base/atomic_file.h"
#include "base/error.h"
#include "base/read_file.h"

namespace rotatebook::pipeline {
namespace {

namespace fs = std::filesystem;

void removeFrames(const fs::path& folder) {
  for (const std::int64_t index : framesIn(folder)) removeFile(folder / frameName(index));
}

void moveFile(const fs::path& from, const fs::path& to) {
  std::error_code error;
  fs::rename(from, to, error);
  if (error) {
    throw MachineError("can't move " + from.string() + " to " + to.string() + ": " +
                       error.message());
  }
}

/// Removes the frames, their scene.toml, and the folder itself if nothing else is in it.
void discardFrames(const fs::path& folder) {
  removeFrames(folder);
  removeFile(folder / kSceneCopyName);
  std::error_code notEmpty;
  fs::remove(folder, notEmpty);
}

}  // namespace

void removeFile(const fs::path& path) {
  std::error_code error;
  fs::remove(path, error);
  if (error) throw MachineError("can't remove " + path.string() + ": " + error.message());
}

void startWholeClip(const ClipFiles& files, const std::string& record) {
  // Better said now than when the frames are to be moved there.
  if (fs::exists(files.frameFolder)) createFolders(files.frameFolder);
  createFolders(files.partialFrameFolder);
  removeFrames(files.partialFrameFolder);
  writeFileAtomically(files.partialFrameFolder / kSceneCopyName, record);
}

void refuseForeignFrames(const ClipFiles& files, const std::string& record) {
  if (!fs::is_directory(files.frameFolder) || framesIn(files.frameFolder).empty()) return;
  if (readFileOrEmpty(files.sceneCopy) == record) return;
  throw InputError(files.frameFolder.string() +
                   " holds frames of other settings (compare its scene.toml with 'rotatebook scene "
                   "--print'); render into another folder with -o, or remove it");
}

void startPart(const ClipFiles& files, const std::string& record) {
  createFolders(files.frameFolder);
  writeFileAtomically(files.sceneCopy, record);
}

void replaceFrames(const ClipFiles& files) {
  createFolders(files.frameFolder);
  removeFrames(files.frameFolder);
  for (const std::int64_t index : framesIn(files.partialFrameFolder)) {
    moveFile(files.partialFrameFolder / frameName(index), files.frameFolder / frameName(index));
  }
  moveFile(files.partialFrameFolder / kSceneCopyName, files.sceneCopy);
  removeFile(files.partialFrameFolder);
}

void removeOutdated(const ClipFiles& files, const std::string& record, bool png,
                    std::span<const video::VideoFormat> formats) {
  const std::string earlier = readFileOrEmpty(files.sceneCopy);
  if (earlier.empty() || earlier == record) return;
  if (!png) discardFrames(files.frameFolder);
  for (const video::VideoFormat format : video::kVideoFormats) {
    if (std::ranges::count(formats, format) == 0) removeFile(files.video(format));
  }
}

}  // namespace rotatebook::pipeline
