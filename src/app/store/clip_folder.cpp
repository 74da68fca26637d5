#include "store/clip_folder.h"

#include <algorithm>
#include <chrono>
#include <exception>
#include <iterator>
#include <system_error>
#include <thread>
#include <utility>

#include <fmt/core.h>

#include "base/error.h"
#include "store/clip_replacement.h"
#include "store/folder_guard.h"
#include "store/result_owners.h"
#include "system/file_checksum.h"
#include "system/read_file.h"
#include "system/removal.h"

namespace rotatebook::store {
namespace {

namespace fs = std::filesystem;

/// Returns whether `folder` exists and holds no frames and no manifest: its render was killed when
/// it had just begun, which it was allowed to.
bool isEmptyFolder(const fs::path& folder) {
  return fs::is_directory(folder) && !fs::exists(folder / kManifestName) && !hasFrames(folder);
}

}  // namespace

ClipFolder::ClipFolder(const ClipFiles& files, const Settings& settings)
    : lock_(files.frameFolder, settings.part ? system::Lock::Shared : system::Lock::Exclusive),
      files_(files),
      outputs_(settings.outputs),
      manifest_{.own = {settings.made, {}}} {
  // Fail now, rather than after all is drawn, if NAME/ is no folder
  if (fs::exists(files.frameFolder)) system::createFolders(files.frameFolder);
  // Hold the files, too: a clip whose name begins otherwise may have a table of the same name
  for (const fs::path& output : outputs_)
    locks_.emplace_back(output, settings.part ? system::Lock::Shared : system::Lock::Exclusive);
  if (!settings.earlier.overwrite) {
    const std::string remedy = fmt::format(
        "the render of {} would replace it; rename the scene or its panel, render into another "
        "folder with -o, or replace it with --overwrite",
        settings.scene.name);
    refuseResultsOfOthers({ResultKind::Clip, settings.scene.name}, outputs_, remedy);
    refuseNoResultsOfClip(files, outputs_, remedy);
  }
  try {
    settings.part ? openPart(settings) : openWhole(settings);
    using File = FrameChecksums::File;
    checksums_.emplace(path_, settings.ownChecksums ? File::Own : File::Shared);
    replaced_.emplace(files_, settings.made, outputs_, settings.png && path_ != files_.frameFolder);
  } catch (...) {
    discardIfEmpty();
    throw;
  }
}

ClipFolder::~ClipFolder() {
  discardIfEmpty();
}

void ClipFolder::discardIfEmpty() const noexcept {
  try {
    if (path_ == files_.partialFrameFolder && frameCount() == 0) discard(path_);
  } catch (const std::exception&) {
    // A folder that remains does no harm.
  }
}

std::size_t ClipFolder::frameCount() const {
  return fs::is_directory(path_) ? framesIn(path_).size() : 0;
}

std::size_t ClipFolder::resumableFrames() const noexcept {
  try {
    // Without its manifest, the folder was emptied by another process meanwhile.
    return isMadeWith(readManifest(path_), manifest_.own.made) ? frameCount() : 0;
  } catch (const std::exception&) {
    return 0;  // Frames that can't be read can't be resumed.
  }
}

void ClipFolder::openPart(const Settings& settings) {
  // Refuse to mix with frames of other settings in NAME/
  const auto there = readManifest(files_.frameFolder);
  requireJoinable(files_.frameFolder, there, settings, "remove it");

  // Refuse to draw beside unfinished frames of a whole clip with other settings: of these and the
  // part, one would replace the other in the end
  if (settings.png) {
    if (hasFrames(files_.partialFrameFolder)) {
      requireJoinable(files_.partialFrameFolder, readManifest(files_.partialFrameFolder), settings,
                      "finish that render first, with --resume");
    }
    refuseForeignFiles(files_.frameFolder, there, settings);
  }

  path_ = files_.frameFolder;
  settings.png ? beginPart(there, settings) : void(manifest_ = manifestOfPart(there, settings));
}

/// Returns the manifest `there` of NAME/ with this render added, and the others kept. Where a
/// render without PNGs was finished, the frames begin now.
Manifest ClipFolder::manifestOfPart(const std::optional<Manifest>& there,
                                    const Settings& settings) const {
  Manifest manifest = there.value_or(Manifest{});
  manifest.become(settings.made);
  manifest.finished =
      isMadeWith(there, settings.made) && there->finished && hasFrames(files_.frameFolder);
  return manifest;
}

void ClipFolder::beginPart(std::optional<Manifest> there, const Settings& settings) {
  system::createFolders(path_);
  // Claim NAME/, or join the part that has just claimed it: locks may not be seen by other machines
  constexpr int kMaxTries = 10;
  for (int tries = 0;; ++tries) {
    manifest_ = manifestOfPart(there, settings);
    if (there == manifest_ || replaceManifest(path_, there, manifest_)) break;
    if (tries == kMaxTries) {
      throw MachineError((path_ / kManifestName).string() +
                             " is damaged, or other parts keep changing it; remove it if nothing "
                             "draws there",
                         ErrorKind::Transient);
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    there = readManifest(path_);
    requireJoinable(path_, there, settings, "remove it");
  }
  system::writeFileAtomically(path_ / kSceneCopyName, settings.record);
}

void ClipFolder::openWhole(const Settings& settings) {
  remainder_ = obstacleToDiscarding(files_);
  if (remainder_.empty()) {
    recover(files_, settings.earlier.overwrite);
    remainder_ = obstacleToDiscarding(files_);
  }

  // Look for earlier frames of the same settings
  const auto finished = readManifest(files_.frameFolder);
  const auto partial = readManifest(files_.partialFrameFolder);
  const bool resumesPartial = settings.earlier.resume && (isMadeWith(partial, settings.made) ||
                                                          isEmptyFolder(files_.partialFrameFolder));

  // Refuse to replace somebody's files
  const bool ownsFrames = isMadeWith(finished, settings.made);
  if (settings.png || ownsFrames || !hasFrames(files_.frameFolder))
    refuseForeignFiles(files_.frameFolder, finished, settings);
  if (resumesPartial) refuseForeignFiles(files_.partialFrameFolder, partial, settings);

  // Resume in NAME/ if its frames have the same settings
  if (settings.earlier.resume && ownsFrames) {
    manifest_ = *finished;
    // After a render without PNGs, the frames begin now
    if (settings.png && !hasFrames(files_.frameFolder)) manifest_.finished = false;
    begin(files_.frameFolder, settings.record);
    if (resumesPartial) moveFrames(files_.partialFrameFolder, files_.frameFolder);
    // Remove the folder of a process that was killed before its first frame
    const bool holdsOthers =
        hasFrames(files_.partialFrameFolder) || hasForeignRecord(files_.partialFrameFolder);
    if (!holdsOthers) discard(files_.partialFrameFolder);
    return;
  }

  requireReplaceableFolder(settings.png);

  // Refuse to replace a clip or parts in NAME/ that must not be lost, or of which nothing is known.
  // When the render to resume began, it was allowed to replace a finished clip, but not parts.
  const bool atRisk = !resumesPartial || !finished || !finished->finished;
  // A render without PNGs leaves NAME/ as it is, but can resume only a clip that has its settings.
  const bool isKnown = finished && finished->filesOf(settings.made) != nullptr;
  const bool claims = settings.png || (!knowsSettings(finished) && !hasFrames(files_.frameFolder));
  const bool mustCheck = claims || (settings.earlier.resume && !isKnown);
  if (atRisk && mustCheck) requireDiscardable(files_.frameFolder, finished, settings);

  // Discard unfinished frames that aren't resumed, if that is allowed
  if (!resumesPartial) {
    requireDiscardable(files_.partialFrameFolder, partial, settings);
    discard(files_.partialFrameFolder);
  }

  begin(files_.partialFrameFolder, settings.record);
}

// A clip that nobody may move or remove in the end is better found before its first frame is drawn.
void ClipFolder::requireReplaceableFolder(bool png) const {
  if (!fs::exists(files_.frameFolder)) return;
  system::requireReplaceable(files_.frameFolder / kManifestName);
  if (png && !remainder_.empty()) {
    throw MachineError(remainder_ + ", or render into another folder with -o");
  }
  std::string obstacle = system::obstacleToEmptying(files_.frameFolder);
  if (png && obstacle.empty()) obstacle = system::obstacleToMovingFolders(files_.frameFolder);
  if (png && obstacle.empty()) obstacle = system::obstacleToRemoval(files_.frameFolder);
  if (obstacle.empty()) return;
  throw MachineError(
      fmt::format("can't replace the clip in {}/: {}; have its owner remove it, or render into "
                  "another folder with -o",
                  files_.frameFolder.string(), obstacle));
}

void ClipFolder::begin(const fs::path& folder, const std::string& record) {
  path_ = folder;
  system::createFolders(folder);
  system::writeFileAtomically(folder / kSceneCopyName, record);
  writeManifest(folder, manifest_);
}

bool ClipFolder::isDone(std::optional<FrameRange> frames) const {
  // Find the earlier render with the same settings
  const auto there = readManifest(files_.frameFolder);
  const auto* known = there ? there->filesOf(manifest_.own.made) : nullptr;
  if (known == nullptr || (frames && path_ != files_.frameFolder)) return false;

  // Compare the files with their checksums
  for (const fs::path& file : outputs_) {
    const auto sum = known->find(file.filename().string());
    if (sum == known->end() || !isIntact(file, sum->second)) return false;
  }

  // Compare the frames with theirs
  if (!frames) return true;
  for (std::int64_t frame = frames->first; frame < frames->end; ++frame) {
    if (!checksums_->intact(frame)) return false;
  }
  return true;
}

void ClipFolder::requireReplaceableOutputs(const std::vector<fs::path>& more) const {
  requireReplaceableFiles(outputs_);
  requireReplaceableFiles(more);
}

void ClipFolder::finishPart(FrameRange frames) {
  checksums_->requireUnchanged(frames);
  checksums_->finishOwn();
  if (!isMadeWith(readManifest(path_), manifest_.own.made)) {
    throw MachineError(
        (path_ / kManifestName).string() +
            " is gone or has other settings: it was changed while the part was rendered",
        ErrorKind::Transient);
  }
  system::flushFolder(path_);
}

void ClipFolder::finish(std::optional<FrameRange> frames) {
  // Complete the frames' checksums
  if (frames) {
    checksums_->requireUnchanged(*frames);
    checksums_->sort(*frames);
  }

  // Take the checksums of the other files
  Manifest::Entries written;
  for (const fs::path& file : outputs_)
    written[file.filename().string()] = system::checksumOfFile(file);

  // Record them in the manifest, and bring the clip under its final name
  frames ? finishWithFrames(written) : finishWithoutFrames(written);
  system::flushFolder(files_.frameFolder.parent_path());
}

void ClipFolder::finishWithFrames(const Manifest::Entries& written) {
  // Write the manifest that NAME/ will have, which also lists the renders of its present one
  Manifest next = readManifest(files_.frameFolder).value_or(Manifest{});
  next.become(manifest_.own.made);
  next.finished = true;
  next.add(manifest_.own.made, written);
  writeManifest(path_, next);
  system::flushFolder(path_);

  // Move the folder to its final name
  if (path_ != files_.frameFolder) replaceFolder(files_);
  remainder_ = obstacleToDiscarding(files_);
}

// Leaves all frames in place: those of other settings in NAME/, unfinished ones in NAME.partial/.
void ClipFolder::finishWithoutFrames(const Manifest::Entries& written) {
  const std::optional<Manifest> there = readManifest(files_.frameFolder);
  Manifest next = there.value_or(Manifest{});

  // Claim NAME/ unless it holds frames of other settings. Unfinished ones of these stay unfinished.
  const bool isOwn = isMadeWith(there, manifest_.own.made);
  const bool holdsFrames = hasFrames(files_.frameFolder);
  if (isOwn || !holdsFrames) {
    next.become(manifest_.own.made);
    next.finished = !holdsFrames || there->finished;
    system::createFolders(files_.frameFolder);
    system::writeFileAtomically(files_.sceneCopy, system::readFileOrEmpty(path_ / kSceneCopyName));
  }

  // Record the files
  next.add(manifest_.own.made, written);
  writeManifest(files_.frameFolder, next);
  system::flushFolder(files_.frameFolder);
  discardIfEmpty();
}

std::vector<std::string> ClipFolder::keptOfOtherSettings() const {
  return store::keptOfOtherSettings(files_, manifest_.own.made);
}

std::vector<std::string> ClipFolder::replacedOfOtherSettings() const {
  return replaced_->items();
}

}  // namespace rotatebook::store
