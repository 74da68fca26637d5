#include "video/decoded_pictures.h"

#include <array>
#include <cmath>
#include <limits>

#include "video/ffmpeg.h"
#include "video/input_file.h"

namespace rotatebook::video::testing {
namespace {

image::Image pictureOf(const AVFrame& frame) {
  image::Image picture(frame.width, frame.height, image::PixelFormat::Rgba8);
  const Handle<SwsContext> scaler = owned(sws_getContext(
      frame.width, frame.height, static_cast<AVPixelFormat>(frame.format), frame.width,
      frame.height, AV_PIX_FMT_RGBA, SWS_BICUBIC | SWS_ACCURATE_RND, nullptr, nullptr, nullptr));
  const int* bt709 = sws_getCoefficients(SWS_CS_ITU709);
  sws_setColorspaceDetails(scaler.get(), bt709, 0, bt709, 1, 0, 1 << 16, 1 << 16);
  const std::array<std::uint8_t*, 4> planes{picture.row(0)};
  const std::array<int, 4> strides{static_cast<int>(picture.stride())};
  sws_scale(scaler.get(), frame.data, frame.linesize, 0, frame.height, planes.data(),
            strides.data());
  return picture;
}

}  // namespace

DecodedPictures decodePictures(const std::filesystem::path& path) {
  silenceFfmpeg();
  const InputFile file = openFile(path);
  const double unit = av_q2d(file->streams[0]->time_base);
  DecodedPictures decoded;
  double end = 0;
  decode(
      file,
      [&](const AVPacket& packet) {
        end = static_cast<double>(packet.pts + packet.duration) * unit;
      },
      [&](const AVFrame& frame) {
        decoded.pictures.push_back({static_cast<double>(frame.pts) * unit, pictureOf(frame)});
      });
  decoded.duration = file->duration > 0 ? static_cast<double>(file->duration) / AV_TIME_BASE : end;
  return decoded;
}

double psnr(const image::Image& a, const image::Image& b) {
  double sum = 0;
  double count = 0;
  for (int y = 0; y < a.height(); ++y) {
    for (int x = 0; x < a.width(); ++x) {
      const std::uint8_t* one = a.row(y) + 4 * x;
      const std::uint8_t* other = b.row(y) + 4 * x;
      if (one[3] != 255 || other[3] != 255) continue;
      for (int channel = 0; channel < 3; ++channel) {
        const double difference = one[channel] - other[channel];
        sum += difference * difference;
        ++count;
      }
    }
  }
  if (sum == 0) return std::numeric_limits<double>::infinity();
  return 10 * std::log10(255.0 * 255 * count / sum);
}

}  // namespace rotatebook::video::testing
