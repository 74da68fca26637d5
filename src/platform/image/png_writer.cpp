#include <cstddef>
#include <cstdint>
#include <exception>
#include <isa-l.h>
#include <new>
#include <string>

#include <fmt/core.h>

#include "base/error.h"
#include "image/png_file.h"
#include "image/png_guard.h"
#include "image/png_pixels.h"
#include "system/atomic_file.h"
#include "system/program_mark.h"

namespace rotatebook::image {
namespace {

// libpng's write structure and the state of its callbacks.
class PngEncoder {
 public:
  // Appends to `bytes`.
  explicit PngEncoder(std::string& bytes)
      : png_(png_create_write_struct(PNG_LIBPNG_VER_STRING, &message_, jumpWithMessage,
                                     ignoreWarning)) {
    if (png_ != nullptr) info_ = png_create_info_struct(png_);
    if (info_ == nullptr) png_destroy_write_struct(&png_, nullptr);
    if (png_ == nullptr) throw std::bad_alloc();
    png_set_write_fn(png_, &bytes, append, nullptr);
  }
  PngEncoder(const PngEncoder&) = delete;
  PngEncoder& operator=(const PngEncoder&) = delete;
  ~PngEncoder() { png_destroy_write_struct(&png_, &info_); }

  // The IDAT chunk goes between begin() and end().
  bool begin(const ImageView& view, bool alpha) {
    return guarded(png_, [this, &view, alpha] { describe(view, alpha); });
  }
  bool end() {
    return guarded(png_, [this] {
      png_write_chunk(png_, reinterpret_cast<png_const_bytep>("IEND"), nullptr, 0);
    });
  }

  const char* message() const { return message_.text; }

 private:
  static void append(png_structp png, png_bytep data, std::size_t size) {
    if (!grow(*static_cast<std::string*>(png_get_io_ptr(png)), data, size)) {
      png_error(png, "out of memory");
    }
  }

  // An exception must not cross libpng's C frames.
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

  PngMessage message_;
  png_structp png_;
  png_infop info_ = nullptr;
};

// Not with libpng's chunk, which would copy the pixels and take 0.3 ms a frame for its checksum.
void appendPixels(PixelPacker& packer, const ImageView& view, bool alpha, std::string& bytes) {
  const std::size_t start = bytes.size();
  bytes.append(4, '\0');
  bytes += "IDAT";
  packer.append(view, alpha, bytes);
  const std::size_t checkedSize = bytes.size() - start - 4;
  const auto* chunk = reinterpret_cast<const std::uint8_t*>(&bytes[start + 4]);
  const std::uint32_t checksum = crc32_gzip_refl(0, chunk, checkedSize);
  std::string size;
  appendBigEndian(size, static_cast<std::uint32_t>(checkedSize - 4));
  bytes.replace(start, size.size(), size);
  appendBigEndian(bytes, checksum);
}

}  // namespace

struct PngWriter::Parts {
  bool transparent;
  PixelPacker packer{};
  std::string bytes{};
};

PngWriter::PngWriter(bool transparent) : parts_(new Parts{transparent}) {}
PngWriter::PngWriter(PngWriter&&) noexcept = default;
PngWriter& PngWriter::operator=(PngWriter&&) noexcept = default;
PngWriter::~PngWriter() = default;

const std::string& PngWriter::encode(ImageView view, const std::string& name) {
  const bool alpha = parts_->transparent && view.format == PixelFormat::Rgba8;
  std::string& bytes = parts_->bytes;
  bytes.clear();
  PngEncoder encoder(bytes);
  bool done = encoder.begin(view, alpha);
  if (done) appendPixels(parts_->packer, view, alpha, bytes);
  done = done && encoder.end();
  if (!done) throw MachineError(fmt::format("can't write {}: libpng: {}", name, encoder.message()));
  return bytes;
}

const std::string& PngWriter::write(const std::filesystem::path& path, ImageView view) {
  const std::string& bytes = encode(view, path.string());
  system::writeFileAtomically(path, bytes);
  return bytes;
}

void writePng(const std::filesystem::path& path, ImageView view, bool transparent) {
  system::writeMarked(path, PngWriter(transparent).encode(view, path.string()));
}

}  // namespace rotatebook::image
