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

constexpr auto kAlpha = std::bit_cast<std::uint32_t>(std::array<std::uint8_t, 4>{0, 0, 0, 0xff});

/// Copies the pixels that were drawn, as opaque, within a band.
void copyDrawn(const image::Image& drawn, const geometry::PixelRect& band, image::Image& picture) {
  // Pixels as integers and no branches: the compiler vectorises the loop.
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

/// Returns whether the surface changes from one of `count` pixels to the next or to the one above.
bool changes(const std::uint8_t* here, const std::uint8_t* above, int count) {
  std::uint32_t changed = 0;
  for (int i = 0; i < count; ++i, here += 4, above += 4) {
    std::array<std::uint32_t, 3> pixels{};
    std::memcpy(pixels.data(), here, 8);
    std::memcpy(&pixels[2], above, 4);
    changed |= (pixels[0] ^ pixels[1]) | (pixels[0] ^ pixels[2]);
  }
  return (changed & kAlpha) != 0;
}

/// Adds the pixels of a band between which the material changes: where one surface goes through
/// another, neither has an edge.
void addMeetings(const image::Image& drawn, const geometry::PixelRect& band,
                 const AlikeSurfaces& alike, EdgePixels& pixels) {
  constexpr int kAtOnce = 16;  // As a rule none of them changes.
  const auto meet = [&alike](std::uint8_t one, std::uint8_t other) {
    return one != 0 && other != 0 && alike[one] != alike[other];
  };
  const int last = band.x + band.width - 1;
  for (int y = band.y; y < band.y + band.height; ++y) {
    const int next = std::min(y + 1, band.y + band.height - 1);  // Beyond are older pictures.
    for (int x = band.x; x < last; x += kAtOnce) {
      const int count = std::min(kAtOnce, last - x);
      const std::uint8_t* here = drawn.row(y) + 4 * static_cast<std::ptrdiff_t>(x);
      const std::uint8_t* above = drawn.row(next) + 4 * static_cast<std::ptrdiff_t>(x);
      if (!changes(here, above, count)) continue;
      for (int i = 0; i < count; ++i, here += 4, above += 4) {
        const bool across = meet(here[3], here[7]), up = meet(here[3], above[3]);
        if (across || up) pixels.add(x + i, y);
        if (across) pixels.add(x + i + 1, y);
        if (up) pixels.add(x + i, y + 1);
      }
    }
  }
}

void copyPixels(const image::Image& from, const geometry::PixelRect& area, image::Image& to) {
  const std::ptrdiff_t left = 4 * static_cast<std::ptrdiff_t>(area.x);
  const std::size_t size = 4 * static_cast<std::size_t>(area.width);
  for (int y = area.y; y < area.y + area.height; ++y)
    std::memcpy(to.row(y) + left, from.row(y) + left, size);
}

void halve(const image::Image& large, const geometry::PixelRect& area, image::Image& picture) {
  image::downsample(large, area.x / 2, area.y / 2, area.width / 2, area.height / 2, picture);
}

/// Returns the smallest area with even borders that holds another.
geometry::PixelRect evenAround(const geometry::PixelRect& area) {
  const int x = area.x & ~1, y = area.y & ~1;
  return {x, y, (area.x + area.width - x + 1) & ~1, (area.y + area.height - y + 1) & ~1};
}

}  // namespace

Compositor::Compositor(const image::Image& background, int supersample, const geometry::Mesh& mesh)
    : background_(background),
      supersample_(supersample),
      edges_(mesh),
      edgePixels_(background_.width(), background_.height()),
      alike_(alikeSurfacesOf(mesh)),
      samples_(alike_) {
  if (supersample_ == 1) return;
  large_ = {background.width(), background.height(), image::PixelFormat::Rgba8};
  halved_ = makePicture();
  halve(background, wholePicture(), halved_);
}

image::Image Compositor::makePicture() const {
  return {background_.width() / supersample_, background_.height() / supersample_,
          image::PixelFormat::Rgba8};
}

void Compositor::compose(const DrawnBody& body, image::Image& picture) {
  const bool hasOwn = body.background.width() > 0;
  const image::Image& background = hasOwn ? body.background : background_;
  if (supersample_ == 1) {
    picture = background;
    return composeOver(background, body, picture);
  }
  // Elsewhere than the body the background is halved once for all pictures
  std::vector<geometry::PixelRect> areas;
  for (const geometry::PixelRect& band : body.bands) areas.push_back(evenAround(band));
  if (hasOwn) areas = {wholePicture()};
  if (!hasOwn) picture = halved_;
  for (const geometry::PixelRect& area : areas) copyPixels(background, area, large_);
  composeOver(background, body, large_);
  for (const geometry::PixelRect& area : areas) halve(large_, area, picture);
}

void Compositor::composeOver(const image::Image& background, const DrawnBody& body,
                             image::Image& picture) {
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
