#include "image/webp_writer.h"

#include <cstdint>
#include <memory>
#include <webp/encode.h>

#include "base/error.h"

namespace rotatebook::image {
namespace {

using WebpBytes =
    std::unique_ptr<std::uint8_t, decltype([](std::uint8_t* bytes) { WebPFree(bytes); })>;

}  // namespace

std::string webpText(ImageView picture, float quality) {
  const bool hasAlpha = picture.format == PixelFormat::Rgba8;
  const auto encode = hasAlpha ? WebPEncodeRGBA : WebPEncodeRGB;
  std::uint8_t* encoded = nullptr;
  const std::size_t size = encode(picture.row(0), picture.width, picture.height,
                                  static_cast<int>(picture.stride), quality, &encoded);
  const WebpBytes bytes(encoded);
  if (size == 0) throw MachineError("libwebp can't encode a picture");
  return {reinterpret_cast<const char*>(bytes.get()), size};
}

}  // namespace rotatebook::image
