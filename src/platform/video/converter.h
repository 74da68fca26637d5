// Pictures into what an encoder takes. Inside the room only.
#pragma once

#include <cstdint>

#include "image/image.h"
#include "video/ffmpeg.h"

namespace rotatebook::video {

class Converter {
 public:
  virtual ~Converter() = default;

  /// Takes picture `number`, counted from 0, which is only borrowed. Throws InputError for a size
  /// that isn't the video's. Follow with receive() until it is empty.
  virtual void send(image::ImageView picture, std::int64_t number) = 0;
  /// Says that there are no more.
  virtual void end() {}
  /// The next frame, in the encoder's format and time base, valid until the next call; nullptr if
  /// there is none yet.
  virtual AVFrame* receive() = 0;
};

/// Throws InputError if `picture` hasn't that size.
void requireSize(const image::ImageView& picture, int width, int height);

/// An empty frame. [pixels]
Handle<AVFrame> makeFrame(int width, int height, AVPixelFormat format);

}  // namespace rotatebook::video
