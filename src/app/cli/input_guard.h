// Results that would take the place of what they are made from. Inside the room only.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "pipeline/render_clip.h"
#include "scene/scene.h"

namespace rotatebook::cli {

/// A file that is read.
struct Input {
  std::filesystem::path path;
  std::string what;  ///< "the scene itself"
};

/// The pictures that `scene` names.
std::vector<Input> texturesOf(const scene::Scene& scene);
/// The same, and the scene's own file, at `path`.
std::vector<Input> inputsOf(const std::filesystem::path& path, const scene::Scene& scene);

/// Throws InputError "`output` is WHAT; `remedy`" if it is one of `inputs`, by whatever name.
void refuseInputs(const std::filesystem::path& output, const std::vector<Input>& inputs,
                  const std::string& remedy);

/// The same for all that a render of `scene` writes, and for the folders that it replaces.
void refuseInputs(const scene::Scene& scene, const pipeline::RenderOptions& options,
                  const std::vector<Input>& inputs);

}  // namespace rotatebook::cli
