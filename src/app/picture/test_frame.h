// A small frame whose checksum tells renderers apart. Inside the room only.
#pragma once

#include <string>

#include "render/renderer.h"

namespace rotatebook::picture {

/// Returns the checksum of a test frame: of what `renderer` draws, see
/// render::Renderer::testFrame(), and, if `text`, of text that this machine's libraries draw.
/// Frames of one scene are equal where it, and the renderer's description, are. Throws Error.
std::string testFrame(const render::Renderer& renderer, bool text);

}  // namespace rotatebook::picture
