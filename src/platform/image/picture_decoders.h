// The decoders behind decodePicture(), and what they share. Inside the room only.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "image/image.h"

namespace rotatebook::image {

/// Throws InputError "can't read NAME: WHY".
[[noreturn]] void refusePicture(const std::string& name, const std::string& why);

/// The size of a picture as its file's head states it.
struct ClaimedSize {
  std::int64_t width, height;  ///< [pixels]
  std::uint64_t leastBytes;    ///< Below which no file holds so many pixels.
};

/// Throws InputError if a picture is larger than a clip's can be, or than `fileSize` bytes can
/// hold. Called before anything is allocated: a few bytes can claim gigabytes. `format`: "PNG".
void requirePossible(const ClaimedSize& size, std::size_t fileSize, const char* format,
                     const std::string& name);

// Like decodePicture(), for bytes that begin as their format does.
Image decodeJpeg(std::span<const std::uint8_t> bytes, const std::string& name);
Image decodeWebp(std::span<const std::uint8_t> bytes, const std::string& name);

}  // namespace rotatebook::image
