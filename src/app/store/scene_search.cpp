#include "store/scene_search.h"

#include <algorithm>
#include <system_error>

#include "base/error.h"
#include "base/text.h"
#include "store/clip_files.h"
#include "store/manifest.h"

namespace rotatebook::store {
namespace {

namespace fs = std::filesystem;

/// Returns whether a running or interrupted render keeps its frames in `folder`.
bool isUnfinished(const fs::path& folder) {
  const std::string name = folder.filename().string();
  return name.ends_with(kPartialEnding) || name.ends_with(kReplacedEnding);
}

bool isRecord(const fs::path& file) {
  std::error_code ignored;
  return file.filename() == kSceneCopyName &&
         fs::exists(file.parent_path() / kManifestName, ignored);
}

/// Adds the scenes in `folder` to `found`, and the folders in it to `left`. Links to folders aren't
/// followed, as they may lead back.
void search(const fs::path& folder, FoundScenes& found, std::vector<fs::path>& left) {
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error)) {
    std::error_code ignored;
    const fs::path& path = entry->path();
    if (entry->is_directory(ignored)) {
      if (!entry->is_symlink(ignored) && !isUnfinished(path)) left.push_back(path);
    } else if (path.extension() == ".toml" && !isRecord(path)) {
      found.paths.push_back(path);
    }
  }
  if (error) {
    found.problems.emplace_back(folder,
                                oneLine("can't list " + folder.string() + ": " + error.message()));
  }
}

}  // namespace

FoundScenes scenesBelow(const fs::path& folder) {
  std::error_code error;
  const fs::directory_iterator ignored(folder, error);
  if (error) {
    throw InputError("can't list the scenes in " + folder.string() + ": " + error.message());
  }
  FoundScenes found;
  std::vector<fs::path> left{folder};
  while (!left.empty()) {
    const fs::path next = left.back();
    left.pop_back();
    search(next, found, left);
  }
  std::ranges::sort(found.paths);
  std::ranges::sort(found.problems);
  return found;
}

}  // namespace rotatebook::store
