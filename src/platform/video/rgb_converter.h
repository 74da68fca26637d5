// Copies pictures to RGB frames, unchanged. Inside the room only.
#pragma once

#include "video/converter.h"

namespace rotatebook::video {

/// Copies pictures to RGB24, or with their alpha to RGBA.
class RgbConverter : public Converter {
 public:
  RgbConverter(int width, int height, bool transparent);

  void send(image::ImageView picture, std::int64_t number) override;
  AVFrame* receive() override;

 private:
  Handle<AVFrame> frame_;
  bool ready_ = false;
};

}  // namespace rotatebook::video
