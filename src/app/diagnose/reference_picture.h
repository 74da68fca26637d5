// One small picture that every renderer must draw alike. Inside the room only.
#pragma once

#include "image/comparison.h"
#include "image/image.h"
#include "physics/cuboid.h"
#include "render/device/device.h"
#include "render/renderer.h"

namespace rotatebook::diagnose {

/// For llvmpipe, by which the stored picture was drawn: measured 0 and 0 %.
inline constexpr image::Tolerance kSoftwareTolerance{.largest = 3, .failPercent = 0.5};
/// For hardware, which rounds and filters otherwise; not measured on any yet. Mesa's softpipe,
/// another rasteriser: measured 4 at most. A book turned by one degree: at least 3.7 %.
inline constexpr image::Tolerance kHardwareTolerance{.largest = 8, .failPercent = 1};

/// 96x54 pixels.
render::RenderSettings referencePictureSettings();
/// A view that shows the front cover, the spine and the pages. [m]
physics::Cage referencePictureBook();

/// Draws them with the covers that ship. Throws as Renderer does.
image::Image drawReferencePicture(const render::BookTextures& textures,
                           const render::DeviceChoice& choice = {});

/// The same as it was stored.
image::Image storedReferencePicture();

}  // namespace rotatebook::diagnose
