// Frames of VP9 (VP9 Bitstream & Decoding Process Specification 0.6).
#include <array>
#include <cstddef>
#include <string_view>

#include "video/bit_reader.h"
#include "video/coded_units.h"

namespace rotatebook::video {
namespace {

/// A frame's header (7.2), as far as players obey it.
struct Vp9Frame {
  bool isKey = false;
  bool isShown = false;
  bool isPlain = true;  ///< Of the clip's size and colours.
};

constexpr std::uint32_t kSyncCode = 0x498342;

/// Reads a size, and whether players are to show another.
bool isOfSize(BitReader& in, const WrittenForm& form) {
  const std::uint32_t width = in.bits(16) + 1, height = in.bits(16) + 1;
  return width == static_cast<std::uint32_t>(form.width) &&
         height == static_cast<std::uint32_t>(form.height);
}

bool isPlainKey(BitReader& in, const WrittenForm& form) {
  constexpr std::uint32_t kBt709 = 2;
  if (in.bits(24) != kSyncCode || in.bits(3) != kBt709 || in.flag()) return false;
  return isOfSize(in, form) && !in.flag();
}

/// Reads on in a frame that refers to others, or isn't shown and has no more colours than they.
bool isPlainInter(BitReader& in, const WrittenForm& form, bool isShown, bool isResilient) {
  constexpr int kReferences = 3;
  const bool isIntra = !isShown && in.flag();
  if (!isResilient) in.bits(2);
  if (isIntra) {
    if (in.bits(24) != kSyncCode) return false;
    in.bits(8);
    return isOfSize(in, form) && !in.flag();
  }
  in.bits(8);
  for (int i = 0; i < kReferences; ++i) in.bits(4);
  bool isFound = false;  // The size is a reference's.
  for (int i = 0; i < kReferences && !isFound; ++i) isFound = in.flag();
  return (isFound || isOfSize(in, form)) && !in.flag();
}

Vp9Frame frameOf(Bytes bytes, const WrittenForm& form) {
  constexpr std::uint32_t kMarker = 2;
  BitReader in(bytes);
  // The marker, and profile 0.
  if (in.bits(2) != kMarker || in.bits(2) != 0) return {.isPlain = false};
  if (in.flag()) return {.isShown = true, .isPlain = bytes.size() == 1};  // One that is decoded.
  Vp9Frame frame{.isKey = !in.flag()};
  frame.isShown = in.flag();
  const bool isResilient = in.flag();
  frame.isPlain =
      frame.isKey ? isPlainKey(in, form) : isPlainInter(in, form, frame.isShown, isResilient);
  return frame;
}

}  // namespace

CodedPicture vp9Picture(Bytes packet, const WrittenForm& form) {
  if (packet.empty()) return {.difference = "no frame"};
  // A superframe ends with an index of the sizes of its frames (annex B).
  const std::uint8_t last = packet.back();
  const bool isSuperframe = (last & 0xe0) == 0xc0;
  const std::size_t frames = isSuperframe ? (last & 7U) + 1 : 1, width = (last >> 3 & 3U) + 1;
  const std::size_t index = isSuperframe ? 2 + frames * width : 0;
  if (index > packet.size() || (isSuperframe && packet[packet.size() - index] != last))
    return {.difference = "a damaged index of frames"};
  Bytes rest = packet.first(packet.size() - index);
  CodedPicture picture;
  for (std::size_t i = 0; i < frames; ++i) {
    std::size_t size = isSuperframe ? 0 : rest.size();
    for (std::size_t j = 0; j < width && isSuperframe; ++j) {
      size |= std::size_t{packet[packet.size() - index + 1 + i * width + j]} << (8 * j);
    }
    if (size > rest.size()) return {.difference = "a damaged index of frames"};
    const Vp9Frame frame = frameOf(rest.first(size), form);
    rest = rest.subspan(size);
    picture.isKey = picture.isKey || frame.isKey;
    if (!frame.isPlain) picture.difference = "a frame that isn't of the clip's size and colours";
    if (frame.isShown != (i + 1 == frames)) picture.difference = "not one frame to show";
  }
  if (!rest.empty()) picture.difference = "bytes in no frame";
  return picture;
}

}  // namespace rotatebook::video
