#include "store/folder_guard.h"

#include <iterator>

#include <fmt/core.h>

#include "base/error.h"
#include "base/text.h"
#include "store/clip_record.h"
#include "store/fingerprint.h"
#include "store/frame_checksums.h"
#include "store/other_settings.h"
#include "system/atomic_file.h"
#include "system/read_file.h"
#include "system/removal.h"

namespace rotatebook::store {
namespace {

namespace fs = std::filesystem;

/// Returns "out/NAME holds the frames of a clip" if `there` is complete, else "out/NAME.partial
/// holds 12 frames of a render that wasn't finished", or "of unknown origin".
std::string contentText(const fs::path& folder, const std::optional<Manifest>& there) {
  if (there && there->finished) return folder.string() + " holds the frames of a clip";
  if (!hasFrames(folder)) return folder.string() + " holds a scene.toml that no render left there";
  return fmt::format("{} holds {} of {}", folder.string(),
                     countText(std::ssize(framesIn(folder)), "frame"),
                     knowsSettings(there) ? "a render that wasn't finished" : "unknown origin");
}

/// Returns what follows contentText(): how the settings of the frames in `folder` differ.
std::string differenceText(const fs::path& folder, const std::optional<Manifest>& there,
                           const ClipSettings& settings) {
  if (!hasFrames(folder) || !knowsSettings(there)) return "";
  return (there->finished ? " with other settings: " : " and had other settings: ") +
         differences(folder, there->own.made, settings.made, settings.scene);
}

constexpr const char* kForeignRemedy = "; move it away, or replace it with --overwrite";

}  // namespace

bool hasForeignRecord(const fs::path& folder) {
  const fs::path file = folder / kSceneCopyName;
  if (!fs::exists(file)) return false;
  try {
    return !looksLikeRecord(system::readFile(file, 1 << 28));
  } catch (const InputError&) {
    return true;
  }
}

void refuseForeignFiles(const fs::path& folder, const std::optional<Manifest>& there,
                        const ClipSettings& settings) {
  if (settings.earlier.overwrite) return;
  if (hasForeignRecord(folder)) {
    throw InputError(fmt::format("{} holds a scene.toml that no render left there{}",
                                 folder.string(), kForeignRemedy));
  }
  // Frames that aren't of a finished clip are discarded by --overwrite alone
  if (!settings.png || !there || !there->finished) return;
  const bool redraws = settings.earlier.resume && isMadeWith(there, settings.made);
  const std::vector<std::int64_t> foreign = FrameChecksums(folder).foreignFrames(!redraws);
  if (foreign.empty()) return;
  throw InputError(fmt::format("{} {} added or changed after the clip was made{}",
                               (folder / frameName(foreign.front())).string(),
                               foreign.size() > 1 ? "and others there were" : "was",
                               kForeignRemedy));
}

void requireDiscardable(const fs::path& folder, const std::optional<Manifest>& there,
                        const ClipSettings& settings) {
  const bool resume = settings.earlier.resume;
  const bool complete = there && there->finished;
  const bool discardable = complete ? !resume : !hasFrames(folder) && !hasForeignRecord(folder);
  if (settings.earlier.overwrite || discardable) return;
  const std::string start = contentText(folder, there);
  if (isMadeWith(there, settings.made)) {
    throw InputError(start + ": go on with --resume, or render again with --overwrite");
  }
  throw InputError(start + differenceText(folder, there, settings) +
                   "; render again with --overwrite, or into another folder with -o");
}

void requireJoinable(const fs::path& folder, const std::optional<Manifest>& there,
                     const ClipSettings& settings, const std::string& remedy) {
  if (isMadeWith(there, settings.made)) return;
  const bool holds = hasFrames(folder);
  const bool awaits = knowsSettings(there) && !there->finished;
  if (!holds && !awaits) return;
  throw InputError(fmt::format(
      "{} {} with other settings{}; render into another folder with -o, or {}", folder.string(),
      holds ? "holds frames" : "awaits the frames of a part that began",
      knowsSettings(there)
          ? ": " + differences(folder, there->own.made, settings.made, settings.scene)
          : "",
      remedy));
}

void requireReplaceableFiles(const std::vector<fs::path>& files) {
  for (const fs::path& file : files) {
    system::requireReplaceable(file);
    const std::string obstacle = system::obstacleToRemoval(file);
    if (obstacle.empty()) continue;
    throw MachineError(fmt::format(
        "can't replace {}: {}; have its owner remove it, or render into another folder with -o",
        file.string(), obstacle));
  }
}

}  // namespace rotatebook::store
