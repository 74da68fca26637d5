#include "render/compositor.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <utility>

#include "image/alpha_mask.h"
#include "image/downsample.h"

namespace rotatebook::render {
namespace {

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
      const std::uint32_t pixel =
          (over & image::kAlphaMask) != 0 ? over | image::kAlphaMask : under;
      std::memcpy(to, &pixel, 4);
    }
  }
}

/// Returns whether the surface changes from one of `count` pixels to the next or to the one below.
bool changes(const std::uint8_t* here, const std::uint8_t* below, int count) {
  std::uint32_t changed = 0;
  for (int i = 0; i < count; ++i, here += 4, below += 4) {
    std::array<std::uint32_t, 3> pixels{};
    std::memcpy(pixels.data(), here, 8);
    std::memcpy(&pixels[2], below, 4);
    changed |= (pixels[0] ^ pixels[1]) | (pixels[0] ^ pixels[2]);
  }
  return (changed & image::kAlphaMask) != 0;
}

/// A part of a row of pixels, and the row that it is compared with.
struct RowPart {
  int y, next, left, right;
};

/// Adds the pixels of a part between which the material changes, along it and to the next row:
/// where one surface goes through another, neither has an edge.
void addMeetings(const image::Image& drawn, const RowPart& part, const AlikeSurfaces& alike,
                 EdgePixels& pixels) {
  constexpr int kAtOnce = 16;  // As a rule none of them changes.
  const auto meet = [&alike](std::uint8_t one, std::uint8_t other) {
    return one != 0 && other != 0 && alike[one] != alike[other];
  };
  const int last = part.right - 1;
  for (int x = part.left; x < last; x += kAtOnce) {
    const int count = std::min(kAtOnce, last - x);
    const std::uint8_t* here = drawn.row(part.y) + 4 * static_cast<std::ptrdiff_t>(x);
    const std::uint8_t* below = drawn.row(part.next) + 4 * static_cast<std::ptrdiff_t>(x);
    if (!changes(here, below, count)) continue;
    for (int i = 0; i < count; ++i, here += 4, below += 4) {
      const bool across = meet(here[3], here[7]), down = meet(here[3], below[3]);
      if (across || down) pixels.add(x + i, part.y);
      if (across) pixels.add(x + i + 1, part.y);
      if (down) pixels.add(x + i, part.next);
    }
  }
}

/// Adds all such pixels of a body. Below a band only the next one's pixels are this picture's.
void addMeetings(const DrawnBody& body, const AlikeSurfaces& alike, EdgePixels& pixels) {
  const auto& bands = body.bands;
  for (std::size_t i = 0; i < bands.size(); ++i) {
    const auto& [x, y, width, height] = bands[i];
    const int last = y + height - 1;
    for (int row = y; row < last; ++row)
      addMeetings(body.pixels, {row, row + 1, x, x + width}, alike, pixels);
    addMeetings(body.pixels, {last, last, x, x + width}, alike, pixels);
    if (i + 1 == bands.size() || bands[i + 1].y != last + 1) continue;
    const geometry::PixelRect& next = bands[i + 1];
    const int left = std::max(x, next.x), right = std::min(x + width, next.x + next.width);
    addMeetings(body.pixels, {last, last + 1, left, right}, alike, pixels);
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
  addMeetings(body, alike_, edgePixels_);
  edgePixels_.number();
  samples_.resolve(edgePixels_, triangles_, body.pixels, body.strips, background, picture);
}

}  // namespace rotatebook::render
