#include "render/compositor.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <utility>

#include "image/downsample.h"

namespace rotatebook::render {
namespace {

/// Copies the pixels that were drawn, as opaque, within a band.
void copyDrawn(const image::Image& drawn, const geometry::PixelRect& band, image::Image& picture) {
  // Pixels as integers and no branches: the compiler vectorises the loop.
  constexpr auto kAlpha = std::bit_cast<std::uint32_t>(std::array<std::uint8_t, 4>{0, 0, 0, 0xff});
  for (int y = band.y; y < band.y + band.height; ++y) {
    const std::uint8_t* from = drawn.row(y) + 4 * static_cast<std::ptrdiff_t>(band.x);
    std::uint8_t* to = picture.row(y) + 4 * static_cast<std::ptrdiff_t>(band.x);
    for (int x = 0; x < band.width; ++x, from += 4, to += 4) {
      std::uint32_t over = 0, under = 0;
      std::memcpy(&over, from, 4);
      std::memcpy(&under, to, 4);
      const std::uint32_t pixel = (over & kAlpha) != 0 ? over | kAlpha : under;
      std::memcpy(to, &pixel, 4);
    }
  }
}

/// Adds the pixels of a band between which the material changes: where one surface goes through
/// another, neither has an edge.
void addMeetings(const image::Image& drawn, const geometry::PixelRect& band,
                 const AlikeSurfaces& alike, EdgePixels& pixels) {
  const auto meet = [&alike](std::uint8_t one, std::uint8_t other) {
    return one != 0 && other != 0 && alike[one] != alike[other];
  };
  for (int y = band.y; y < band.y + band.height; ++y) {
    const int next = std::min(y + 1, band.y + band.height - 1);  // Beyond are older pictures.
    const std::uint8_t* here = drawn.row(y) + 4 * static_cast<std::ptrdiff_t>(band.x) + 3;
    const std::uint8_t* above = drawn.row(next) + 4 * static_cast<std::ptrdiff_t>(band.x) + 3;
    for (int x = band.x; x + 1 < band.x + band.width; ++x, here += 4, above += 4) {
      if (here[0] == here[4] && here[0] == above[0]) continue;
      const bool across = meet(here[0], here[4]), up = meet(here[0], above[0]);
      if (across || up) pixels.add(x, y);
      if (across) pixels.add(x + 1, y);
      if (up) pixels.add(x, y + 1);
    }
  }
}

}  // namespace

Compositor::Compositor(image::Image background, int supersample, const geometry::Mesh& mesh)
    : background_(std::move(background)),
      supersample_(supersample),
      edges_(mesh),
      edgePixels_(background_.width(), background_.height()),
      alike_(alikeSurfacesOf(mesh)),
      samples_(alike_) {
  if (supersample_ > 1) large_ = background_;
}

image::Image Compositor::makePicture() const {
  return {background_.width() / supersample_, background_.height() / supersample_,
          image::PixelFormat::Rgba8};
}

void Compositor::compose(const DrawnBody& body, image::Image& picture) {
  if (supersample_ == 1) return composeLarge(body, picture);
  composeLarge(body, large_);
  image::downsample(large_, picture);
}

void Compositor::composeLarge(const DrawnBody& body, image::Image& picture) {
  const image::Image& background = body.background.width() > 0 ? body.background : background_;
  picture = background;
  if (body.bands.empty()) return;
  for (const geometry::PixelRect& band : body.bands) copyDrawn(body.pixels, band, picture);
  edgePixels_.clear();
  triangles_.clear();
  edges_.find(body.cage, body.clipFromWorld, body.winding, body.strips.onScreen, edgePixels_,
              triangles_);
  for (const geometry::PixelRect& band : body.bands)
    addMeetings(body.pixels, band, alike_, edgePixels_);
  edgePixels_.number();
  samples_.resolve(edgePixels_, triangles_, body.pixels, body.strips, background, picture);
}

}  // namespace rotatebook::render
