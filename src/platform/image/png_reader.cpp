#include <cstring>
#include <new>
#include <string>
#include <vector>

#include "image/picture_decoders.h"
#include "image/picture_file.h"
#include "image/png_file.h"
#include "image/png_guard.h"

namespace rotatebook::image {
namespace {

constexpr std::size_t kSignatureSize = 8;

// No deflate stream unpacks to more than 1032 times its size.
constexpr std::size_t kDeflateLargestRatio = 1032;

// The unread rest of a PNG in memory.
struct Remaining {
  const std::uint8_t* next;
  std::size_t size;
};

struct PngHeader {
  png_uint_32 width = 0;
  png_uint_32 height = 0;
  std::size_t rowBytes = 0;  // as stored, before any expansion
  bool hasAlpha = false;
};

// libpng's read structure and the state of its callbacks.
class PngDecoder {
 public:
  explicit PngDecoder(std::span<const std::uint8_t> bytes)
      : remaining_{bytes.data(), bytes.size()},
        png_(png_create_read_struct(PNG_LIBPNG_VER_STRING, &message_, jumpWithMessage,
                                    ignoreWarning)) {
    if (png_ != nullptr) info_ = png_create_info_struct(png_);
    if (info_ == nullptr) png_destroy_read_struct(&png_, nullptr, nullptr);
    if (png_ == nullptr) throw std::bad_alloc();
    png_set_read_fn(png_, &remaining_, take);
  }
  PngDecoder(const PngDecoder&) = delete;
  PngDecoder& operator=(const PngDecoder&) = delete;
  ~PngDecoder() { png_destroy_read_struct(&png_, &info_, nullptr); }

  bool readHeader(PngHeader& header) {
    return guarded(png_, [this, &header] {
      // libpng's own limits are lifted: checkSize() names the size that it refuses.
      png_set_user_limits(png_, PNG_UINT_31_MAX, PNG_UINT_31_MAX);
      png_set_crc_action(png_, PNG_CRC_ERROR_QUIT, PNG_CRC_ERROR_QUIT);
      // Texts, profiles and the like are skipped: they may unpack to gigabytes.
      png_set_keep_unknown_chunks(png_, PNG_HANDLE_CHUNK_NEVER, nullptr, -1);
      png_read_info(png_, info_);
      header.width = png_get_image_width(png_, info_);
      header.height = png_get_image_height(png_, info_);
      header.rowBytes = png_get_rowbytes(png_, info_);
      header.hasAlpha = (png_get_color_type(png_, info_) & PNG_COLOR_MASK_ALPHA) != 0 ||
                        png_get_valid(png_, info_, PNG_INFO_tRNS) != 0;
    });
  }

  // `rows` point into a picture that is Rgba8 if the header has alpha, else Rgb8.
  bool readPixels(png_bytepp rows) {
    return guarded(png_, [this, rows] {
      png_set_expand(png_);
      png_set_gray_to_rgb(png_);
      png_set_scale_16(png_);
      png_read_update_info(png_, info_);
      png_read_image(png_, rows);
      png_read_end(png_, nullptr);
    });
  }

  const char* message() const { return message_.text; }

 private:
  static void take(png_structp png, png_bytep target, std::size_t size) {
    auto* remaining = static_cast<Remaining*>(png_get_io_ptr(png));
    if (remaining->size < size) png_error(png, "the file ends too early");
    std::memcpy(target, remaining->next, size);
    remaining->next += size;
    remaining->size -= size;
  }

  PngMessage message_;
  Remaining remaining_;
  png_structp png_;
  png_infop info_ = nullptr;
};

std::vector<png_bytep> rowPointers(Image& image) {
  std::vector<png_bytep> rows;
  rows.reserve(static_cast<std::size_t>(image.height()));
  for (int y = 0; y < image.height(); ++y) rows.push_back(image.row(y));
  return rows;
}

}  // namespace

Image decodePng(std::span<const std::uint8_t> bytes, const std::string& name) {
  if (bytes.size() < kSignatureSize || png_sig_cmp(bytes.data(), 0, kSignatureSize) != 0) {
    const bool isJpeg =
        bytes.size() >= 3 && bytes[0] == 0xff && bytes[1] == 0xd8 && bytes[2] == 0xff;
    refusePicture(name, std::string(isJpeg ? "a JPEG" : "not a PNG") +
                            "; convert it to PNG, e.g. with ImageMagick's convert");
  }
  PngDecoder decoder(bytes);
  PngHeader header;
  if (!decoder.readHeader(header))
    refusePicture(name, "corrupt PNG: " + std::string(decoder.message()));
  const std::uint64_t least = header.rowBytes * header.height / kDeflateLargestRatio;
  requirePossible({header.width, header.height, least}, bytes.size(), "PNG", name);
  Image image(static_cast<int>(header.width), static_cast<int>(header.height),
              header.hasAlpha ? PixelFormat::Rgba8 : PixelFormat::Rgb8);
  std::vector<png_bytep> rows = rowPointers(image);
  if (!decoder.readPixels(rows.data())) {
    refusePicture(name, "corrupt PNG: " + std::string(decoder.message()));
  }
  return image;
}

Image readPng(const std::filesystem::path& path) {
  const std::string bytes = readPictureFile(path);
  return decodePng({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()},
                   path.string());
}

}  // namespace rotatebook::image
