// The section [body], and what follows from it. Inside the room only.
#pragma once

#include "document/toml_tree.h"
#include "scene/keys/section.h"
#include "scene/scene.h"
#include "scene/scene_text.h"

namespace rotatebook::scene {

/// Returns the section. Of a body that isn't the book, size, mass and inertia follow.
Section<Motion> bodySection();

/// Replaces the names of meshes in [body], also of panels, by the numbers that motions take of the
/// files. Throws DocumentError if one can't be read, or isn't the surface of a body.
void includeMeshes(document::TomlNode& root, const ReadNamedFile& readNamedFile);

}  // namespace rotatebook::scene
