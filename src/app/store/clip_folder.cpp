#include "store/clip_folder.h"

#include <algorithm>
#include <exception>
#include <iterator>
#include <system_error>
#include <utility>

#include "base/error.h"
#include "store/clip_record.h"
#include "store/fingerprint.h"
#include "system/file_checksum.h"
#include "system/read_file.h"
#include "system/removal.h"

namespace rotatebook::store {
namespace {

namespace fs = std::filesystem;

void moveTo(const fs::path& from, const fs::path& to) {
  std::error_code error;
  fs::rename(from, to, error);
  if (error) {
    throw MachineError("can't move " + from.string() + " to " + to.string() + ": " +
                       error.message());
  }
}

/// Removes everything that a render wrote into `folder`, and `folder` itself if that empties it.
void discard(const fs::path& folder) {
  if (!fs::is_directory(folder)) return;
  // Remove the manifest first: if the process is killed, what remains isn't taken for a clip
  system::removeFile(folder / kManifestName);

  // Remove frames, checksums and scene
  system::removeStaleTemporaries(folder);
  for (const std::int64_t index : framesIn(folder)) system::removeFile(folder / frameName(index));
  system::removeFile(folder / kFrameChecksumsName);
  system::removeFile(folder / kSceneCopyName);

  // Remove the folder unless it holds other files
  std::error_code notEmpty;
  fs::remove(folder, notEmpty);
}

/// Returns whether `folder` has a scene.toml that no render of this program left there.
bool hasForeignRecord(const fs::path& folder) {
  const fs::path file = folder / kSceneCopyName;
  return fs::exists(file) && !looksLikeRecord(system::readFileOrEmpty(file));
}

/// Returns whether NAME.replaced/ may hold what no render of this program left. One whose removal
/// was cut short has no manifest, but its checksums are removed after its frames.
bool isForeign(const fs::path& replaced) {
  if (readManifest(replaced) || fs::exists(replaced / kFrameChecksumsName)) return false;
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

/// Returns why NAME.replaced/ can't be removed; empty if it can or there is none.
std::string obstacleToDiscarding(const ClipFiles& files) {
  const fs::path& folder = files.replacedFolder;
  if (!fs::is_directory(folder)) return "";
  std::string obstacle = system::obstacleToRemoval(folder);
  if (obstacle.empty()) obstacle = system::obstacleToEmptying(folder);
  if (obstacle.empty()) return "";
  return "the earlier clip in " + folder.string() + "/ can't be removed: " + obstacle +
         "; have its owner remove it";
}

/// Replaces NAME/ by NAME.partial/, which is complete. If the process is killed on the way,
/// recover() does the rest.
void replaceFolder(const ClipFiles& files) {
  if (fs::exists(files.frameFolder)) moveTo(files.frameFolder, files.replacedFolder);
  moveTo(files.partialFrameFolder, files.frameFolder);
  if (obstacleToDiscarding(files).empty()) discardReplaced(files);
  system::flushFolder(files.partialFrameFolder.parent_path());
}

/// Completes or undoes a replacement that a killed process left half done, unless NAME.replaced/
/// can't be removed.
void recover(const ClipFiles& files, const EarlierFrames& earlier) {
  if (!earlier.overwrite && isForeign(files.replacedFolder)) {
    throw InputError(files.replacedFolder.string() +
                     " holds files that this program's renders didn't leave, and would be removed; "
                     "rename it, or remove it with --overwrite");
  }
  // Discard the replaced clip if another is in its place
  const bool hasFinal = fs::exists(files.frameFolder);
  if (hasFinal) discardReplaced(files);

  // Complete the replacement if the new clip is complete
  const std::optional<Manifest> partial = readManifest(files.partialFrameFolder);
  if (partial && partial->finished) return replaceFolder(files);

  // Move the replaced clip back if no other is in its place
  const bool lacksFinal = !hasFinal && fs::exists(files.replacedFolder);
  if (lacksFinal) moveTo(files.replacedFolder, files.frameFolder);
}

/// Moves the intact frames of `from` that `to` lacks into `to`, which has the same settings, and
/// discards `from`.
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

/// Returns "out/NAME holds the frames of a clip" if `complete`, else "out/NAME.partial holds 12
/// frames of a render that wasn't finished".
std::string contentText(const fs::path& folder, bool complete) {
  if (complete) return folder.string() + " holds the frames of a clip";
  if (!hasFrames(folder)) return folder.string() + " holds a scene.toml that no render left there";
  return folder.string() + " holds " + framesText(std::ssize(framesIn(folder))) +
         " of a render that wasn't finished";
}

/// Returns what follows contentText(): how the settings of the frames in `folder` differ.
std::string differenceText(const fs::path& folder, const std::optional<Manifest>& there,
                           const ClipFolder::Settings& settings) {
  if (!hasFrames(folder)) return "";
  if (!knowsSettings(there)) return " with unknown settings";
  return (there->finished ? " with other settings: " : " and had other settings: ") +
         differences(folder, there->own.made, settings.made, settings.scene);
}

/// Throws InputError unless the frames in `folder` may be discarded. Unfinished frames may not,
/// nor, if the render is to resume, a clip; --overwrite allows both.
void requireDiscardable(const fs::path& folder, const std::optional<Manifest>& there,
                        const ClipFolder::Settings& settings) {
  const bool resume = settings.earlier.resume;
  const bool complete = there && there->finished;
  const bool foreign = !knowsSettings(there) && hasForeignRecord(folder);
  const bool discardable = complete ? !resume : !hasFrames(folder) && !foreign;
  if (settings.earlier.overwrite || discardable) return;
  const std::string start = contentText(folder, complete);
  if (isMadeWith(there, settings.made)) {
    throw InputError(start + ": go on with --resume, or render again with --overwrite");
  }
  throw InputError(start + differenceText(folder, there, settings) +
                   "; render again with --overwrite, or into another folder with -o");
}

/// Throws InputError if `folder` holds frames with other settings, which a part can't join.
void requireJoinable(const fs::path& folder, const std::optional<Manifest>& there,
                     const ClipFolder::Settings& settings, const std::string& remedy) {
  if (!there && hasForeignRecord(folder))
    throw InputError(contentText(folder, false) + "; " + remedy);
  if (!hasFrames(folder) || isMadeWith(there, settings.made)) return;
  throw InputError(folder.string() + " holds frames with other settings" +
                   (knowsSettings(there)
                        ? ": " + differences(folder, there->own.made, settings.made, settings.scene)
                        : "") +
                   "; render into another folder with -o, or " + remedy);
}

}  // namespace

ClipFolder::ClipFolder(const ClipFiles& files, const Settings& settings)
    : lock_(files.frameFolder, settings.part ? system::Lock::Shared : system::Lock::Exclusive),
      files_(files),
      outputs_(settings.outputs),
      manifest_{.own = {settings.made, {}}} {
  // Fail now, rather than after all is drawn, if NAME/ is no folder
  if (fs::exists(files.frameFolder)) system::createFolders(files.frameFolder);
  if (!settings.earlier.overwrite) refuseFilesOfOtherClips(files, outputs_);
  try {
    settings.part ? openPart(settings) : openWhole(settings);
    checksums_.emplace(path_);
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
    requireJoinable(files_.partialFrameFolder, readManifest(files_.partialFrameFolder), settings,
                    "finish that render first, with --resume");
  }

  // Add this render to the manifest of NAME/, and keep the others there
  if (there) manifest_ = *there;
  manifest_.become(settings.made);
  manifest_.finished = isMadeWith(there, settings.made) && there->finished;

  // Write scene and manifest where frames will be
  path_ = files_.frameFolder;
  if (settings.png) begin(path_, settings.record);
}

void ClipFolder::openWhole(const Settings& settings) {
  remainder_ = obstacleToDiscarding(files_);
  if (remainder_.empty()) {
    recover(files_, settings.earlier);
    remainder_ = obstacleToDiscarding(files_);
  }

  // Look for earlier frames of the same settings
  const auto finished = readManifest(files_.frameFolder);
  const auto partial = readManifest(files_.partialFrameFolder);
  const bool resumesPartial = settings.earlier.resume && isMadeWith(partial, settings.made);

  // Resume in NAME/ if its frames have the same settings
  if (settings.earlier.resume && isMadeWith(finished, settings.made)) {
    manifest_ = *finished;
    begin(files_.frameFolder, settings.record);
    if (resumesPartial) moveFrames(files_.partialFrameFolder, files_.frameFolder);
    // Remove the folder of a process that was killed before its first frame
    if (!hasFrames(files_.partialFrameFolder)) discard(files_.partialFrameFolder);
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
  if (png && !remainder_.empty()) {
    throw MachineError(remainder_ + ", or render into another folder with -o");
  }
  std::string obstacle = system::obstacleToEmptying(files_.frameFolder);
  if (png && obstacle.empty()) obstacle = system::obstacleToRemoval(files_.frameFolder);
  if (obstacle.empty()) return;
  throw MachineError("can't replace the clip in " + files_.frameFolder.string() + "/: " + obstacle +
                     "; have its owner remove it, or render into another folder with -o");
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
    if (sum == known->end() || !fs::is_regular_file(file)) return false;
    if (system::checksumOfFile(file) != sum->second) return false;
  }

  // Compare the frames with theirs
  if (!frames) return true;
  for (std::int64_t frame = frames->first; frame < frames->end; ++frame) {
    if (!checksums_->intact(frame)) return false;
  }
  return true;
}

void ClipFolder::finishPart(FrameRange frames) {
  checksums_->requireUnchanged(frames);
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

  // Claim NAME/ unless it holds frames of other settings
  if (isMadeWith(there, manifest_.own.made) || !hasFrames(files_.frameFolder)) {
    next.become(manifest_.own.made);
    next.finished = true;
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
