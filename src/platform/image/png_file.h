// Reads and writes PNG through libpng and ISA-L.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>

#include "base/clip_limits.h"
#include "image/image.h"

namespace rotatebook::image {

/// Writes `view` as an 8-bit PNG with an sRGB chunk and the program's mark, opaque unless
/// `transparent`. The file appears whole or not at all (see AtomicFile). Throws MachineError.
void writePng(const std::filesystem::path& path, ImageView view, bool transparent = false);

/// Writes PNGs one after the other, with the bytes of writePng() but for the mark, and faster: it
/// reuses what it packed for the previous picture where the two are equal. For one thread at a
/// time.
class PngWriter {
 public:
  explicit PngWriter(bool transparent = false);
  PngWriter(PngWriter&&) noexcept;
  PngWriter& operator=(PngWriter&&) noexcept;
  ~PngWriter();

  /// Returns a picture as a file's bytes, valid until the next call. Throws MachineError, which
  /// says that `name` can't be written.
  const std::string& encode(ImageView view, const std::string& name);
  /// Writes a picture and returns the file's bytes, valid until the next call. Throws MachineError.
  const std::string& write(const std::filesystem::path& path, ImageView view);

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

/// Reads any PNG as 8-bit sRGB, Rgba8 if it has transparency, else Rgb8; palettes and grey are
/// expanded, 16 bits reduced. Throws InputError if the file doesn't exist, isn't a PNG, is corrupt
/// (with libpng's message), is larger than a clip's pictures can be, or has more than
/// kMaxPictureBytes. A header that claims more than its file can hold is refused before memory is
/// allocated.
Image readPng(const std::filesystem::path& path);

/// Like readPng(), from memory; `name` is for messages.
Image decodePng(std::span<const std::uint8_t> bytes, const std::string& name);

}  // namespace rotatebook::image
