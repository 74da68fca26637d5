#include <jerror.h>
#include <string>
#include <utility>

#include "image/exif.h"
#include "image/jpeg_guard.h"
#include "image/picture_decoders.h"

#ifndef LIBJPEG_TURBO_VERSION
#error "Other libraries than libjpeg-turbo decode to other pixels."
#endif

namespace rotatebook::image {
namespace {

// A Huffman code takes a bit or more for each block of 8x8 pixels.
constexpr std::uint64_t kMaxPixelsPerByte = 8 * 64;
// Progressive files of cameras and encoders have some 10; each takes time for the whole picture.
constexpr int kMaxScans = 100;
constexpr int kExifMarker = JPEG_APP0 + 1;
constexpr unsigned kLongestMarker = 0xffff;

/// Leaves if pixels are missing or damaged, of which libjpeg only warns.
void leaveIfDamaged(j_common_ptr jpeg, int level) {
  constexpr int kWarning = -1;
  if (level != kWarning) return;
  switch (jpeg->err->msg_code) {
    case JWRN_ADOBE_XFORM:
    case JWRN_BOGUS_ICC:
    case JWRN_EXTRANEOUS_DATA:
    case JWRN_JFIF_MAJOR:
      return;
    default:
      leaveJpeg(jpeg);
  }
}

void leaveAfterManyScans(j_common_ptr jpeg) {
  if (reinterpret_cast<j_decompress_ptr>(jpeg)->input_scan_number <= kMaxScans) return;
  auto* failure = static_cast<JpegFailure*>(jpeg->client_data);
  std::snprintf(failure->message, sizeof failure->message, "more than %d scans", kMaxScans);
  std::longjmp(failure->landing, 1);
}

/// libjpeg's decompressor of a file in memory, which must outlive it.
class JpegDecoder {
 public:
  explicit JpegDecoder(std::span<const std::uint8_t> bytes) : bytes_(bytes) {
    jpeg_.err = jpeg_std_error(&errors_);
    errors_.error_exit = leaveJpeg;
    errors_.emit_message = leaveIfDamaged;
    jpeg_.client_data = &failure_;
    progress_.progress_monitor = leaveAfterManyScans;
  }
  JpegDecoder(const JpegDecoder&) = delete;
  JpegDecoder& operator=(const JpegDecoder&) = delete;
  ~JpegDecoder() { jpeg_destroy_decompress(&jpeg_); }

  bool readHeader() {
    return jpegSucceeds(failure_, [this] {
      jpeg_create_decompress(&jpeg_);
      jpeg_.progress = &progress_;
      jpeg_save_markers(&jpeg_, kExifMarker, kLongestMarker);
      jpeg_mem_src(&jpeg_, bytes_.data(), static_cast<unsigned long>(bytes_.size()));
      jpeg_read_header(&jpeg_, TRUE);
    });
  }

  int width() const { return static_cast<int>(jpeg_.image_width); }
  int height() const { return static_cast<int>(jpeg_.image_height); }
  std::uint64_t pixels() const { return std::uint64_t{jpeg_.image_width} * jpeg_.image_height; }
  bool isCmyk() const {
    return jpeg_.jpeg_color_space == JCS_CMYK || jpeg_.jpeg_color_space == JCS_YCCK;
  }

  /// Returns the orientation that the header states, 1 to 8. Call it before readPixels(), which
  /// forgets the header.
  int orientation() const {
    for (const jpeg_marker_struct* one = jpeg_.marker_list; one != nullptr; one = one->next) {
      const int found = orientationOf({one->data, one->data_length});
      if (found != 1) return found;
    }
    return 1;
  }

  /// `picture` is Rgb8 and of the header's size.
  bool readPixels(Image& picture) {
    return jpegSucceeds(failure_, [this, &picture] {
      // Integers alone: the floating-point transform gives other pixels on other machines
      // (libjpeg-turbo's libjpeg.txt). Its vector code and its plain code give equal ones.
      jpeg_.dct_method = JDCT_ISLOW;
      jpeg_.do_fancy_upsampling = TRUE;
      jpeg_.do_block_smoothing = FALSE;
      jpeg_.out_color_space = JCS_RGB;
      jpeg_start_decompress(&jpeg_);
      while (jpeg_.output_scanline < jpeg_.output_height) {
        JSAMPROW row = picture.row(static_cast<int>(jpeg_.output_scanline));
        jpeg_read_scanlines(&jpeg_, &row, 1);
      }
      jpeg_finish_decompress(&jpeg_);
    });
  }

  std::string message() const { return failure_.message; }

 private:
  std::span<const std::uint8_t> bytes_;
  JpegFailure failure_{};
  jpeg_error_mgr errors_{};
  jpeg_progress_mgr progress_{};
  jpeg_decompress_struct jpeg_{};
};

}  // namespace

Image decodeJpeg(std::span<const std::uint8_t> bytes, const std::string& name) {
  JpegDecoder decoder(bytes);
  if (!decoder.readHeader()) refusePicture(name, "corrupt JPEG: " + decoder.message());
  const std::uint64_t least = decoder.pixels() / kMaxPixelsPerByte;
  requirePossible({decoder.width(), decoder.height(), least}, bytes.size(), "JPEG", name);
  if (decoder.isCmyk()) {
    refusePicture(name,
                  "a JPEG of CMYK colours, which are for printing; convert it to sRGB, e.g. with "
                  "ImageMagick's convert -colorspace sRGB");
  }
  const int orientation = decoder.orientation();
  Image stored(decoder.width(), decoder.height(), PixelFormat::Rgb8);
  if (!decoder.readPixels(stored)) refusePicture(name, "corrupt JPEG: " + decoder.message());
  return upright(std::move(stored), orientation);
}

}  // namespace rotatebook::image
