// PNG in and out, through libpng and ISA-L.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>

#include "base/clip_limits.h"
#include "image/image.h"

namespace rotatebook::image {

/// Writes `view` as an 8-bit PNG with an sRGB chunk, opaque unless it is to be `transparent`,
/// whole or not at all (see AtomicFile). Throws MachineError.
void writePng(const std::filesystem::path& path, ImageView view, bool transparent = false);

/// Writes one PNG after the other as writePng() does, with the same bytes, and faster: where a
/// picture is like the one before, it takes what it made of that one. One thread at a time.
class PngWriter {
 public:
  explicit PngWriter(bool transparent = false);
  PngWriter(PngWriter&&) noexcept;
  PngWriter& operator=(PngWriter&&) noexcept;
  ~PngWriter();

  /// Returns the bytes that were written, which are there until the next call. Throws MachineError.
  const std::string& write(const std::filesystem::path& path, ImageView view);

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

/// Reads any PNG as 8-bit sRGB: palettes, grey and 16 bits are expanded or reduced; Rgba8 if it has
/// transparency, else Rgb8. Throws InputError: no such file, not a PNG, corrupt (with libpng's
/// words), larger than a clip's pictures can be, or a file of more than kLargestFile. A header that
/// claims more than its file can hold is refused before memory is taken for it.
Image readPng(const std::filesystem::path& path);

/// The bytes of a PNG's file, not decoded. Throws InputError as readPng: no such file, or too
/// large.
std::string readPngFile(const std::filesystem::path& path);

/// readPng() from memory; `name` is for messages.
Image decodePng(std::span<const std::uint8_t> bytes, const std::string& name);

/// Longest file that readPng takes: the largest picture, not compressed at all. [bytes]
inline constexpr std::uintmax_t kLargestFile = 5 * kMaxPicturePixels;

}  // namespace rotatebook::image
