#include "pipeline/clip_folder.h"

#include <exception>
#include <system_error>
#include <utility>

#include "base/error.h"
#include "pipeline/checksum.h"
#include "pipeline/fingerprint.h"

namespace rotatebook::pipeline {
namespace {

namespace fs = std::filesystem;

bool hasFrames(const fs::path& folder) {
  return fs::is_directory(folder) && !framesIn(folder).empty();
}

bool isOf(const std::optional<Manifest>& manifest, const Manifest::Entries& made) {
  return manifest && manifest->made == made;
}

void moveTo(const fs::path& from, const fs::path& to) {
  std::error_code error;
  fs::rename(from, to, error);
  if (error) {
    throw MachineError("can't move " + from.string() + " to " + to.string() + ": " +
                       error.message());
  }
}

/// Removes all that a render put into `folder`, and the folder itself if nothing else is in it.
void discard(const fs::path& folder) {
  if (!fs::is_directory(folder)) return;
  // First, so that what is left, if the process is killed, isn't taken for a clip.
  removeFile(folder / kManifestName);
  removeStaleTemporaries(folder);
  for (const std::int64_t index : framesIn(folder)) removeFile(folder / frameName(index));
  removeFile(folder / kFrameSumsName);
  removeFile(folder / kSceneCopyName);
  std::error_code notEmpty;
  fs::remove(folder, notEmpty);
}

/// Removes the files of a clip that was replaced, unless they are the new one's, too.
void removeOutdated(const ClipFiles& files, const Manifest& old, const Manifest& now) {
  if (old.made == now.made) return;
  const std::string clip = files.frameFolder.filename().string();
  for (const auto& [name, sum] : old.files) {
    // A manifest is a file that anyone may change: it must not lead elsewhere.
    const bool own = (name.starts_with(clip + '.') || name.starts_with(clip + '_')) &&
                     fs::path(name).filename() == name;
    if (own && !now.files.contains(name)) removeFile(files.frameFolder.parent_path() / name);
  }
}

/// Ends the life of NAME.replaced/; what isn't a render's goes to NAME/.
void discardReplaced(const ClipFiles& files) {
  if (!fs::is_directory(files.replacedFolder)) return;
  const Manifest now = readManifest(files.frameFolder).value_or(Manifest{});
  if (const auto old = readManifest(files.replacedFolder)) removeOutdated(files, *old, now);
  discard(files.replacedFolder);
  if (!fs::is_directory(files.replacedFolder)) return;
  for (const auto& entry : fs::directory_iterator(files.replacedFolder)) {
    const fs::path place = files.frameFolder / entry.path().filename();
    if (!fs::exists(place)) moveTo(entry.path(), place);
  }
  std::error_code notEmpty;
  fs::remove(files.replacedFolder, notEmpty);
}

/// Puts NAME.partial/, which is complete, in the place of NAME/.
void replaceFolder(const ClipFiles& files) {
  if (fs::exists(files.frameFolder)) moveTo(files.frameFolder, files.replacedFolder);
  moveTo(files.partialFrameFolder, files.frameFolder);
  discardReplaced(files);
  flushFolder(files.partialFrameFolder.parent_path());
}

/// Brings to its end what a process that was killed had begun.
void settle(const ClipFiles& files) {
  const bool hasFinal = fs::exists(files.frameFolder);
  if (hasFinal) discardReplaced(files);
  const std::optional<Manifest> partial = readManifest(files.partialFrameFolder);
  if (partial && partial->isComplete()) return replaceFolder(files);
  const bool lacksFinal = !hasFinal && fs::exists(files.replacedFolder);
  if (lacksFinal) moveTo(files.replacedFolder, files.frameFolder);
}

/// Puts the frames that are whole beside those of the same settings in `to`.
void moveFrames(const fs::path& from, const fs::path& to) {
  if (!fs::is_directory(from)) return;
  const FrameSums source(from);
  FrameSums target(to);
  for (const std::int64_t frame : framesIn(from)) {
    const auto bytes = source.intact(frame);
    if (!bytes || target.intact(frame)) continue;
    moveTo(from / frameName(frame), to / frameName(frame));
    target.add(frame, *bytes);
  }
  discard(from);
}

/// "out/NAME.partial holds 12 frames of a render that wasn't finished", or of a clip that was.
std::string contentText(const fs::path& folder, bool complete) {
  if (complete) return folder.string() + " holds the frames of a clip";
  return folder.string() + " holds " + std::to_string(framesIn(folder).size()) +
         " frames of a render that wasn't finished";
}

/// " of other settings: KEYS", after that.
std::string differenceText(const fs::path& folder, const std::optional<Manifest>& there,
                           const ClipFolder::Settings& settings) {
  if (!there) return " and doesn't tell its settings";
  return (there->isComplete() ? " of other settings: " : " and had other settings: ") +
         differences(folder, *there, settings.made, settings.scene);
}

/// Throws InputError if `folder` holds what isn't to be lost: unfinished frames, or, of a render
/// that is to go on, a clip of other settings.
void requireLosable(const fs::path& folder, const std::optional<Manifest>& there,
                    const ClipFolder::Settings& settings) {
  const bool resume = settings.earlier.resume;
  const bool complete = there && there->isComplete();
  const bool worthless = complete ? !resume : !hasFrames(folder);
  if (settings.earlier.overwrite || worthless) return;
  const std::string start = contentText(folder, complete);
  if (!resume) {
    throw InputError(start + ": go on with --resume, or render anew with --overwrite");
  }
  throw InputError(start + differenceText(folder, there, settings) +
                   "; render anew with --overwrite, or into another folder with -o");
}

/// Throws InputError if `folder` holds frames of other settings, which a part can't join.
void requireJoinable(const fs::path& folder, const std::optional<Manifest>& there,
                     const ClipFolder::Settings& settings, const std::string& remedy) {
  if (!hasFrames(folder) || isOf(there, settings.made)) return;
  throw InputError(
      folder.string() + " holds frames of other settings" +
      (there ? ": " + differences(folder, *there, settings.made, settings.scene) : "") +
      "; render into another folder with -o, or " + remedy);
}

}  // namespace

ClipFolder::ClipFolder(const ClipFiles& files, const Settings& settings)
    : lock_(files.frameFolder, settings.part ? Lock::Shared : Lock::Exclusive),
      files_(files),
      manifest_{settings.made, {}} {
  // Better said now than when the folder is to be moved there.
  if (fs::exists(files.frameFolder)) createFolders(files.frameFolder);
  try {
    settings.part ? openPart(settings) : openWhole(settings);
    sums_.emplace(path_);
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
    // What is left hurts nobody.
  }
}

std::size_t ClipFolder::frameCount() const {
  return fs::is_directory(path_) ? framesIn(path_).size() : 0;
}

std::size_t ClipFolder::resumableFrames() const noexcept {
  try {
    // Without its manifest, the folder was emptied from elsewhere meanwhile.
    return isOf(readManifest(path_), manifest_.made) ? frameCount() : 0;
  } catch (const std::exception&) {
    return 0;  // What can't be read can't be resumed.
  }
}

void ClipFolder::openPart(const Settings& settings) {
  const auto there = readManifest(files_.frameFolder);
  requireJoinable(files_.frameFolder, there, settings, "remove it");
  // Of a whole clip's unfinished frames and a part, one would take the other's place in the end.
  if (settings.png) {
    requireJoinable(files_.partialFrameFolder, readManifest(files_.partialFrameFolder), settings,
                    "finish that render first, with --resume");
  }
  if (isOf(there, settings.made)) manifest_ = *there;
  path_ = files_.frameFolder;
  if (settings.png) begin(path_, settings.record);
}

void ClipFolder::openWhole(const Settings& settings) {
  settle(files_);
  const auto finished = readManifest(files_.frameFolder);
  const auto partial = readManifest(files_.partialFrameFolder);
  const bool goOn = settings.earlier.resume && isOf(partial, settings.made);
  if (settings.earlier.resume && isOf(finished, settings.made)) {
    manifest_ = *finished;
    begin(files_.frameFolder, settings.record);
    if (goOn) moveFrames(files_.partialFrameFolder, files_.frameFolder);
    // Of a process that was killed before it had a frame.
    if (!hasFrames(files_.partialFrameFolder)) discard(files_.partialFrameFolder);
    return;
  }
  // Frames that tell nothing of themselves are no render's of this kind. A clip made way when what
  // goes on was begun; parts didn't.
  const bool mayBeLost =
      goOn ? finished && !finished->isComplete() : finished || settings.earlier.resume;
  if (mayBeLost) requireLosable(files_.frameFolder, finished, settings);
  if (!goOn) {
    requireLosable(files_.partialFrameFolder, partial, settings);
    discard(files_.partialFrameFolder);
  }
  begin(files_.partialFrameFolder, settings.record);
}

void ClipFolder::begin(const fs::path& folder, const std::string& record) {
  path_ = folder;
  createFolders(folder);
  writeFileAtomically(folder / kSceneCopyName, record);
  writeManifest(folder, manifest_);
}

bool ClipFolder::isDone(const std::vector<fs::path>& files,
                        std::optional<FrameRange> frames) const {
  if (!manifest_.isComplete()) return false;
  for (const fs::path& file : files) {
    const auto known = manifest_.files.find(file.filename().string());
    if (known == manifest_.files.end() || !fs::is_regular_file(file)) return false;
    if (checksumOfFile(file) != known->second) return false;
  }
  if (!frames) return true;
  for (std::int64_t frame = frames->first; frame < frames->end; ++frame) {
    if (!sums_->intact(frame)) return false;
  }
  return true;
}

void ClipFolder::finish(const std::vector<fs::path>& files, std::optional<FrameRange> frames) {
  if (frames) {
    sums_->requireFiles(*frames);
    sums_->sort(*frames);
  }
  for (const fs::path& file : files) {
    manifest_.files[file.filename().string()] = checksumOfFile(file);
  }
  const std::optional<Manifest> earlier = readManifest(files_.frameFolder);
  const bool same = isOf(earlier, manifest_.made);
  // Other formats' videos of the same settings are still true.
  if (same) manifest_.files.insert(earlier->files.begin(), earlier->files.end());
  const bool inPlace = path_ == files_.frameFolder;
  if (inPlace || (same && !frames)) {
    writeManifest(files_.frameFolder, manifest_);
    if (!inPlace) discard(path_);
    return flushFolder(files_.frameFolder.parent_path());
  }
  writeManifest(path_, manifest_);
  replaceFolder(files_);
}

}  // namespace rotatebook::pipeline
