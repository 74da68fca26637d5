// Converts pictures to the frames that an encoder accepts. Inside the room only.
#pragma once

#include <cstdint>

#include "image/image.h"
#include "video/ffmpeg.h"

namespace rotatebook::video {

class Converter {
 public:
  virtual ~Converter() = default;

  /// Takes picture `number`, counted from 0; `picture` is only borrowed. Throws InputError if its
  /// size isn't the video's. Follow with receive() until it returns nullptr.
  virtual void send(image::ImageView picture, std::int64_t number) = 0;
  /// Reports that there are no more pictures.
  virtual void end() {}
  /// Returns the next frame, in the encoder's format and time base, valid until the next call;
  /// nullptr if there is none yet.
  virtual AVFrame* receive() = 0;
};

/// Throws InputError if `picture` isn't of that size.
void requireSize(const image::ImageView& picture, int width, int height);

/// Allocates a frame of that size, its content undefined. [pixels]
Handle<AVFrame> makeFrame(int width, int height, AVPixelFormat format);

}  // namespace rotatebook::video
