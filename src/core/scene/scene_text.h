// Reads scenes from TOML text, and prints them as TOML.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include "scene/read_named_file.h"
#include "scene/scene.h"

namespace rotatebook::scene {

/// Reads and validates the text of a scene. `path` names it in messages and gives Scene::name and
/// Scene::folder; it isn't opened. Throws InputError with a line
/// "FILE:LINE:COLUMN: PROBLEM" for each problem, in the order of the file, with the nearest valid
/// key or value; of more than 20 problems the first ones.
///
/// `overrides` are "key.path=value" as --set takes them: the value is TOML, or else a bare string.
/// They count as part of the file; messages give their location as "--set KEY=VALUE". Setting one
/// of initial.angular_velocity and initial.angular_momentum removes the other.
///
/// `readNamedFile` reads the files that overlay.words and body.mesh may name, and others as
/// readMotionFiles() does; without it, the former are refused, and the latter aren't read.
Scene parseScene(std::string_view text, const std::filesystem::path& path,
                 std::span<const std::string> overrides = {},
                 const ReadNamedFile& readNamedFile = {});

/// Returns the scene as TOML with every default explicit. Reading it back gives an equal scene.
std::string sceneText(const Scene& scene);

/// Returns that text without comments, and without what is so by default: as one would write it.
/// Reading it back gives an equal scene, too.
std::string briefText(const Scene& scene);

/// Returns the part of that text that the clip's motions depend on: all keys but those whose rows
/// say that they affect pictures or texts alone. The same text is of the same motions.
std::string motionText(const Scene& scene);
/// Returns likewise what the runs of the scene's study, and what is expected of them, depend on.
std::string studyRunsText(const Scene& scene);
/// Returns likewise what the runs of the scene's map depend on; it must have one.
std::string mapRunsText(Scene scene);

}  // namespace rotatebook::scene
