#include "image/jpeg_writer.h"

#include <cstdlib>

#include "base/error.h"
#include "image/jpeg_guard.h"

namespace rotatebook::image {
namespace {

/// libjpeg's compressor into memory of its own.
class JpegEncoder {
 public:
  JpegEncoder() {
    jpeg_.err = jpeg_std_error(&errors_);
    errors_.error_exit = leaveJpeg;
    jpeg_.client_data = &failure_;
  }
  JpegEncoder(const JpegEncoder&) = delete;
  JpegEncoder& operator=(const JpegEncoder&) = delete;
  ~JpegEncoder() {
    jpeg_destroy_compress(&jpeg_);
    std::free(bytes_);
  }

  bool encode(const ImageView& picture, int quality) {
    return jpegSucceeds(failure_, [this, &picture, quality] {
      jpeg_create_compress(&jpeg_);
      jpeg_mem_dest(&jpeg_, &bytes_, &size_);
      jpeg_.image_width = static_cast<JDIMENSION>(picture.width);
      jpeg_.image_height = static_cast<JDIMENSION>(picture.height);
      jpeg_.input_components = bytesPerPixel(picture.format);
      jpeg_.in_color_space = picture.format == PixelFormat::Rgb8 ? JCS_RGB : JCS_EXT_RGBX;
      jpeg_set_defaults(&jpeg_);
      jpeg_set_quality(&jpeg_, quality, TRUE);
      for (int i = 0; i < jpeg_.num_components; ++i)  // Thin gold on red keeps its colour.
        jpeg_.comp_info[i].h_samp_factor = jpeg_.comp_info[i].v_samp_factor = 1;
      jpeg_.dct_method = JDCT_ISLOW;  // Integers, as the reader's.
      jpeg_.optimize_coding = TRUE;
      jpeg_start_compress(&jpeg_, TRUE);
      while (jpeg_.next_scanline < jpeg_.image_height) {
        auto* row = const_cast<JSAMPROW>(picture.row(static_cast<int>(jpeg_.next_scanline)));
        jpeg_write_scanlines(&jpeg_, &row, 1);
      }
      jpeg_finish_compress(&jpeg_);
    });
  }

  std::string text() const { return {reinterpret_cast<const char*>(bytes_), size_}; }
  std::string message() const { return failure_.message; }

 private:
  JpegFailure failure_{};
  jpeg_error_mgr errors_{};
  jpeg_compress_struct jpeg_{};
  unsigned char* bytes_ = nullptr;
  unsigned long size_ = 0;
};

}  // namespace

std::string jpegText(ImageView picture, int quality) {
  JpegEncoder encoder;
  if (!encoder.encode(picture, quality))
    throw MachineError("libjpeg can't encode a picture: " + encoder.message());
  return encoder.text();
}

}  // namespace rotatebook::image
