#include "video/converter.h"

#include <string>

#include <fmt/core.h>

#include "base/error.h"
#include "base/text.h"

namespace rotatebook::video {

void requireSize(const image::ImageView& picture, int width, int height) {
  if (picture.width == width && picture.height == height) return;
  throw InputError(fmt::format("can't encode a picture of {}: the video is {}",
                               sizeText(picture.width, picture.height), sizeText(width, height)));
}

Handle<AVFrame> makeFrame(int width, int height, AVPixelFormat format) {
  Handle<AVFrame> frame = owned(av_frame_alloc());
  frame->width = width;
  frame->height = height;
  frame->format = format;
  check(av_frame_get_buffer(frame.get(), 0), "can't allocate a video frame");
  return frame;
}

}  // namespace rotatebook::video
