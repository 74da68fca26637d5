#include "image/png_pixels.h"

#include <cstddef>
#include <memory>
#include <new>

#include <libdeflate.h>

namespace rotatebook::image {
namespace {

constexpr std::uint8_t kFilterUp = 2;  // PNG specification, section 9.2.

struct FreeCompressor {
  void operator()(libdeflate_compressor* compressor) const {
    libdeflate_free_compressor(compressor);
  }
};

/// The first kKept of each pixel's kBytes, minus the row `above` (nothing above the first); returns
/// where the next row goes.
template <int kBytes, int kKept>
std::uint8_t* filterRow(const std::uint8_t* row, const std::uint8_t* above, int width,
                        std::uint8_t* out) {
  *out++ = kFilterUp;
  for (int x = 0; x < width; ++x, row += kBytes) {
    for (int channel = 0; channel < kKept; ++channel) {
      const int difference = row[channel] - (above != nullptr ? above[channel] : 0);
      *out++ = static_cast<std::uint8_t>(difference);
    }
    if (above != nullptr) above += kBytes;
  }
  return out;
}

std::vector<std::uint8_t> filteredRows(ImageView view, bool alpha) {
  const auto rowBytes = static_cast<std::size_t>(view.width) * (alpha ? 4 : 3) + 1;
  std::vector<std::uint8_t> bytes(rowBytes * static_cast<std::size_t>(view.height));
  const auto opaque = view.format == PixelFormat::Rgb8 ? filterRow<3, 3> : filterRow<4, 3>;
  const auto filter = alpha ? filterRow<4, 4> : opaque;
  std::uint8_t* out = bytes.data();
  for (int y = 0; y < view.height; ++y) {
    out = filter(view.row(y), y == 0 ? nullptr : view.row(y - 1), view.width, out);
  }
  return bytes;
}

}  // namespace

std::vector<std::uint8_t> compressedPixels(ImageView view, int level, bool alpha) {
  const std::unique_ptr<libdeflate_compressor, FreeCompressor> compressor(
      libdeflate_alloc_compressor(level));
  if (!compressor) throw std::bad_alloc();
  const std::vector<std::uint8_t> rows =
      filteredRows(view, alpha && view.format == PixelFormat::Rgba8);
  std::vector<std::uint8_t> packed(libdeflate_zlib_compress_bound(compressor.get(), rows.size()));
  const std::size_t size = libdeflate_zlib_compress(compressor.get(), rows.data(), rows.size(),
                                                    packed.data(), packed.size());
  packed.resize(size);
  return packed;
}

}  // namespace rotatebook::image
