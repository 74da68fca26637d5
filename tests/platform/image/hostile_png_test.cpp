// PNGs that nobody means well with: each is a picture of the size that it claims, or refused.
#include <algorithm>
#include <array>
#include <string>
#include <sys/resource.h>
#include <vector>

#include <gtest/gtest.h>

#include "base/error.h"
#include "image/png_bytes.h"
#include "image/png_file.h"

namespace rotatebook::image {
namespace {

using testing::Bytes;
using testing::chunk;
using testing::ColourType;
using testing::dataChunk;
using testing::Header;
using testing::headerChunk;
using testing::joined;
using testing::pngFile;
using testing::signature;

/// Returns whether the bytes are a picture, of the header's size; if not, they are refused.
bool isPicture(const Bytes& bytes, const Header& header) {
  try {
    const Image picture = decodePng(bytes, "hostile.png");
    EXPECT_EQ(static_cast<std::uint32_t>(picture.width()), header.width);
    EXPECT_EQ(static_cast<std::uint32_t>(picture.height()), header.height);
    return true;
  } catch (const InputError&) {
    return false;
  }
}

std::uint32_t channelsOf(ColourType type) {
  switch (type) {
    case ColourType::Rgb:
      return 3;
    case ColourType::GreyAlpha:
      return 2;
    case ColourType::Rgba:
      return 4;
    default:
      return 1;
  }
}

bool isAllowed(ColourType type, int bitDepth) {
  if (bitDepth == 8) return true;
  if (bitDepth == 16) return type != ColourType::Palette;
  const bool small = bitDepth == 1 || bitDepth == 2 || bitDepth == 4;
  return small && (type == ColourType::Grey || type == ColourType::Palette);
}

/// One of Adam7's passes over a picture: each stepX-th column from firstX on, likewise the rows.
struct Pass {
  std::uint32_t firstX, firstY, stepX, stepY;
};
constexpr std::array<Pass, 7> kAdam7{{{0, 0, 8, 8},
                                      {4, 0, 8, 8},
                                      {0, 4, 4, 8},
                                      {2, 0, 4, 4},
                                      {0, 2, 2, 4},
                                      {1, 0, 2, 2},
                                      {0, 1, 1, 2}}};

void appendRows(const Header& header, const Pass& pass, std::uint8_t filter, Bytes& rows) {
  const auto count = [](std::uint32_t size, std::uint32_t first, std::uint32_t step) {
    return size <= first ? 0 : (size - first + step - 1) / step;
  };
  const std::uint32_t columns = count(header.width, pass.firstX, pass.stepX);
  const std::uint32_t rowSize = (columns * channelsOf(header.colourType) * header.bitDepth + 7) / 8;
  for (std::uint32_t y = pass.firstY; columns > 0 && y < header.height; y += pass.stepY) {
    rows.push_back(filter);
    for (std::uint32_t i = 0; i < rowSize; ++i) {
      rows.push_back(static_cast<std::uint8_t>(37 * rows.size()));
    }
  }
}

Bytes rowsOf(const Header& header, std::uint8_t filter) {
  Bytes rows;
  if (!header.interlaced) appendRows(header, {0, 0, 1, 1}, filter, rows);
  for (const Pass& pass : kAdam7) {
    if (header.interlaced) appendRows(header, pass, filter, rows);
  }
  return rows;
}

/// A palette, needed or not, and a transparent colour, where there may be one or not.
Bytes extrasOf(const Header& header, bool transparent) {
  const bool grey = header.colourType == ColourType::Grey;
  const Bytes palette = chunk("PLTE", {1, 2, 3, 4, 5, 6});
  const Bytes colour = chunk("tRNS", grey ? Bytes{0, 1} : Bytes{0, 1, 0, 2, 0, 3});
  const Bytes indices = chunk("tRNS", {7, 8});
  const bool indexed = header.colourType == ColourType::Palette;
  return joined({indexed ? palette : Bytes{}, !transparent ? Bytes{} : indexed ? indices : colour});
}

Bytes fileOf(const Header& header, bool transparent, std::uint8_t filter) {
  return pngFile(header, rowsOf(header, filter), extrasOf(header, transparent));
}

/// Returns every kind of picture, of this size.
std::vector<Header> kindsOf(std::uint32_t width, std::uint32_t height) {
  std::vector<Header> kinds;
  for (int type = 0; type < 8; ++type) {
    for (int depth = 0; depth < 18; ++depth) {
      for (const bool interlaced : {false, true}) {
        const auto colourType = static_cast<ColourType>(type);
        const bool known = type != 1 && type != 5 && type != 7;
        if (!known || !isAllowed(colourType, depth)) continue;
        kinds.push_back({width, height, static_cast<std::uint8_t>(depth), colourType, interlaced});
      }
    }
  }
  return kinds;
}

TEST(HostilePng, OfEachKindIsAPicture) {
  constexpr std::array<std::array<std::uint32_t, 2>, 5> kSizes{
      {{1, 1}, {2, 3}, {7, 1}, {1, 9}, {33, 17}}};
  for (const auto& [width, height] : kSizes) {
    const std::vector<Header> kinds = kindsOf(width, height);
    EXPECT_EQ(kinds.size(), 30U);
    for (const Header& header : kinds) {
      for (std::uint8_t filter = 0; filter <= 4; ++filter) {
        EXPECT_TRUE(isPicture(fileOf(header, filter % 2 == 1, filter), header));
      }
    }
  }
}

TEST(HostilePng, WithoutPixelsOrTooWideIsRefused) {
  for (const std::uint32_t size : {0U, 0x7fffffffU, 0x80000000U, 0xffffffffU}) {
    for (Header header : kindsOf(1, 1)) {
      const Bytes rows = rowsOf(header, 0);
      header.width = size;
      EXPECT_FALSE(isPicture(pngFile(header, rows, extrasOf(header, false)), header)) << size;
      std::swap(header.width, header.height);
      EXPECT_FALSE(isPicture(pngFile(header, rows, extrasOf(header, false)), header)) << size;
    }
  }
}

TEST(HostilePng, OfAKindThatDoesNotExistIsRefused) {
  int kinds = 0;
  for (int type = 0; type < 8; ++type) {
    for (int depth = 0; depth < 18; ++depth) {
      const Header header{3, 3, static_cast<std::uint8_t>(depth), static_cast<ColourType>(type)};
      kinds += isPicture(pngFile(header, Bytes(300, 0), extrasOf(header, false)), header) ? 1 : 0;
    }
  }
  EXPECT_EQ(kinds, 15);
}

TEST(HostilePng, CutAnywhereIsRefused) {
  for (const Header& header : kindsOf(33, 17)) {
    const Bytes whole = fileOf(header, true, 4);
    for (std::size_t size = 0; size < whole.size(); size += 64) {
      EXPECT_FALSE(isPicture({whole.begin(), whole.begin() + static_cast<long>(size)}, header));
    }
  }
}

TEST(HostilePng, OfWrongFiltersLengthsAndChecksumsIsRefused) {
  for (const Header& header : kindsOf(9, 8)) {
    for (const int filter : {5, 6, 128, 255}) {
      EXPECT_FALSE(isPicture(fileOf(header, false, static_cast<std::uint8_t>(filter)), header));
    }
    const Bytes whole = fileOf(header, false, 0);
    const Bytes type{'I', 'D', 'A', 'T'};
    const auto data = std::ranges::search(whole, type).begin() - whole.begin();
    // The bytes of the length before the chunk's type, and the last one of its checksum.
    for (const long at : {data - 4, data - 3, data - 2, data - 1, long(whole.size()) - 13}) {
      for (const std::uint8_t change : Bytes{1, 0x7f, 0xff}) {
        Bytes wrong = whole;
        wrong[static_cast<std::size_t>(at)] ^= change;
        EXPECT_FALSE(isPicture(wrong, header)) << at - data;
      }
    }
  }
}

/// Packs bits as deflate does, the lowest bit of a byte first.
class Bits {
 public:
  void put(unsigned bits, int count) {
    for (int i = 0; i < count; ++i, ++size_) {
      if (size_ % 8 == 0) bytes_.push_back(0);
      bytes_.back() |= static_cast<std::uint8_t>((bits >> i & 1U) << size_ % 8);
    }
  }
  const Bytes& bytes() const { return bytes_; }

 private:
  Bytes bytes_;
  std::size_t size_ = 0;
};

/// Returns a zlib stream that unpacks to `runs` times 258 zeros, and one.
Bytes bomb(unsigned runs) {
  Bits bits;
  bits.put(0x0178, 16);      // zlib's header
  bits.put(0b011, 3);        // One block of fixed codes:
  bits.put(0b0000'1100, 8);  // a zero,
  for (unsigned i = 0; i < runs; ++i) bits.put(0b0'0000'1010'0011, 13);  // 258 like it,
  bits.put(0, 7);                                                        // the end.
  Bytes bytes = bits.bytes();
  const unsigned sum = (258 * runs + 1) % 65521;  // Adler's
  for (const unsigned byte : {sum >> 8, sum, 0U, 1U}) {
    bytes.push_back(static_cast<std::uint8_t>(byte));
  }
  return bytes;
}

/// Returns the most memory that this process has used. [bytes]
double peakMemory() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return 1024. * static_cast<double>(usage.ru_maxrss);
}

TEST(HostilePng, BombsTakeNoMemory) {
  const Bytes packed = bomb(1 << 19);  // 0.85 MB that unpack to 135 MB.
  const Header header{16, 16, 8, ColourType::Rgba};
  const Bytes rows = rowsOf(header, 0);
  Bytes text{'a', 0, 0};
  text.insert(text.end(), packed.begin(), packed.end());
  const std::vector<Bytes> files{
      pngFile(header, rows, chunk("zTXt", text)), pngFile(header, rows, chunk("iCCP", text)),
      joined({signature(), headerChunk(header), chunk("IDAT", packed), chunk("IEND", {})})};
  const double before = peakMemory();
  for (const Bytes& file : files) EXPECT_TRUE(isPicture(file, header));
  EXPECT_LT(peakMemory() - before, 20e6);  // Measured 0.14e6.
}

}  // namespace
}  // namespace rotatebook::image
