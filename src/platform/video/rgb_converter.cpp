#include "video/rgb_converter.h"

#include <utility>

namespace rotatebook::video {
namespace {

/// Copies a row to `to`, with 3 or 4 bytes a pixel; pixels without alpha become opaque.
void copyRow(const std::uint8_t* from, int fromBytes, std::uint8_t* to, int toBytes, int pixels) {
  for (int x = 0; x < pixels; ++x, from += fromBytes, to += toBytes) {
    to[0] = from[0];
    to[1] = from[1];
    to[2] = from[2];
    if (toBytes == 4) to[3] = fromBytes == 4 ? from[3] : 255;
  }
}

}  // namespace

RgbConverter::RgbConverter(int width, int height, bool transparent)
    : frame_(makeFrame(width, height, transparent ? AV_PIX_FMT_RGBA : AV_PIX_FMT_RGB24)) {}

void RgbConverter::send(image::ImageView picture, std::int64_t number) {
  requireSize(picture, frame_->width, frame_->height);
  // The encoder may still hold the last frame.
  check(av_frame_make_writable(frame_.get()), "can't allocate a video frame");
  const int bytes = frame_->format == AV_PIX_FMT_RGBA ? 4 : 3;
  for (int y = 0; y < picture.height; ++y) {
    copyRow(picture.row(y), bytesPerPixel(picture.format),
            frame_->data[0] + static_cast<std::ptrdiff_t>(y) * frame_->linesize[0], bytes,
            picture.width);
  }
  frame_->pts = number;
  ready_ = true;
}

AVFrame* RgbConverter::receive() {
  return std::exchange(ready_, false) ? frame_.get() : nullptr;
}

}  // namespace rotatebook::video
