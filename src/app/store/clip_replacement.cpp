#include "store/clip_replacement.h"

#include <system_error>

#include <fmt/core.h>

#include "base/error.h"
#include "store/folder_guard.h"
#include "store/frame_checksums.h"
#include "store/manifest.h"
#include "system/atomic_file.h"
#include "system/removal.h"
#include "system/temporary_files.h"

namespace rotatebook::store {
namespace {

namespace fs = std::filesystem;

void moveTo(const fs::path& from, const fs::path& to) {
  std::error_code error;
  fs::rename(from, to, error);
  if (error) {
    throw MachineError(
        fmt::format("can't move {} to {}: {}", from.string(), to.string(), error.message()),
        system::kindOfError(error.value()));
  }
}

/// Returns whether NAME.replaced/ may hold what no render of this program left. One whose removal
/// was cut short has no manifest, but its checksums are removed after its frames.
bool isForeign(const fs::path& replaced) {
  if (readManifest(replaced) || FrameChecksums::existIn(replaced)) return false;
  return hasFrames(replaced) || hasForeignRecord(replaced);
}

/// Removes NAME.replaced/, after moving files that no render wrote to NAME/.
void discardReplaced(const ClipFiles& files) {
  if (!fs::is_directory(files.replacedFolder)) return;
  discard(files.replacedFolder);
  if (!fs::is_directory(files.replacedFolder)) return;

  // Move foreign files to NAME/, without replacing any there
  for (const auto& entry : fs::directory_iterator(files.replacedFolder)) {
    const fs::path target = files.frameFolder / entry.path().filename();
    if (!fs::exists(target)) moveTo(entry.path(), target);
  }

  // Remove the folder unless such a file remains
  std::error_code notEmpty;
  fs::remove(files.replacedFolder, notEmpty);
}

}  // namespace

void discard(const fs::path& folder) {
  if (!fs::is_directory(folder)) return;
  // Remove the manifest first: if the process is killed, what remains isn't taken for a clip
  system::removeFile(folder / kManifestName);

  // Remove frames, checksums and scene
  system::removeStaleTemporaries(folder);
  for (const std::int64_t index : framesIn(folder)) system::removeFile(folder / frameName(index));
  FrameChecksums::removeFrom(folder);
  system::removeFile(folder / kSceneCopyName);

  // Remove the folder unless it holds other files
  std::error_code notEmpty;
  fs::remove(folder, notEmpty);
}

std::string obstacleToDiscarding(const ClipFiles& files) {
  const fs::path& folder = files.replacedFolder;
  if (!fs::is_directory(folder)) return "";
  std::string obstacle = system::obstacleToRemoval(folder);
  if (obstacle.empty()) obstacle = system::obstacleToEmptying(folder);
  if (obstacle.empty()) obstacle = system::obstacleToMovingFolders(folder);
  if (obstacle.empty()) return "";
  return fmt::format("the earlier clip in {}/ can't be removed: {}; have its owner remove it",
                     folder.string(), obstacle);
}

void replaceFolder(const ClipFiles& files) {
  if (fs::exists(files.frameFolder)) moveTo(files.frameFolder, files.replacedFolder);
  moveTo(files.partialFrameFolder, files.frameFolder);
  if (obstacleToDiscarding(files).empty()) discardReplaced(files);
  system::flushFolder(files.partialFrameFolder.parent_path());
}

void recover(const ClipFiles& files, bool overwrite) {
  if (!overwrite && isForeign(files.replacedFolder)) {
    throw InputError(files.replacedFolder.string() +
                     " holds files that this program's renders didn't leave, and would be removed; "
                     "rename it, or remove it with --overwrite");
  }
  const bool hasReplaced = fs::exists(fs::symlink_status(files.replacedFolder));
  if (hasReplaced && !fs::is_directory(files.replacedFolder)) {
    throw InputError(files.replacedFolder.string() +
                     " is no folder, and in the way of the clip that is replaced; rename it");
  }

  // Discard the replaced clip if another is in its place
  const bool hasFinal = fs::exists(files.frameFolder);
  if (hasFinal) discardReplaced(files);

  // Complete the replacement if the new clip is complete
  const std::optional<Manifest> partial = readManifest(files.partialFrameFolder);
  if (partial && partial->finished) return replaceFolder(files);

  // Move the replaced clip back if no other is in its place
  if (!hasFinal && hasReplaced) moveTo(files.replacedFolder, files.frameFolder);
}

void moveFrames(const fs::path& from, const fs::path& to) {
  if (!fs::is_directory(from)) return;
  const FrameChecksums source(from);
  FrameChecksums target(to);
  for (const std::int64_t frame : framesIn(from)) {
    const auto bytes = source.intact(frame);
    if (!bytes || target.intact(frame)) continue;
    moveTo(from / frameName(frame), to / frameName(frame));
    target.add(frame, *bytes);
  }
  discard(from);
}

}  // namespace rotatebook::store
