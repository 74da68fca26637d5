#include "video/y4m_stream.h"

#include <cstddef>
#include <utility>

#include <fmt/core.h>

#include "video/encoder.h"
#include "video/pixel_converter.h"

namespace rotatebook::video {
namespace {

void appendPlane(const AVFrame& frame, int plane, int width, int height, std::string& bytes) {
  for (int y = 0; y < height; ++y) {
    const std::uint8_t* row =
        frame.data[plane] + static_cast<std::ptrdiff_t>(y) * frame.linesize[plane];
    bytes.append(reinterpret_cast<const char*>(row), static_cast<std::size_t>(width));
  }
}

}  // namespace

Y4mStream::Y4mStream(const VideoSettings& settings) {
  silenceFfmpeg();
  requireSizeAndRate(settings);
  requireEvenSize(settings, "Y4M");
  converter_ = std::make_unique<PixelConverter>(settings.width, settings.height);
  // As FFmpeg writes it: its words for the siting (mpeg2 is left) and the range are in use.
  bytes_ = fmt::format(
      "YUV4MPEG2 W{} H{} F{}:{} Ip A1:1 C420mpeg2 XYSCSS=420MPEG2 XCOLORRANGE=LIMITED\n",
      settings.width, settings.height, settings.frameRate.numerator,
      settings.frameRate.denominator);
}

Y4mStream::~Y4mStream() = default;

const std::string& Y4mStream::next(image::ImageView picture) {
  const AVFrame& converted = converter_->convert(picture);
  if (!std::exchange(isFirst_, false)) bytes_.clear();
  bytes_ += "FRAME\n";
  appendPlane(converted, 0, converted.width, converted.height, bytes_);
  for (const int chroma : {1, 2})
    appendPlane(converted, chroma, converted.width / 2, converted.height / 2, bytes_);
  return bytes_;
}

}  // namespace rotatebook::video
