// Units of H.264 (ITU-T H.264).
#include <algorithm>
#include <array>
#include <cstddef>
#include <string_view>
#include <vector>

#include "video/bit_reader.h"
#include "video/coded_units.h"

namespace rotatebook::video {
namespace {

// Types of NAL units (table 7-1), and the lowest bits of their first byte that hold it.
constexpr int kSlice = 1, kKeySlice = 5, kMessage = 6, kSequence = 7, kPicture = 8;
constexpr int kTypeBits = 0x1f;
constexpr int kForbiddenBit = 0x80;

int typeOf(Bytes unit) {
  return unit.empty() || (unit[0] & kForbiddenBit) != 0 ? -1 : unit[0] & kTypeBits;
}

std::string unitText(Bytes unit) {
  return "a NAL unit of type " + std::to_string(typeOf(unit));
}

/// Returns whether bytes follow each other that no unit may hold (7.4.1): some decoders would take
/// what comes then for another unit.
bool hidesUnit(Bytes unit) {
  constexpr int kEscape = 3;
  for (std::size_t i = 2; i < unit.size(); ++i) {
    if (unit[i - 2] == 0 && unit[i - 1] == 0 && unit[i] < kEscape) return true;
  }
  return false;
}

/// Returns the unit's payload without the bytes that keep it from looking like another one.
std::vector<std::uint8_t> payloadOf(Bytes unit) {
  constexpr int kEscape = 3;
  std::vector<std::uint8_t> bytes;
  int zeros = 0;
  for (const std::uint8_t byte : unit.subspan(std::min<std::size_t>(unit.size(), 1))) {
    const bool isEscape = zeros >= 2 && byte == kEscape;
    zeros = byte == 0 ? zeros + 1 : 0;
    if (!isEscape) bytes.push_back(byte);
  }
  return bytes;
}

/// Takes a number of `size` bytes and as many bytes as it says from the front of `rest`.
Bytes takeUnit(Bytes& rest, std::size_t size) {
  std::size_t length = 0;
  for (std::size_t i = 0; i < std::min(size, rest.size()); ++i) length = length << 8 | rest[i];
  const std::size_t begin = std::min(size, rest.size());
  const Bytes unit = rest.subspan(begin, std::min(length, rest.size() - begin));
  rest = rest.subspan(begin + unit.size());
  return unit.size() == length ? unit : Bytes{};
}

/// Reads what a sequence says of its display (E.1.1); returns whether libx264 says so.
bool isPlainDisplay(BitReader& in, const WrittenForm& form) {
  constexpr std::uint32_t kSquare = 1, kUnspecified = 5, kBt709 = 1;
  if (!in.flag() || in.bits(8) != kSquare) return false;
  if (in.flag()) return false;  // Overscan.
  if (!in.flag() || in.bits(3) != kUnspecified || in.flag() || !in.flag()) return false;
  for (int i = 0; i < 3; ++i) {
    if (in.bits(8) != kBt709) return false;
  }
  if (in.flag() && (in.golomb() != 0 || in.golomb() != 0))
    return false;  // Chroma isn't at the left.
  if (!in.flag()) return false;
  const std::uint64_t unit = in.bits(32), scale = in.bits(32);
  const auto rate = static_cast<std::uint64_t>(form.frameRate.numerator);
  if (scale * static_cast<std::uint64_t>(form.frameRate.denominator) != 2 * rate * unit)
    return false;
  in.flag();  // Whether the rate is fixed.
  // Buffers, whose limits are stated for transmission, and fields.
  if (in.flag() || in.flag() || in.flag()) return false;
  constexpr int kLimits = 6;  // Of vectors and of pictures that wait.
  if (in.flag()) {
    in.flag();
    for (int i = 0; i < kLimits; ++i) in.golomb();
  }
  return in.isAtEnd();
}

/// Returns whether the pixels that are cut off, in steps of two, only fill up macroblocks.
bool isPlainSize(BitReader& in, const WrittenForm& form) {
  constexpr std::uint32_t kMacroblock = 16;
  const std::uint32_t width = kMacroblock * (in.golomb() + 1);
  const std::uint32_t height = kMacroblock * (in.golomb() + 1);
  if (!in.flag()) return false;  // Fields.
  in.flag();
  std::array<std::uint32_t, 4> crop{};  // At left, right, top and bottom.
  if (in.flag()) {
    for (std::uint32_t& side : crop) side = 2 * in.golomb();
  }
  return crop[0] == 0 && crop[2] == 0 &&
         width - crop[1] == static_cast<std::uint32_t>(form.width) &&
         height - crop[3] == static_cast<std::uint32_t>(form.height);
}

/// Returns whether a sequence's parameters (7.3.2.1.1) are as libx264 writes them.
bool isPlainSequence(Bytes unit, const WrittenForm& form) {
  const std::vector<std::uint8_t> bytes = payloadOf(unit);
  BitReader in(bytes);
  in.bits(24);  // Profile and level, which the container repeats.
  constexpr std::uint32_t kColour420 = 1;
  if (in.golomb() != 0 || in.golomb() != kColour420) return false;
  if (in.golomb() != 0 || in.golomb() != 0 || in.flag() || in.flag()) return false;
  in.golomb();
  const std::uint32_t order = in.golomb();
  if (order == 0) in.golomb();
  if (order == 1) return false;
  in.golomb();
  if (in.flag()) return false;  // Gaps between pictures.
  return isPlainSize(in, form) && in.flag() && isPlainDisplay(in, form);
}

/// Returns whether a picture's parameters (7.3.2.2) ask for no redundant or scattered slices.
bool isPlainPicture(Bytes unit) {
  const std::vector<std::uint8_t> bytes = payloadOf(unit);
  BitReader in(bytes);
  if (in.golomb() != 0 || in.golomb() != 0) return false;
  in.bits(2);
  if (in.golomb() != 0) return false;
  in.golomb(), in.golomb();
  in.bits(3);
  in.golomb(), in.golomb(), in.golomb();
  in.bits(2);
  return !in.flag();
}

/// Returns whether a unit is a single message: libx264's version and settings.
bool isNote(Bytes unit) {
  constexpr std::array<std::uint8_t, 16> kX264{0xdc, 0x45, 0xe9, 0xbd, 0xe6, 0xd9, 0x48, 0xb7,
                                               0x96, 0x2c, 0xd8, 0x20, 0xd9, 0x23, 0xee, 0xef};
  constexpr std::uint8_t kOwnData = 5, kEnd = 0x80;
  const std::vector<std::uint8_t> bytes = payloadOf(unit);
  std::size_t at = 1, length = 0;
  if (bytes.empty() || bytes[0] != kOwnData) return false;
  for (; at < bytes.size() && bytes[at] == 0xff; ++at) length += 0xff;
  if (at >= bytes.size()) return false;
  length += bytes[at++];
  if (length < kX264.size() || bytes.size() != at + length + 1 || bytes.back() != kEnd)
    return false;
  return std::equal(kX264.begin(), kX264.end(), bytes.begin() + static_cast<std::ptrdiff_t>(at));
}

/// Returns whether a slice begins a picture (7.3.3), and is of the only parameters.
bool isWholePicture(Bytes unit) {
  constexpr std::size_t kHead = 16;
  const std::vector<std::uint8_t> bytes = payloadOf(unit.first(std::min(unit.size(), kHead)));
  BitReader in(bytes);
  if (in.golomb() != 0) return false;
  in.golomb();
  return in.golomb() == 0;
}

}  // namespace

std::string h264Difference(Bytes parameters, const WrittenForm& form) {
  constexpr std::array<std::uint8_t, 4> kHighEnd{0xfd, 0xf8, 0xf8, 0};  // 4:2:0, 8 bits, no more.
  constexpr std::size_t kHead = 6;
  if (parameters.size() < kHead) return "the stream lacks parameters";
  Bytes rest = parameters.subspan(kHead);
  const Bytes sequence = takeUnit(rest, 2);
  const bool isOne = !rest.empty() && rest[0] == 1;
  rest = rest.subspan(std::min<std::size_t>(rest.size(), 1));
  const Bytes picture = takeUnit(rest, 2);
  // Version, profile and level, sizes of four bytes, one sequence.
  const bool isHead = sequence.size() > 3 && parameters[0] == 1 &&
                      std::ranges::equal(parameters.subspan(1, 3), sequence.subspan(1, 3)) &&
                      parameters[4] == 0xff && parameters[5] == 0xe1;
  if (!isHead || !isOne || !std::ranges::equal(rest, kHighEnd)) return "the stream's head differs";
  if (typeOf(sequence) != kSequence || hidesUnit(sequence) || !isPlainSequence(sequence, form))
    return "the sequence's parameters differ";
  if (typeOf(picture) != kPicture || hidesUnit(picture) || !isPlainPicture(picture))
    return "the pictures' parameters differ";
  return "";
}

CodedPicture h264Picture(Bytes packet, bool first) {
  Bytes rest = packet;
  Bytes unit = takeUnit(rest, 4);
  if (typeOf(unit) == kMessage && first) {
    if (!isNote(unit) || hidesUnit(unit)) return {.difference = "a foreign message"};
    unit = takeUnit(rest, 4);
  }
  const int type = typeOf(unit);
  CodedPicture picture{.isKey = type == kKeySlice};
  if (type != kSlice && type != kKeySlice) {
    picture.difference = unitText(unit);
  } else if (!rest.empty()) {
    picture.difference = unitText(takeUnit(rest, 4)) + " after its slice";
  } else if (!isWholePicture(unit) || hidesUnit(unit)) {
    picture.difference = "a slice that isn't a whole picture";
  }
  return picture;
}

}  // namespace rotatebook::video
