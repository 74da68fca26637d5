#include <memory>
#include <new>
#include <string>
#include <utility>
#include <webp/decode.h>
#include <webp/demux.h>

#include "image/exif.h"
#include "image/picture_decoders.h"

namespace rotatebook::image {
namespace {

using Demuxer =
    std::unique_ptr<WebPDemuxer, decltype([](WebPDemuxer* demuxer) { WebPDemuxDelete(demuxer); })>;

std::string reasonOf(VP8StatusCode status) {
  if (status == VP8_STATUS_OUT_OF_MEMORY) throw std::bad_alloc();
  if (status == VP8_STATUS_NOT_ENOUGH_DATA || status == VP8_STATUS_SUSPENDED) {
    return "corrupt WebP: the file ends too early";
  }
  if (status == VP8_STATUS_UNSUPPORTED_FEATURE) return "corrupt WebP: an unknown feature";
  return "corrupt WebP: its data is damaged";
}

/// Returns the orientation that the file's EXIF states, 1 to 8.
int storedOrientation(const WebPDemuxer* demuxer) {
  WebPChunkIterator chunk{};
  const bool found = WebPDemuxGetChunk(demuxer, "EXIF", 1, &chunk) != 0;
  const int orientation = found ? orientationOf({chunk.chunk.bytes, chunk.chunk.size}) : 1;
  WebPDemuxReleaseChunkIterator(&chunk);
  return orientation;
}

/// Decodes into `picture`, which has the file's size. One thread and no dithering; libwebp's vector
/// code and its plain code give equal pixels.
VP8StatusCode decodeInto(Image& picture, std::span<const std::uint8_t> bytes) {
  WebPDecoderConfig config;
  WebPInitDecoderConfig(&config);
  config.output.colorspace = picture.format() == PixelFormat::Rgba8 ? MODE_RGBA : MODE_RGB;
  config.output.is_external_memory = 1;
  config.output.u.RGBA = {picture.row(0), static_cast<int>(picture.stride()),
                          static_cast<std::size_t>(picture.stride() * picture.height())};
  return WebPDecode(bytes.data(), bytes.size(), &config);
}

}  // namespace

Image decodeWebp(std::span<const std::uint8_t> bytes, const std::string& name) {
  WebPBitstreamFeatures features{};
  const VP8StatusCode head = WebPGetFeatures(bytes.data(), bytes.size(), &features);
  if (head != VP8_STATUS_OK) refusePicture(name, reasonOf(head));
  if (features.has_animation != 0) {
    refusePicture(name,
                  "an animated WebP; a still picture is needed, such as one of its frames: "
                  "webpmux -get frame 1");
  }
  // Without loss, a picture of one colour takes no bits.
  requirePossible({features.width, features.height, 0}, bytes.size(), "WebP", name);
  const WebPData data{bytes.data(), bytes.size()};
  const Demuxer demuxer(WebPDemux(&data));
  if (!demuxer) refusePicture(name, reasonOf(VP8_STATUS_NOT_ENOUGH_DATA));
  Image stored(features.width, features.height,
               features.has_alpha != 0 ? PixelFormat::Rgba8 : PixelFormat::Rgb8);
  const VP8StatusCode body = decodeInto(stored, bytes);
  if (body != VP8_STATUS_OK) refusePicture(name, reasonOf(body));
  return upright(std::move(stored), storedOrientation(demuxer.get()));
}

}  // namespace rotatebook::image
