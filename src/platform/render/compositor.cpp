#include "render/compositor.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <utility>

#include "image/alpha_mask.h"
#include "image/downsample.h"
#include "image/wide_vectors.h"

namespace rotatebook::render {
namespace {

/// Copies those of `count` pixels that were drawn, as opaque. Pixels as integers and no branches:
/// the compiler vectorises the loop.
[[gnu::always_inline]] inline void copyDrawn(const std::uint8_t* from, int count,
                                             std::uint8_t* to) {
  for (int x = 0; x < count; ++x, from += 4, to += 4) {
    std::uint32_t over = 0, under = 0;
    std::memcpy(&over, from, 4);
    std::memcpy(&under, to, 4);
    const std::uint32_t pixel = (over & image::kAlphaMask) != 0 ? over | image::kAlphaMask : under;
    std::memcpy(to, &pixel, 4);
  }
}

constexpr int kAtOnce = 16;  // Pixels that are compared; as a rule none of them changes.

/// Returns whether the surface changes from one of kAtOnce pixels to the next or to the one below.
[[gnu::always_inline]] inline bool changes(const std::uint8_t* here, const std::uint8_t* below) {
  std::array<std::uint32_t, kAtOnce> one{}, next{}, lower{};
  std::memcpy(one.data(), here, sizeof one);
  std::memcpy(next.data(), here + 4, sizeof next);
  std::memcpy(lower.data(), below, sizeof lower);
  std::uint32_t changed = 0;
  for (std::size_t i = 0; i < one.size(); ++i) changed |= (one[i] ^ next[i]) | (one[i] ^ lower[i]);
  return (changed & image::kAlphaMask) != 0;
}

/// Returns the first of `count` blocks of kAtOnce pixels in which the surface changes, or `count`.
[[gnu::always_inline]] inline int firstChange(const std::uint8_t* here, const std::uint8_t* below,
                                              int count) {
  int block = 0;
  constexpr int kSize = 4 * kAtOnce;
  while (block < count && !changes(here, below)) ++block, here += kSize, below += kSize;
  return block;
}

void copyDrawnByBase(const std::uint8_t* from, int count, std::uint8_t* to) {
  copyDrawn(from, count, to);
}
ROTATEBOOK_AVX2 void copyDrawnByAvx2(const std::uint8_t* from, int count, std::uint8_t* to) {
  copyDrawn(from, count, to);
}
const auto copyRowDrawn = image::usesAvx2() ? &copyDrawnByAvx2 : &copyDrawnByBase;

int firstChangeByBase(const std::uint8_t* here, const std::uint8_t* below, int count) {
  return firstChange(here, below, count);
}
ROTATEBOOK_AVX2 int firstChangeByAvx2(const std::uint8_t* here, const std::uint8_t* below,
                                      int count) {
  return firstChange(here, below, count);
}
const auto firstChangeInRow = image::usesAvx2() ? &firstChangeByAvx2 : &firstChangeByBase;

/// A part of a row of pixels, and the row that it is compared with.
struct RowPart {
  int y, next, left, right;
};

/// Adds the pixels of a part between which the material changes, along it and to the next row:
/// where one surface goes through another, neither has an edge.
void addMeetings(const image::Image& drawn, const RowPart& part, const AlikeSurfaces& alike,
                 EdgePixels& pixels) {
  const auto meet = [&alike](std::uint8_t one, std::uint8_t other) {
    return one != 0 && other != 0 && alike[one] != alike[other];
  };
  const auto at = [&](int y, int x) { return drawn.row(y) + 4 * static_cast<std::ptrdiff_t>(x); };
  const int last = part.right - 1;
  for (int x = part.left; x < last; x += kAtOnce) {
    const int blocks = (last - x) / kAtOnce;
    x += kAtOnce * firstChangeInRow(at(part.y, x), at(part.next, x), blocks);
    const int count = std::min(kAtOnce, last - x);
    const std::uint8_t *here = at(part.y, x), *below = at(part.next, x);
    for (int i = 0; i < count; ++i, here += 4, below += 4) {
      const bool across = meet(here[3], here[7]), down = meet(here[3], below[3]);
      if (across || down) pixels.add(x + i, part.y);
      if (across) pixels.add(x + i + 1, part.y);
      if (down) pixels.add(x + i, part.next);
    }
  }
}

/// Adds all such pixels of a row of a band. Below a band only the next one's pixels are this
/// picture's.
void addMeetings(const DrawnBody& body, std::size_t band, int row, const AlikeSurfaces& alike,
                 EdgePixels& pixels) {
  const auto& [x, y, width, height] = body.bands[band];
  const bool isLast = row == y + height - 1;
  addMeetings(body.pixels, {row, isLast ? row : row + 1, x, x + width}, alike, pixels);
  if (!isLast || band + 1 == body.bands.size() || body.bands[band + 1].y != row + 1) return;
  const geometry::PixelRect& next = body.bands[band + 1];
  const int left = std::max(x, next.x), right = std::min(x + width, next.x + next.width);
  addMeetings(body.pixels, {row, row + 1, left, right}, alike, pixels);
}

void copyPixels(const image::Image& from, const image::Area& area, const image::Pixels& to) {
  const std::ptrdiff_t left = 4 * static_cast<std::ptrdiff_t>(area.x);
  const std::size_t size = 4 * static_cast<std::size_t>(area.width);
  for (int y = area.y; y < area.bottom(); ++y)
    std::memcpy(to.row(y) + left, from.row(y) + left, size);
}

/// Returns the area of a picture that a band takes, or of one half as wide and high.
image::Area areaOf(const geometry::PixelRect& band, bool isTwice) {
  const auto& [x, y, width, height] = band;
  if (!isTwice) return {x, y, width, height};
  return {x / 2, y / 2, (x + width + 1) / 2 - x / 2, (y + height + 1) / 2 - y / 2};
}

}  // namespace

Compositor::Compositor(const image::Image& background, bool isTwice, const geometry::Mesh& mesh)
    : background_(background),
      edges_(mesh),
      edgePixels_(background_.width(), background_.height()),
      alike_(alikeSurfacesOf(mesh)),
      samples_(alike_) {
  if (isTwice) large_.emplace(background.width(), background.height(), image::PixelFormat::Rgba8);
}

void Compositor::compose(const DrawnBody& body, int x, int y, image::Image& picture) {
  const bool hasOwn = body.background.width() > 0;
  const image::Image& background = hasOwn ? body.background : background_;
  std::vector<image::Area> areas;
  if (hasOwn) {
    areas = {areaOf({0, 0, background.width(), background.height()}, large_.has_value())};
  } else {
    for (const geometry::PixelRect& band : body.bands)
      areas.push_back(areaOf(band, large_.has_value()));
  }
  for (const image::Area& area : areas)
    picture.touch({x + area.x, y + area.y, area.width, area.height});
  const image::Pixels pixels = picture.from(x, y);
  if (large_) return composeLarge(background, areas, body, pixels);
  if (hasOwn) copyPixels(background, areas.front(), pixels);
  composeOver(background, body, pixels);
}

void Compositor::composeLarge(const image::Image& background, const std::vector<image::Area>& areas,
                              const DrawnBody& body, const image::Pixels& picture) {
  const image::Pixels large = large_->from(0, 0);
  for (const auto& [x, y, width, height] : areas)
    copyPixels(background, {2 * x, 2 * y, 2 * width, 2 * height}, large);
  composeOver(background, body, large);
  for (const image::Area& area : areas) image::downsample(*large_, area, picture);
}

void Compositor::composeOver(const image::Image& background, const DrawnBody& body,
                             const image::Pixels& picture) {
  if (body.bands.empty()) return;
  edgePixels_.clear();
  triangles_.clear();
  edges_.find(body.cage, body.clipFromWorld, body.winding, body.strips.onScreen, edgePixels_,
              triangles_);
  copyDrawn(body, picture);
  edgePixels_.number();
  samples_.resolve(edgePixels_, triangles_, body.pixels, body.strips, background, picture);
}

void Compositor::copyDrawn(const DrawnBody& body, const image::Pixels& picture) {
  for (std::size_t band = 0; band < body.bands.size(); ++band) {
    const auto& [x, top, width, height] = body.bands[band];
    const std::ptrdiff_t left = 4 * static_cast<std::ptrdiff_t>(x);
    for (int y = top; y < top + height; ++y) {
      copyRowDrawn(body.pixels.row(y) + left, width, picture.row(y) + left);
      addMeetings(body, band, y, alike_, edgePixels_);
    }
  }
}

}  // namespace rotatebook::render
