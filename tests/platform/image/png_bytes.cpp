#include "image/png_bytes.h"

#include <algorithm>
#include <fstream>
#include <iterator>

namespace rotatebook::image::testing {
namespace {

void appendBigEndian(Bytes& bytes, std::uint32_t value) {
  for (int shift = 24; shift >= 0; shift -= 8) {
    bytes.push_back(static_cast<std::uint8_t>(value >> shift));
  }
}

void append(Bytes& bytes, const Bytes& more) {
  std::copy(more.begin(), more.end(), std::back_inserter(bytes));
}

std::uint32_t crc32(const Bytes& bytes) {
  std::uint32_t crc = 0xffffffffU;
  for (const std::uint8_t byte : bytes) {
    crc ^= byte;
    for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1) ^ ((crc & 1U) != 0 ? 0xedb88320U : 0U);
  }
  return ~crc;
}

std::uint32_t adler32(const Bytes& bytes) {
  std::uint32_t a = 1;
  std::uint32_t b = 0;
  for (const std::uint8_t byte : bytes) {
    a = (a + byte) % 65521;
    b = (b + a) % 65521;
  }
  return b << 16 | a;
}

}  // namespace

Bytes signature() {
  return {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
}

Bytes chunk(const std::string& type, const Bytes& content) {
  Bytes named(type.begin(), type.end());
  append(named, content);
  Bytes bytes;
  appendBigEndian(bytes, static_cast<std::uint32_t>(content.size()));
  append(bytes, named);
  appendBigEndian(bytes, crc32(named));
  return bytes;
}

Bytes headerChunk(const Header& header) {
  Bytes content;
  appendBigEndian(content, header.width);
  appendBigEndian(content, header.height);
  const std::uint8_t interlacing = header.interlaced ? 1 : 0;
  append(content,
         {header.bitDepth, static_cast<std::uint8_t>(header.colourType), 0, 0, interlacing});
  return chunk("IHDR", content);
}

Bytes dataChunk(const Bytes& rows) {
  const auto size = static_cast<std::uint16_t>(rows.size());
  const auto inverse = static_cast<std::uint16_t>(~size);
  const auto low = [](std::uint16_t value) { return static_cast<std::uint8_t>(value & 0xff); };
  const auto high = [](std::uint16_t value) { return static_cast<std::uint8_t>(value >> 8); };
  Bytes content = {0x78, 0x01, 0x01, low(size), high(size), low(inverse), high(inverse)};
  append(content, rows);
  appendBigEndian(content, adler32(rows));
  return chunk("IDAT", content);
}

Bytes joined(std::initializer_list<Bytes> parts) {
  Bytes all;
  for (const Bytes& part : parts) append(all, part);
  return all;
}

Bytes pngFile(const Header& header, const Bytes& rows, const Bytes& extra) {
  return joined({signature(), headerChunk(header), extra, dataChunk(rows), chunk("IEND", {})});
}

Bytes contentOf(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

Bytes pixelsOf(const Image& picture) {
  const std::uint8_t* first = picture.row(0);
  return {first, first + picture.stride() * picture.height()};
}

std::vector<std::string> chunkTypes(const Bytes& file) {
  constexpr std::size_t kFrame = 12;  // length, type and CRC
  std::vector<std::string> types;
  for (std::size_t at = signature().size(); at + kFrame <= file.size();) {
    const std::size_t size = static_cast<std::size_t>(file[at]) << 24 |
                             static_cast<std::size_t>(file[at + 1]) << 16 |
                             static_cast<std::size_t>(file[at + 2]) << 8 | file[at + 3];
    types.emplace_back(file.begin() + static_cast<std::ptrdiff_t>(at) + 4,
                       file.begin() + static_cast<std::ptrdiff_t>(at) + 8);
    at += kFrame + size;
  }
  return types;
}

}  // namespace rotatebook::image::testing
