#include "cli/input_guard.h"

#include <system_error>

#include "base/error.h"
#include "picture/texture_files.h"

namespace rotatebook::cli {
namespace {

namespace fs = std::filesystem;

bool areSame(const fs::path& one, const fs::path& other) {
  std::error_code missing;
  return fs::equivalent(one, other, missing);
}

/// Returns whether a render that puts its frames into `folder` would replace `file` there.
bool isReplacedIn(const fs::path& folder, const fs::path& file) {
  const std::string name = file.filename().string();
  const bool own = name == store::kSceneCopyName || store::frameIndex(name);
  return own && areSame(folder / name, file);
}

std::vector<fs::path> filesOf(const scene::Scene& scene, const pipeline::RenderOptions& options,
                              const store::ClipFiles& whole) {
  const store::ClipFiles files =
      options.frames ? store::clipFiles(options.folder, scene.name, *options.frames) : whole;
  std::vector<fs::path> all = store::csvFiles(files.csv, scene);
  if (!options.frames) all.push_back(files.poster);
  for (const video::VideoFormat format : formatsOf(options.outputs)) {
    all.push_back(files.video(format));
  }
  return all;
}

}  // namespace

std::vector<Input> texturesOf(const scene::Scene& scene) {
  std::vector<Input> inputs;
  for (const fs::path& texture : picture::textureFiles(scene)) {
    inputs.push_back({texture, "a texture of the scene " + scene.name});
  }
  return inputs;
}

std::vector<Input> inputsOf(const fs::path& path, const scene::Scene& scene) {
  std::vector<Input> inputs = texturesOf(scene);
  inputs.push_back({path, "the scene itself"});
  return inputs;
}

void refuseInputs(const fs::path& output, const std::vector<Input>& inputs,
                  const std::string& remedy) {
  for (const auto& [path, what] : inputs) {
    if (areSame(output, path)) throw InputError(output.string() + " is " + what + "; " + remedy);
  }
}

void refuseInputs(const scene::Scene& scene, const pipeline::RenderOptions& options,
                  const std::vector<Input>& inputs) {
  const std::string remedy = "name another folder with -o";
  const store::ClipFiles files = store::clipFiles(options.folder, scene.name);
  for (const fs::path& file : filesOf(scene, options, files)) refuseInputs(file, inputs, remedy);
  if (options.frames && !hasPng(options.outputs)) return;
  for (const auto& [path, what] : inputs) {
    if (!isReplacedIn(files.frameFolder, path)) continue;
    throw InputError(path.string() + " is " + what + ", and lies where the render of " +
                     scene.name + " puts its frames; " + remedy);
  }
}

}  // namespace rotatebook::cli
