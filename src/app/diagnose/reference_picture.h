// A small picture of the book that every renderer must draw alike. Inside the room only.
#pragma once

#include "body/cuboid.h"
#include "image/comparison.h"
#include "image/image.h"
#include "render/device/device.h"
#include "render/renderer.h"

namespace rotatebook::diagnose {

/// The tolerance for software: llvmpipe, which drew the stored picture, measured 0 and 0 %.
inline constexpr image::Tolerance kSoftwareTolerance{.largest = 3, .failPercent = 0.5};
/// The tolerance for hardware, which rounds and filters differently; not measured on hardware yet.
/// Mesa's softpipe, another rasteriser: measured 4 at most. A book turned by one degree: at least
/// 3.7 %.
inline constexpr image::Tolerance kHardwareTolerance{.largest = 8, .failPercent = 1};

/// Returns the picture's settings: 96x54 pixels.
render::RenderSettings referencePictureSettings();
/// Returns the book's corners [m], in an attitude that shows front cover, spine and pages.
body::Cage referencePictureBook();

/// Draws the picture with `textures`. Throws as Renderer does.
image::Image drawReferencePicture(const render::BookTextures& textures,
                                  const render::DeviceChoice& choice = {});

/// Returns the stored picture.
image::Image storedReferencePicture();

}  // namespace rotatebook::diagnose
