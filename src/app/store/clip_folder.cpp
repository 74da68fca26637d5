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

bool hasFrames(const fs::path& folder) {
  return fs::is_directory(folder) && !framesIn(folder).empty();
}

bool isOf(const std::optional<Manifest>& manifest, const Manifest::Entries& made) {
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

/// Removes all that a render put into `folder`, and the folder itself if nothing else is in it.
void discard(const fs::path& folder) {
  if (!fs::is_directory(folder)) return;
  // First, so that what is left, if the process is killed, isn't taken for a clip.
  system::removeFile(folder / kManifestName);
  system::removeStaleTemporaries(folder);
  for (const std::int64_t index : framesIn(folder)) system::removeFile(folder / frameName(index));
  system::removeFile(folder / kFrameSumsName);
  system::removeFile(folder / kSceneCopyName);
  std::error_code notEmpty;
  fs::remove(folder, notEmpty);
}

/// Ends the life of NAME.replaced/; what isn't a render's goes to NAME/.
void discardReplaced(const ClipFiles& files) {
  if (!fs::is_directory(files.replacedFolder)) return;
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
  system::flushFolder(files.partialFrameFolder.parent_path());
}

/// Brings to its end what a process that was killed had begun.
void settle(const ClipFiles& files) {
  const bool hasFinal = fs::exists(files.frameFolder);
  if (hasFinal) discardReplaced(files);
  const std::optional<Manifest> partial = readManifest(files.partialFrameFolder);
  if (partial && partial->finished) return replaceFolder(files);
  const bool lacksFinal = !hasFinal && fs::exists(files.replacedFolder);
  if (lacksFinal) moveTo(files.replacedFolder, files.frameFolder);
}

/// Puts the frames that are whole beside those of the same settings in `to`.
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

/// "out/NAME.partial holds 12 frames of a render that wasn't finished", or of a clip that was.
std::string contentText(const fs::path& folder, bool complete) {
  if (complete) return folder.string() + " holds the frames of a clip";
  return folder.string() + " holds " + std::to_string(framesIn(folder).size()) +
         " frames of a render that wasn't finished";
}

/// Whether the manifest says with what the folder's frames were made.
bool knowsSettings(const std::optional<Manifest>& manifest) {
  return manifest && !manifest->own.made.empty();
}

/// " of other settings: KEYS", after that.
std::string differenceText(const fs::path& folder, const std::optional<Manifest>& there,
                           const ClipFolder::Settings& settings) {
  if (!knowsSettings(there)) return " with settings that aren't known";
  return (there->finished ? " of other settings: " : " and had other settings: ") +
         differences(folder, there->own.made, settings.made, settings.scene);
}

/// Throws InputError if `folder` holds what isn't to be lost: unfinished frames, or, of a render
/// that is to go on, a clip of other settings.
void requireLosable(const fs::path& folder, const std::optional<Manifest>& there,
                    const ClipFolder::Settings& settings) {
  const bool resume = settings.earlier.resume;
  const bool complete = there && there->finished;
  const bool worthless = complete ? !resume : !hasFrames(folder);
  if (settings.earlier.overwrite || worthless) return;
  const std::string start = contentText(folder, complete);
  if (isOf(there, settings.made)) {
    throw InputError(start + ": go on with --resume, or render anew with --overwrite");
  }
  throw InputError(start + differenceText(folder, there, settings) +
                   "; render anew with --overwrite, or into another folder with -o");
}

/// Throws InputError if `folder` holds frames of other settings, which a part can't join.
void requireJoinable(const fs::path& folder, const std::optional<Manifest>& there,
                     const ClipFolder::Settings& settings, const std::string& remedy) {
  if (!hasFrames(folder) || isOf(there, settings.made)) return;
  throw InputError(folder.string() + " holds frames of other settings" +
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
  // Better said now than when the folder is to be moved there.
  if (fs::exists(files.frameFolder)) system::createFolders(files.frameFolder);
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
    return isOf(readManifest(path_), manifest_.own.made) ? frameCount() : 0;
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
  if (there) manifest_ = *there;
  manifest_.become(settings.made);
  manifest_.finished = isOf(there, settings.made) && there->finished;
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
      goOn ? finished && !finished->finished : finished || settings.earlier.resume;
  // Without PNGs those that are there stay. To be gone on with, the clip must be known.
  const bool isKnown = finished && finished->filesOf(settings.made) != nullptr;
  const bool asks = settings.png || (settings.earlier.resume && !isKnown);
  if (mayBeLost && asks) requireLosable(files_.frameFolder, finished, settings);
  if (!goOn) {
    requireLosable(files_.partialFrameFolder, partial, settings);
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
  const auto there = readManifest(files_.frameFolder);
  const auto* known = there ? there->filesOf(manifest_.own.made) : nullptr;
  if (known == nullptr || (frames && path_ != files_.frameFolder)) return false;
  for (const fs::path& file : files) {
    const auto sum = known->find(file.filename().string());
    if (sum == known->end() || !fs::is_regular_file(file)) return false;
    if (system::checksumOfFile(file) != sum->second) return false;
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
  Manifest::Entries written;
  for (const fs::path& file : files)
    written[file.filename().string()] = system::checksumOfFile(file);
  frames ? finishWithFrames(written) : finishWithoutFrames(written);
  system::flushFolder(files_.frameFolder.parent_path());
}

void ClipFolder::finishWithFrames(const Manifest::Entries& written) {
  Manifest next = readManifest(files_.frameFolder).value_or(Manifest{});
  next.become(manifest_.own.made);
  next.finished = true;
  next.add(manifest_.own.made, written);
  writeManifest(path_, next);
  if (path_ != files_.frameFolder) replaceFolder(files_);
}

// Frames stay where they are: those of other settings in NAME/, unfinished ones in NAME.partial/.
void ClipFolder::finishWithoutFrames(const Manifest::Entries& written) {
  const std::optional<Manifest> there = readManifest(files_.frameFolder);
  Manifest next = there.value_or(Manifest{});
  if (isOf(there, manifest_.own.made) || !hasFrames(files_.frameFolder)) {
    next.become(manifest_.own.made);
    next.finished = true;
    system::createFolders(files_.frameFolder);
    system::writeFileAtomically(files_.sceneCopy, system::readFileOrEmpty(path_ / kSceneCopyName));
  }
  next.add(manifest_.own.made, written);
  writeManifest(files_.frameFolder, next);
  discardIfEmpty();
}

std::vector<std::string> ClipFolder::keptOfOtherSettings() const {
  const auto there = readManifest(files_.frameFolder);
  if (!there) return {};
  std::vector<std::string> kept;
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
  if (!isOf(there, manifest_.own.made) && hasFrames(files_.frameFolder)) {
    kept.push_back(std::to_string(framesIn(files_.frameFolder).size()) + " frames in " +
                   files_.frameFolder.string() + '/' +
                   (knowsSettings(there) ? "" : " (of unknown settings)"));
  }
  return kept;
}

}  // namespace rotatebook::store
