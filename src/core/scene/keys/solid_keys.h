// The keys of [body] for what isn't the book. Inside the room only.
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "body/closed_mesh.h"
#include "document/toml_tree.h"
#include "scene/keys/key.h"
#include "scene/solid.h"

namespace rotatebook::scene {

/// The surface of a mesh's file, in the table that includeMeshes() makes of its name.
struct AttachedMesh : document::Attachment {
  explicit AttachedMesh(body::ClosedMesh made)
      : mesh(std::make_shared<const body::ClosedMesh>(std::move(made))) {}

  std::shared_ptr<const body::ClosedMesh> mesh;
};

/// The keys, but for the mass, which the book has, too. `shape` and `dimensions` are read together,
/// by readStatedShape().
const Keys<Solid>& solidKeys();
/// The documentation of the keys of a part.
const std::vector<KeyRow>& partRows();

/// Reads the shape that `section`, [body], names, if it isn't the book, with its lengths and
/// density. Throws InputError.
void readStatedShape(const ValueReader& section, Solid& solid);

}  // namespace rotatebook::scene
