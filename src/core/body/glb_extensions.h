// The extensions of glTF that a .glb file needs. Inside the room only.
#pragma once

#include "body/glb_document.h"

namespace rotatebook::body {

/// Throws InputError, with the remedy, if a document needs an extension that compresses meshes, or
/// one that its nodes, meshes or their numbers use and that isn't known. Others don't touch a
/// shape.
void requireKnownExtensions(const GlbDocument& document);

/// Returns a node's, primitive's or texture's extension of that name; null if it has none.
const GlbDocument::Json& extensionOf(const GlbDocument::Json& json, const char* name);

}  // namespace rotatebook::body
