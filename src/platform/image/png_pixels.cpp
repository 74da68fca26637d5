#include "image/png_pixels.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <isa-l.h>
#include <utility>
#include <zlib.h>

#include "image/row_filter.h"

namespace rotatebook::image {
namespace {

// With fewer rows, more bands equal the last picture's. Measured with igzip alone at 1280x720: 16
// rows take a tenth longer than 48.
constexpr int kBandRows = 16;

// Deflate with a window of 32 kB, the fastest of four levels, no dictionary (RFC 1950).
constexpr std::array<char, 2> kZlibHead = {0x78, 0x01};
// A last block, empty, with deflate's fixed codes.
constexpr std::array<char, 2> kLastBlock = {0x03, 0x00};
constexpr std::uint32_t kEmptyChecksum = 1;

void append(std::string& stream, const std::vector<std::uint8_t>& bytes) {
  stream.append(reinterpret_cast<const char*>(bytes.data()), bytes.size());
}

bool sameShape(const ImageView& a, const ImageView& b) {
  return a.width == b.width && a.height == b.height && a.format == b.format;
}

}  // namespace

void appendBigEndian(std::string& bytes, std::uint32_t value) {
  for (int shift = 24; shift >= 0; shift -= 8) bytes.push_back(static_cast<char>(value >> shift));
}

void PixelPacker::append(const ImageView& view, bool alpha, std::string& stream) {
  packBands(view, alpha);
  appendBands(stream);
}

void PixelPacker::packBands(const ImageView& view, bool alpha) {
  prepareFor(view, alpha);
  const bool known = std::exchange(lastIsWhole_, false);
  Band* band = bands_.data();
  for (int top = 0; top < view.height; top += kBandRows, ++band) {
    const int bottom = std::min(top + kBandRows, view.height);
    bool changed = !known;
    for (int y = top; y < bottom; ++y) changed = keepRow(view, y) || changed;
    if (!changed) continue;
    band->size = filterRows(view, alpha, top, bottom);
    band->checksum = isal_adler32(kEmptyChecksum, filtered_.data(), band->size);
    coder_.pack({filtered_.data(), band->size}, band->packed);
  }
  lastIsWhole_ = true;
}

void PixelPacker::prepareFor(const ImageView& view, bool alpha) {
  if (sameShape(view, last_.view()) && alpha == lastHadAlpha_) return;
  lastIsWhole_ = false;
  last_ = Image(view.width, view.height, view.format);
  lastHadAlpha_ = alpha;
  bands_.resize(static_cast<std::size_t>((view.height + kBandRows - 1) / kBandRows));
}

/// Stores row `y` in last_; returns whether it differs from the last picture's.
bool PixelPacker::keepRow(const ImageView& view, int y) {
  const auto size = static_cast<std::size_t>(last_.stride());
  if (std::memcmp(last_.row(y), view.row(y), size) == 0) return false;
  std::memcpy(last_.row(y), view.row(y), size);
  return true;
}

std::size_t PixelPacker::filterRows(const ImageView& view, bool alpha, int top, int bottom) {
  const std::size_t size = filteredRowSize(view, alpha) * static_cast<std::size_t>(bottom - top);
  filtered_.resize(std::max(filtered_.size(), size + kFilterOverrun));
  std::uint8_t* out = filtered_.data();
  for (int y = top; y < bottom; ++y) out = filterRow(view, y, alpha, out);
  return size;
}

void PixelPacker::appendBands(std::string& stream) const {
  stream.append(kZlibHead.data(), kZlibHead.size());
  std::uint32_t checksum = kEmptyChecksum;
  for (const Band& band : bands_) {
    image::append(stream, band.packed);
    checksum = static_cast<std::uint32_t>(
        adler32_combine(checksum, band.checksum, static_cast<z_off_t>(band.size)));
  }
  stream.append(kLastBlock.data(), kLastBlock.size());
  appendBigEndian(stream, checksum);
}

}  // namespace rotatebook::image
