// Converts RGB pictures to the encoder's YUV. Inside the room only.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "image/image.h"
#include "video/converter.h"
#include "video/opaque_converter.h"

namespace rotatebook::video {

/// Converts sRGB pictures of one size to yuv420p, or with their alpha to yuva420p, or to other YUV:
/// BT.709 matrix, limited range, chroma sited left, which is H.264's default. Gives the same bytes
/// on every processor. A flat colour is within 0.51 of the exact value.
class PixelConverter : public Converter {
 public:
  /// Converts pictures of even `width` and `height`, at least kSmallestSide. [pixels]
  PixelConverter(int width, int height, bool transparent = false);
  /// Converts to the YUV `target`, of any size if its chroma is whole, with alpha if `transparent`.
  PixelConverter(int width, int height, bool transparent, AVPixelFormat target);

  void send(image::ImageView picture, std::int64_t number) override;
  AVFrame* receive() override;

  /// Returns the converted picture, tagged; valid until the next call. Reads `picture` in place,
  /// with any stride. Throws InputError if its size isn't the converter's.
  AVFrame& convert(image::ImageView picture);

 private:
  void prepareFor(image::PixelFormat format);
  void scaleCopy(const image::ImageView& picture, int top);
  void scale(const std::uint8_t* topRow, std::ptrdiff_t stride, int top, int rows);

  bool transparent_;
  bool ready_ = false;
  Handle<AVFrame> frame_;
  std::optional<OpaqueConverter> opaque_;  // For Rgba8, where it can convert.
  Handle<SwsContext> scaler_;              // For the rest, made when first needed.
  std::vector<std::uint8_t> copy_;
  image::PixelFormat scalerFormat_{};
};

}  // namespace rotatebook::video
