// PNG files made by hand, byte by byte from the format's text: what libpng reads is known without
// libpng.
#pragma once

#include <cstdint>
#include <filesystem>
#include <initializer_list>
#include <string>
#include <vector>

#include "image/image.h"

namespace rotatebook::image::testing {

using Bytes = std::vector<std::uint8_t>;

/// The colour types of the format.
enum class ColourType : std::uint8_t { Grey = 0, Rgb = 2, Palette = 3, GreyAlpha = 4, Rgba = 6 };

struct Header {
  std::uint32_t width = 1;
  std::uint32_t height = 1;
  std::uint8_t bitDepth = 8;
  ColourType colourType = ColourType::Rgb;
  bool interlaced = false;
};

/// The eight bytes that a PNG begins with.
Bytes signature();

/// Length, type, content, CRC.
Bytes chunk(const std::string& type, const Bytes& content);

Bytes headerChunk(const Header& header);

/// IDAT with `rows` (each with its filter byte) in a zlib stream that compresses nothing. Up to
/// 65535 bytes.
Bytes dataChunk(const Bytes& rows);

Bytes joined(std::initializer_list<Bytes> parts);

/// A whole file: signature, IHDR, `extra` chunks, IDAT, IEND.
Bytes pngFile(const Header& header, const Bytes& rows, const Bytes& extra = {});

/// Returns the content of a file.
Bytes contentOf(const std::filesystem::path& path);

/// A picture's rows.
Bytes pixelsOf(const Image& picture);

/// The types of a file's chunks in order, without checking their CRCs.
std::vector<std::string> chunkTypes(const Bytes& file);

}  // namespace rotatebook::image::testing
