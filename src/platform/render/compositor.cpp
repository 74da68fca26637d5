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

/// Both for one kind of processor.
struct RowCode {
  void (*copyDrawn)(const std::uint8_t* from, int count, std::uint8_t* to);
  int (*firstChange)(const std::uint8_t* here, const std::uint8_t* below, int count);
};

void copyDrawnByBase(const std::uint8_t* from, int count, std::uint8_t* to) {
  copyDrawn(from, count, to);
}
int firstChangeByBase(const std::uint8_t* here, const std::uint8_t* below, int count) {
  return firstChange(here, below, count);
}
constexpr RowCode kBase{&copyDrawnByBase, &firstChangeByBase};

#ifdef __x86_64__
[[gnu::target("avx2")]] void copyDrawnByAvx2(const std::uint8_t* from, int count,
                                             std::uint8_t* to) {
  copyDrawn(from, count, to);
}
[[gnu::target("avx2")]] int firstChangeByAvx2(const std::uint8_t* here, const std::uint8_t* below,
                                              int count) {
  return firstChange(here, below, count);
}

const RowCode rowCode = image::usesAvx2() ? RowCode{&copyDrawnByAvx2, &firstChangeByAvx2} : kBase;
#else
constexpr RowCode rowCode = kBase;
#endif

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
    x += kAtOnce * rowCode.firstChange(at(part.y, x), at(part.next, x), blocks);
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
  // It may be of another shape: a picture that was read
  const auto pixels = static_cast<std::size_t>(supersample_ * supersample_);
  if (pixels * picture.bytes().size() != background.bytes().size()) picture = makePicture();
  if (supersample_ == 1) return composeOver(background, body, true, picture);
  // Elsewhere than the body the background is halved once for all pictures
  std::vector<geometry::PixelRect> areas;
  for (const geometry::PixelRect& band : body.bands) areas.push_back(evenAround(band));
  if (hasOwn) areas = {wholePicture()};
  if (!hasOwn) picture = halved_;
  for (const geometry::PixelRect& area : areas) copyPixels(background, area, large_);
  composeOver(background, body, false, large_);
  for (const geometry::PixelRect& area : areas) halve(large_, area, picture);
}

void Compositor::composeOver(const image::Image& background, const DrawnBody& body, bool copies,
                             image::Image& picture) {
  edgePixels_.clear();
  triangles_.clear();
  if (!body.bands.empty()) {
    edges_.find(body.cage, body.clipFromWorld, body.winding, body.strips.onScreen, edgePixels_,
                triangles_);
  }
  copyRows(copies ? &background : nullptr, body, picture);
  if (body.bands.empty()) return;
  edgePixels_.number();
  samples_.resolve(edgePixels_, triangles_, body.pixels, body.strips, background, picture);
}

/// Copies each row at once, while the processor's cache holds it.
void Compositor::copyRows(const image::Image* background, const DrawnBody& body,
                          image::Image& picture) {
  const auto size = static_cast<std::size_t>(picture.stride());
  std::size_t band = 0;
  for (int y = 0; y < picture.height(); ++y) {
    if (background != nullptr) std::memcpy(picture.row(y), background->row(y), size);
    while (band < body.bands.size() && body.bands[band].y + body.bands[band].height <= y) ++band;
    if (band == body.bands.size() || body.bands[band].y > y) continue;
    const auto left = 4 * static_cast<std::ptrdiff_t>(body.bands[band].x);
    rowCode.copyDrawn(body.pixels.row(y) + left, body.bands[band].width, picture.row(y) + left);
    addMeetings(body, band, y, alike_, edgePixels_);
  }
}

}  // namespace rotatebook::render
