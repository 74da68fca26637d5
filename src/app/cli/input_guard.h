// Checks that no result replaces a file that it is made from. Inside the room only.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "pipeline/render_clip.h"
#include "scene/scene.h"

namespace rotatebook::cli {

/// A file that a command reads.
struct Input {
  std::filesystem::path path;
  std::string what;  ///< Its description in messages: "the scene itself".
};

/// Returns the textures that `scene` names.
std::vector<Input> texturesOf(const scene::Scene& scene);
/// Returns the textures and the scene's own file, at `path`.
std::vector<Input> inputsOf(const std::filesystem::path& path, const scene::Scene& scene);

/// Throws InputError "`output` is WHAT; `remedy`" if it is the same file as one of `inputs`, under
/// whatever name.
void refuseInputs(const std::filesystem::path& output, const std::vector<Input>& inputs,
                  const std::string& remedy);

/// Throws likewise if a render of `scene` would write one of `inputs`, or replace a folder that
/// holds one.
void refuseInputs(const scene::Scene& scene, const pipeline::RenderOptions& options,
                  const std::vector<Input>& inputs);

}  // namespace rotatebook::cli
