// Reads pictures of the formats that a book's cover may have.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>

#include "image/image.h"

namespace rotatebook::image {

/// Reads a PNG, JPEG or WebP, as its first bytes say, as 8-bit sRGB: Rgba8 if it has transparency,
/// else Rgb8. Grey is expanded, colour profiles are ignored; a JPEG or WebP is turned as its EXIF
/// says. `name` is for messages. Throws InputError for other formats, for CMYK, animations,
/// corrupt or truncated files, and for pictures larger than a clip's can be, before their memory is
/// allocated.
Image decodePicture(std::span<const std::uint8_t> bytes, const std::string& name);

/// Returns the bytes of a picture's file, not decoded. Throws InputError if it doesn't exist or has
/// more than kMaxPictureBytes.
std::string readPictureFile(const std::filesystem::path& path);

}  // namespace rotatebook::image
