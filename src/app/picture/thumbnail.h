// Draws the thumbnail of a clip or a still.
#pragma once

#include "image/image.h"
#include "render/device/device.h"
#include "scene/scene.h"

namespace rotatebook::picture {

/// Returns the scene of the thumbnail: without text, and at most 480 pixels wide; wider, up to the
/// clip's size, if it would be less than 96 pixels high.
scene::Scene thumbnailScene(const scene::Scene& scene);

/// Draws the poster of thumbnailScene(), see posterFrame(). Throws like FrameDrawer.
image::Image drawThumbnail(const scene::Scene& scene, const render::DeviceChoice& device = {});

}  // namespace rotatebook::picture
