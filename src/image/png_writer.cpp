#include <cstddef>
#include <cstdint>
#include <exception>
#include <new>
#include <string>
#include <string_view>
#include <vector>

#include "base/atomic_file.h"
#include "base/error.h"
#include "image/png_file.h"
#include "image/png_guard.h"
#include "image/png_pixels.h"

namespace rotatebook::image {
namespace {

// libpng's write structure and what its callbacks reach through it.
class PngEncoder {
 public:
  PngEncoder()
      : png_(
            png_create_write_struct(PNG_LIBPNG_VER_STRING, &words_, jumpWithWords, ignoreWarning)) {
    if (png_ != nullptr) info_ = png_create_info_struct(png_);
    if (info_ == nullptr) png_destroy_write_struct(&png_, nullptr);
    if (png_ == nullptr) throw std::bad_alloc();
    png_set_write_fn(png_, &bytes_, append, nullptr);
  }
  PngEncoder(const PngEncoder&) = delete;
  PngEncoder& operator=(const PngEncoder&) = delete;
  ~PngEncoder() { png_destroy_write_struct(&png_, &info_); }

  bool encode(ImageView view, bool alpha, const std::vector<std::uint8_t>& pixels) {
    return guarded(png_, [this, &view, alpha, &pixels] {
      describe(view, alpha);
      writeChunk("IDAT", pixels.data(), pixels.size());
      writeChunk("IEND", nullptr, 0);
    });
  }

  std::string_view bytes() const { return bytes_; }
  const char* words() const { return words_.text; }

 private:
  static void append(png_structp png, png_bytep data, std::size_t size) {
    if (!grow(*static_cast<std::string*>(png_get_io_ptr(png)), data, size)) {
      png_error(png, "out of memory");
    }
  }

  // An exception can't cross libpng's C frames.
  static bool grow(std::string& bytes, png_const_bytep data, std::size_t size) noexcept {
    try {
      bytes.append(reinterpret_cast<const char*>(data), size);
      return true;
    } catch (const std::exception&) {
      return false;
    }
  }

  void describe(const ImageView& view, bool alpha) {
    png_set_IHDR(png_, info_, static_cast<png_uint_32>(view.width),
                 static_cast<png_uint_32>(view.height), 8,
                 alpha ? PNG_COLOR_TYPE_RGB_ALPHA : PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE,
                 PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    png_set_sRGB(png_, info_, PNG_sRGB_INTENT_PERCEPTUAL);
    png_write_info(png_, info_);
  }

  void writeChunk(const char* name, const std::uint8_t* data, std::size_t size) {
    png_write_chunk(png_, reinterpret_cast<png_const_bytep>(name), data, size);
  }

  PngWords words_;
  std::string bytes_;
  png_structp png_;
  png_infop info_ = nullptr;
};

}  // namespace

void writePng(const std::filesystem::path& path, ImageView view, PngOptions options) {
  PngEncoder encoder;
  const bool alpha = options.transparent && view.format == PixelFormat::Rgba8;
  if (!encoder.encode(view, alpha, compressedPixels(view, options.level, alpha))) {
    throw MachineError("can't write " + path.string() + ": libpng: " + encoder.words());
  }
  writeFileAtomically(path, encoder.bytes());
}

}  // namespace rotatebook::image
