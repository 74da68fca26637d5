// The section [body], and the files that it names. Inside the room only.
#pragma once

#include <functional>
#include <map>
#include <string>

#include "base/document/toml_tree.h"
#include "scene/keys/section.h"
#include "scene/read_named_file.h"
#include "scene/scene.h"
#include "scene/solid.h"

namespace rotatebook::scene {

Section<Motion> bodySection();

/// Files of meshes, by name.
using MeshFiles = std::map<std::string, MeshFile, std::less<>>;

/// Replaces the names of meshes in [body], also of panels, by the numbers that motions take of the
/// files. Returns the files. Throws DocumentError if one can't be read, or isn't the surface of a
/// body.
MeshFiles includeMeshes(document::TomlNode& root, const ReadNamedFile& readNamedFile);

/// Gives `mesh` the content of its file, if that has its numbers; `file` may be another.
void takeContent(const MeshFile& file, MeshFile& mesh);
void takeContent(const MeshFiles& files, MeshFile& mesh);

}  // namespace rotatebook::scene
