// PNG in and out, through libpng and ISA-L.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>

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
/// words), or over one of the limits below. A header that claims more than its file can hold is
/// refused before memory is taken for it.
Image readPng(const std::filesystem::path& path);

/// The same from memory; `name` is for messages.
Image decodePng(std::span<const std::uint8_t> bytes, const std::string& name);

/// Widest and highest picture that readPng takes. [pixels]
inline constexpr int kLargestSide = 16384;
/// Largest picture that readPng takes: as large as the largest clip's. [pixels]
inline constexpr std::int64_t kMostPixels = 35'651'584;
/// Longest file that readPng takes: the largest picture, not compressed at all. [bytes]
inline constexpr std::uintmax_t kLargestFile = 5 * kMostPixels;

}  // namespace rotatebook::image
