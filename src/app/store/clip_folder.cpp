#include "store/clip_folder.h"

#include <algorithm>
#include <exception>
#include <system_error>
#include <utility>

#include "base/error.h"
#include "store/fingerprint.h"
#include "system/file_checksum.h"
#include "system/read_file.h"

namespace rotatebook::store {
namespace {

namespace fs = std::filesystem;

/// Returns whether `folder` exists and holds frames.
bool hasFrames(const fs::path& folder) {
  return fs::is_directory(folder) && !framesIn(folder).empty();
}

/// Returns whether the folder's own frames have the fingerprint `made`.
bool isMadeWith(const std::optional<Manifest>& manifest, const Manifest::Entries& made) {
  return manifest && manifest->own.made == made;
}

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

/// Replaces NAME/ by NAME.partial/, which is complete. If the process is killed on the way,
/// recover() does the rest.
void replaceFolder(const ClipFiles& files) {
  if (fs::exists(files.frameFolder)) moveTo(files.frameFolder, files.replacedFolder);
  moveTo(files.partialFrameFolder, files.frameFolder);
  discardReplaced(files);
  system::flushFolder(files.partialFrameFolder.parent_path());
}

/// Completes or undoes a replacement that a killed process left half done.
void recover(const ClipFiles& files) {
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
  return folder.string() + " holds " + std::to_string(framesIn(folder).size()) +
         " frames of a render that wasn't finished";
}

/// Returns whether the manifest states the settings of the folder's frames.
bool knowsSettings(const std::optional<Manifest>& manifest) {
  return manifest && !manifest->own.made.empty();
}

/// Returns what follows contentText(): how the settings of the frames in `folder` differ.
std::string differenceText(const fs::path& folder, const std::optional<Manifest>& there,
                           const ClipFolder::Settings& settings) {
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
  const bool discardable = complete ? !resume : !hasFrames(folder);
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
      manifest_{.own = {settings.made, {}}} {
  // Fail now, rather than after all is drawn, if NAME/ is no folder
  if (fs::exists(files.frameFolder)) system::createFolders(files.frameFolder);
  try {
    settings.part ? openPart(settings) : openWhole(settings);
    checksums_.emplace(path_);
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
  recover(files_);

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

  // Refuse to replace a clip or parts in NAME/ that must not be lost. Frames without a manifest are
  // protected only if --resume is given. When the render to resume began, it was allowed to replace
  // a finished clip, but not parts.
  const bool atRisk =
      resumesPartial ? finished && !finished->finished : finished || settings.earlier.resume;
  // A render without PNGs leaves NAME/ as it is, but can resume only a clip that has its settings.
  const bool isKnown = finished && finished->filesOf(settings.made) != nullptr;
  const bool mustCheck = settings.png || (settings.earlier.resume && !isKnown);
  if (atRisk && mustCheck) requireDiscardable(files_.frameFolder, finished, settings);

  // Discard unfinished frames that aren't resumed, if that is allowed
  if (!resumesPartial) {
    requireDiscardable(files_.partialFrameFolder, partial, settings);
    discard(files_.partialFrameFolder);
  }

  begin(files_.partialFrameFolder, settings.record);
}

void ClipFolder::begin(const fs::path& folder, const std::string& record) {
  path_ = folder;
  system::createFolders(folder);
  system::writeFileAtomically(folder / kSceneCopyName, record);
  writeManifest(folder, manifest_);
}

bool ClipFolder::isDone(const std::vector<fs::path>& files,
                        std::optional<FrameRange> frames) const {
  // Find the earlier render with the same settings
  const auto there = readManifest(files_.frameFolder);
  const auto* known = there ? there->filesOf(manifest_.own.made) : nullptr;
  if (known == nullptr || (frames && path_ != files_.frameFolder)) return false;

  // Compare the files with their checksums
  for (const fs::path& file : files) {
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

void ClipFolder::finish(const std::vector<fs::path>& files, std::optional<FrameRange> frames) {
  // Complete the frames' checksums
  if (frames) {
    checksums_->requireFiles(*frames);
    checksums_->sort(*frames);
  }

  // Take the checksums of the other files
  Manifest::Entries written;
  for (const fs::path& file : files)
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

  // Move the folder to its final name
  if (path_ != files_.frameFolder) replaceFolder(files_);
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
  discardIfEmpty();
}

std::vector<std::string> ClipFolder::keptOfOtherSettings() const {
  const auto there = readManifest(files_.frameFolder);
  if (!there) return {};
  std::vector<std::string> kept;

  // Collect the files of other renders that still are as these wrote them
  const auto addFiles = [&](const Manifest::Render& render) {
    if (render.made == manifest_.own.made) return;
    for (const auto& [name, sum] : render.files) {
      const fs::path file = files_.frameFolder.parent_path() / name;
      const bool isPlain = fs::path(name).filename() == name && fs::is_regular_file(file);
      if (isPlain && system::checksumOfFile(file) == sum) kept.push_back(file.string());
    }
  };
  addFiles(there->own);
  std::ranges::for_each(there->others, addFiles);
  std::ranges::sort(kept);

  // Add the frames of another render
  if (!isMadeWith(there, manifest_.own.made) && hasFrames(files_.frameFolder)) {
    kept.push_back(std::to_string(framesIn(files_.frameFolder).size()) + " frames in " +
                   files_.frameFolder.string() + '/' +
                   (knowsSettings(there) ? "" : " (with unknown settings)"));
  }
  return kept;
}

}  // namespace rotatebook::store
