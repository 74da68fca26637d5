#include "image/picture_file.h"

#include <algorithm>
#include <string_view>

#include <fmt/core.h>

#include "base/error.h"
#include "base/text.h"
#include "image/picture_decoders.h"
#include "image/png_file.h"
#include "system/read_file.h"

namespace rotatebook::image {
namespace {

bool hasAt(std::span<const std::uint8_t> bytes, std::size_t at, std::string_view expected) {
  if (bytes.size() < at + expected.size()) return false;
  return std::ranges::equal(bytes.subspan(at, expected.size()), expected, {}, {},
                            [](char letter) { return static_cast<std::uint8_t>(letter); });
}

bool isPng(std::span<const std::uint8_t> bytes) {
  return hasAt(bytes, 0, "\x89PNG\r\n\x1a\n");
}

bool isJpeg(std::span<const std::uint8_t> bytes) {
  return hasAt(bytes, 0, "\xff\xd8\xff");
}

bool isWebp(std::span<const std::uint8_t> bytes) {
  return hasAt(bytes, 0, "RIFF") && hasAt(bytes, 8, "WEBP");
}

}  // namespace

void refusePicture(const std::string& name, const std::string& why) {
  throw InputError(fmt::format("can't read {}: {}", name, why));
}

void requirePossible(const ClaimedSize& claimed, std::size_t fileSize, const char* format,
                     const std::string& name) {
  const std::string size = sizeText(claimed.width, claimed.height);
  if (claimed.width > kMaxPictureSide || claimed.height > kMaxPictureSide) {
    refusePicture(name, fmt::format("{} pixels; the limit is {} a side", size, kMaxPictureSide));
  }
  if (claimed.leastBytes > fileSize) {
    refusePicture(
        name, fmt::format("corrupt {}: {} bytes can't hold the {} pixels that its header claims",
                          format, fileSize, size));
  }
  // Few bytes can still unpack to gigabytes.
  if (claimed.width * claimed.height > kMaxPicturePixels) {
    refusePicture(name, fmt::format("{} pixels; the limit is {} in all", size, kMaxPicturePixels));
  }
}

Image decodePicture(std::span<const std::uint8_t> bytes, const std::string& name) {
  if (isPng(bytes)) return decodePng(bytes, name);
  if (isJpeg(bytes)) return decodeJpeg(bytes, name);
  if (isWebp(bytes)) return decodeWebp(bytes, name);
  refusePicture(name,
                "neither PNG, JPEG nor WebP; convert it to one of them, e.g. with ImageMagick's "
                "convert");
}

std::string readPictureFile(const std::filesystem::path& path) try {
  return system::readFile(path, kMaxPictureBytes);
} catch (const InputError& error) {
  refusePicture(path.string(), error.what());
}

}  // namespace rotatebook::image
