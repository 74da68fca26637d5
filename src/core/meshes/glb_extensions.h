// The extensions of glTF that a .glb file needs. Inside the room only.
#pragma once

#include <string>

#include "meshes/glb_document.h"

namespace rotatebook::meshes {

/// Throws InputError, with the remedy, if a document needs an extension that its nodes, meshes or
/// their numbers use and that isn't known. Others don't touch a shape.
void requireKnownExtensions(const GlbDocument& document);

/// Throws InputError, with the remedy, if a primitive, accessor or view that is read has an
/// extension that compresses it and that the document needs. `what` is for the message.
void requireUncompressed(const GlbDocument& document, const GlbDocument::Json& json,
                         const std::string& what);

/// Returns a node's, primitive's or texture's extension of that name; null if it has none.
const GlbDocument::Json& extensionOf(const GlbDocument::Json& json, const char* name);

}  // namespace rotatebook::meshes
