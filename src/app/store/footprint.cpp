#include "store/footprint.h"

#include <sys/stat.h>
#include <system_error>

#include "store/frame_checksums.h"
#include "store/manifest.h"
#include "system/temporary_files.h"

namespace rotatebook::store {
namespace {

namespace fs = std::filesystem;

/// Returns the folder that holds the file at `path`.
fs::path parentOf(const fs::path& path) {
  return path.has_parent_path() ? path.parent_path() : fs::path(".");
}

/// Returns `path` and, if it is a link, the paths that it leads through.
std::vector<fs::path> chainOf(const fs::path& path) {
  constexpr std::size_t kMaxLinks = 40;  // As Linux has it.
  std::vector<fs::path> chain{path};
  std::error_code error;
  while (chain.size() <= kMaxLinks && fs::is_symlink(chain.back(), error)) {
    const fs::path target = fs::read_symlink(chain.back(), error);
    if (error) break;
    chain.push_back(chain.back().parent_path() / target);
  }
  return chain;
}

}  // namespace

std::optional<Footprint::Identity> Footprint::identityOf(const fs::path& path) {
  struct stat status {};
  if (stat(path.c_str(), &status) != 0) return std::nullopt;
  return Identity{status.st_dev, status.st_ino};
}

void Footprint::addFolder(std::set<Identity>& folders, const fs::path& folder) {
  if (const auto identity = identityOf(folder)) folders.insert(*identity);
}

void Footprint::addFile(const fs::path& file) {
  if (const auto identity = identityOf(file)) files_.insert(*identity);
  addFolder(tidied_, parentOf(file));
}

void Footprint::addPartialVideos(const ClipFiles& files,
                                 const std::vector<video::VideoFormat>& formats) {
  for (const video::VideoFormat format : formats) addFile(files.partialVideo(format));
}

void Footprint::addClip(const fs::path& folder, const scene::Scene& scene,
                        const std::vector<video::VideoFormat>& formats) {
  const ClipFiles files = clipFiles(folder, scene.name);
  for (const fs::path& file : outputFiles(files, scene, formats)) addFile(file);
  addPartialVideos(files, formats);
  addFolder(frames_, files.frameFolder);
  addFolder(tidied_, files.frameFolder);
  addFolder(moved_, files.partialFrameFolder);
  addFolder(moved_, files.replacedFolder);
}

void Footprint::addPart(const fs::path& folder, const scene::Scene& scene, FrameRange part,
                        const std::vector<video::VideoFormat>& formats, bool png) {
  const ClipFiles files = clipFiles(folder, scene.name, part);
  for (const fs::path& file : outputFiles(files, scene, formats)) addFile(file);
  addPartialVideos(files, formats);
  if (png) addFrames(folder, scene);
}

void Footprint::addFrames(const fs::path& folder, const scene::Scene& scene) {
  const ClipFiles files = clipFiles(folder, scene.name);
  addFolder(frames_, files.frameFolder);
  addFolder(tidied_, files.frameFolder);
}

void Footprint::addStudy(const StudyFiles& files) {
  for (const fs::path& file : allOf(files)) addFile(file);
}

void Footprint::addMap(const MapFiles& files) {
  for (const fs::path& file : allOf(files)) addFile(file);
  addFile(files.film);
  addFolder(moved_, files.tiles);
  addFolder(moved_, files.filmFrames);
}

void Footprint::addWholeFolder(const fs::path& folder) {
  addFolder(moved_, folder);
}

std::optional<std::string> Footprint::fateOf(const fs::path& path) const {
  if (!identityOf(path)) return std::nullopt;
  for (const fs::path& name : chainOf(path)) {
    if (const auto fate = fateOfName(name)) return fate;
  }
  return std::nullopt;
}

std::optional<std::string> Footprint::fateOfName(const fs::path& path) const {
  const auto holds = [](const std::set<Identity>& all, const fs::path& wanted) {
    const auto identity = identityOf(wanted);
    return identity && all.contains(*identity);
  };
  if (holds(files_, path)) return "replaced";

  // Compare its name with those that belong to the program in its folder
  const fs::path folder = parentOf(path);
  const std::string name = path.filename().string();
  if (system::isTemporaryName(name) && holds(tidied_, folder)) return "removed";
  if (isNameInFrameFolder(name) && holds(frames_, folder)) return "replaced";

  // Look for the folders that are moved among those above it
  std::error_code error;
  for (fs::path above = fs::canonical(folder, error); !above.empty(); above = above.parent_path()) {
    if (holds(moved_, above)) return "moved or removed";
    if (above == above.root_path()) break;
  }
  return std::nullopt;
}

}  // namespace rotatebook::store
