// The small picture that stands for a clip or a still.
#pragma once

#include "image/image.h"
#include "render/device/device.h"
#include "scene/scene.h"

namespace rotatebook::picture {

/// The scene as its thumbnail shows it: textless, and no larger than 480 pixels wide, unless that
/// would make it lower than 96, or as large as its clip is.
scene::Scene thumbnailScene(const scene::Scene& scene);

/// Draws the poster of `scene`, see posterFrame(), so. Throws as FrameDrawer does.
image::Image drawThumbnail(const scene::Scene& scene, const render::DeviceChoice& device = {});

}  // namespace rotatebook::picture
