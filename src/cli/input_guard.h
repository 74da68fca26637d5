// Results that would take the place of what they are made from.
#pragma once

#include <filesystem>
#include <string>

#include "scene/scene.h"

namespace rotatebook::cli {

/// Throws InputError "`output` is `what`; `remedy`" if `output` is the file `input`, by whatever
/// name.
void refuseInput(const std::filesystem::path& output, const std::filesystem::path& input,
                 const std::string& what, const std::string& remedy);

/// The same for what `scene` is read from: its file at `path`, and its textures.
void refuseInputs(const std::filesystem::path& output, const std::filesystem::path& path,
                  const scene::Scene& scene, const std::string& remedy);

}  // namespace rotatebook::cli
