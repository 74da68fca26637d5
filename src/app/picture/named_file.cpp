#include "picture/named_file.h"

#include <algorithm>
#include <system_error>

#include "base/error.h"

namespace rotatebook::picture {

namespace fs = std::filesystem;

std::vector<NamedFile> namedFiles(const scene::Scene& scene) {
  std::vector<NamedFile> files;
  const auto add = [&](const std::string& name, const char* kind) {
    const fs::path path = scene.folder / name;
    if (name.empty() || std::ranges::count(files, path, &NamedFile::path) > 0) return;
    files.push_back({path, kind});
  };
  const auto addOf = [&](const scene::Motion& motion) {
    add(motion.solid.mesh.name, "mesh");
    add(motion.simulation.recorded.file, "recording");
  };
  for (const std::string& side : {scene.book.front, scene.book.spine, scene.book.back})
    add(side == scene::kBuiltin ? "" : side, "texture");
  for (const scene::Panel& panel : scene.motions) addOf(panel);
  for (const scene::StudyRun& run : scene.runs)
    add(run.motion.simulation.recorded.file, "recording");
  if (!scene.wordsFile.empty()) files.push_back({scene.wordsFile, "table of words"});
  return files;
}

fs::path pathOfNamedFile(const fs::path& folder, const fs::path& file, bool allowOutside) {
  fs::path path = folder / file;
  if (allowOutside) return path;
  std::error_code error;
  const fs::path within = fs::canonical(folder.empty() ? "." : folder, error);
  const fs::path real = error ? fs::path() : fs::weakly_canonical(within / file, error);
  if (error) throw InputError("can't read " + path.string() + ": " + error.message());
  if (std::ranges::mismatch(within, real).in1 == within.end()) return path;
  throw InputError("can't read " + path.string() +
                   ": it leads outside the scene's folder, which --allow-outside allows");
}

}  // namespace rotatebook::picture
