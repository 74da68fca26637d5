// Bodies with their looks in USD. Inside the room only.
#pragma once

#include <cstddef>
#include <string>

#include "picture/interchange/exported_body.h"
#include "picture/interchange/usd_layer.h"

namespace rotatebook::interchange {

/// Adds a body as one mesh, whose materials, as UsdPreviewSurface, are in the scope "materials"
/// beside it, in the prim at the path `parent`.
void addBody(const ExportedBody& body, const std::string& parent, UsdLayer& layer);

/// Returns the name of a picture's file.
std::string pictureName(const ExportedBody& body, std::size_t picture);

}  // namespace rotatebook::interchange
