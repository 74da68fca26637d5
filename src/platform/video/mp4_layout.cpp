#include "video/mp4_layout.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace rotatebook::video {
namespace {

/// All boxes, with all their fields. Measured on libavformat 59.27 and 62.19, which write the same
/// but for the duration in mdhd.
constexpr std::array kMp4Rows{
    LayoutRow{0, "ftyp", 1, 1, "69736f6d 00000200 69736f6d 69736f32 61766331 6d703431"},
    LayoutRow{0, "moov"},
    LayoutRow{1, "mvhd", 1, 1,
              "00000000 zero:8 clock:4 length:4 00010000 0100 zero:10 matrix zero:24 00000002"},
    LayoutRow{1, "trak"},
    LayoutRow{2, "tkhd", 1, 1,
              "00000003 zero:8 00000001 zero:4 length:4 zero:16 matrix width:2 0000 height:2 "
              "0000"},
    LayoutRow{2, "edts", 0},
    LayoutRow{3, "elst", 1, 1, "00000000 00000001 length:4 delay:4 00010000"},
    LayoutRow{2, "mdia"},
    LayoutRow{3, "mdhd", 1, 1, "00000000 zero:8 media_clock:4 media_length:4 55c4 0000"},
    LayoutRow{3, "hdlr", 1, 1, "zero:8 76696465 zero:12 566964656f48616e646c657200"},
    LayoutRow{3, "minf"},
    LayoutRow{4, "vmhd", 1, 1, "00000001 zero:8"},
    LayoutRow{4, "dinf"},
    LayoutRow{5, "dref", 1, 1, "00000000 00000001"},
    LayoutRow{6, "url ", 1, 1, "00000001"},
    LayoutRow{4, "stbl"},
    LayoutRow{5, "stsd", 1, 1, "00000000 00000001"},
    LayoutRow{6, "avc1", 1, 1,
              "zero:6 0001 zero:16 width:2 height:2 00480000 00480000 00000000 0001 zero:32 0018 "
              "ffff"},
    LayoutRow{7, "avcC", 1, 1, "any"},
    LayoutRow{7, "colr", 1, 1, "6e636c78 0001 0001 0001 00"},
    LayoutRow{7, "pasp", 1, 1, "00000001 00000001"},
    LayoutRow{7, "btrt", 0, 1, "any:12"},
    LayoutRow{5, "stts", 1, 1, "00000000 00000001 frames:4 tick:4"},
    LayoutRow{5, "stss", 0, 1, "00000000 keys"},
    LayoutRow{5, "ctts", 0, 1, "00000000 any:4 ( frame_count:4 delay:4 *"},
    LayoutRow{5, "stsc", 1, 1, "00000000 any:4 ( any:8 00000001 *"},
    LayoutRow{5, "stsz", 1, 1, "00000000 any:4 frames:4 any"},
    LayoutRow{5, "stco", 0, 1, "any"},
    LayoutRow{5, "co64", 0, 1, "any"},
    LayoutRow{1, "udta"},
    LayoutRow{2, "meta", 1, 1, "00000000"},
    LayoutRow{3, "hdlr", 1, 1, "zero:8 6d646972 6170706c zero:9"},
    LayoutRow{3, "ilst"},
    LayoutRow{4, "\251nam", 0, 1, "", "title"},
    LayoutRow{5, "data", 1, 1, "00000001 00000000 any"},
    LayoutRow{4, "\251cmt", 1, 1, "", "comment"},
    LayoutRow{5, "data", 1, 1, "00000001 00000000 any"},
    LayoutRow{0, "free", 0, 1, ""},  // None where the pictures have 4 GB.
    LayoutRow{0, "mdat", 1, 1, "payload"}};

/// The identity, as boxes state matrices.
std::string identity() {
  std::string bytes(36, '\0');
  bytes[1] = bytes[17] = 1;
  bytes[32] = 0x40;
  return bytes;
}

std::string fourBytes(std::size_t number) {
  std::string bytes;
  for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(number >> shift & 0xff);
  return bytes;
}

/// Returns the count and the numbers, from 1, of all key frames.
std::string keysOf(const Payload& payload) {
  std::string numbers;
  for (const std::size_t key : payload.keys) numbers += fourBytes(key + 1);
  return fourBytes(payload.keys.size()) + numbers;
}

LayoutValues valuesOf(const WrittenForm& form, const Payload& payload) {
  constexpr std::uint64_t kFinestClock = 10'000;  // The muxer doubles coarser ones.
  constexpr std::uint64_t kMaxDelay = 16;         // Of frames that are shown later. [frames]
  constexpr std::uint64_t kMaxPadding = 2;        // Newer muxers count a delay. [frames]
  const auto rate = static_cast<std::uint64_t>(form.frameRate.numerator);
  auto tick = static_cast<std::uint64_t>(form.frameRate.denominator);
  const auto frames = static_cast<std::uint64_t>(form.frames);
  const std::uint64_t length = frames * tick;
  std::uint64_t clock = rate;
  for (; clock < kFinestClock; clock *= 2) tick *= 2;
  const auto only = [](std::uint64_t value) { return LayoutValues::Range{value, value}; };
  return {.numbers = {{"clock", only(rate)},
                      {"length", only(length)},
                      {"media_clock", only(clock)},
                      {"media_length", {frames * tick, (frames + kMaxPadding) * tick}},
                      {"tick", only(tick)},
                      {"delay", {0, kMaxDelay * tick}},
                      {"frames", only(frames)},
                      {"frame_count", {1, frames}},
                      {"width", only(static_cast<std::uint64_t>(form.width))},
                      {"height", only(static_cast<std::uint64_t>(form.height))},
                      {"payload", only(payload.size)}},
          .texts = {{"matrix", {identity()}}, {"keys", {keysOf(payload)}}}};
}

}  // namespace

std::optional<Part> mp4BoxAt(std::istream& file, std::uint64_t at, std::uint64_t end) {
  constexpr std::uint64_t kHead = 8;  // Of a box's size and type fields. [bytes]
  if (at > end || end - at < kHead) return std::nullopt;
  const std::string head = bytesAt(file, at, 2 * kHead);
  if (head.size() < kHead) return std::nullopt;
  std::uint64_t size = bigEndian(std::string_view(head).substr(0, 4)), begin = kHead;
  if (size == 1) {
    size = bigEndian(std::string_view(head).substr(kHead));
    begin = 2 * kHead;
  }
  if (size == 0) size = end - at;  // The last box may omit its size.
  constexpr std::uint64_t kMax = std::uint64_t{1} << 62;
  if (size < begin || size > kMax) return std::nullopt;
  return Part{head.substr(4, 4), at, at + begin, at + size};
}

std::string mp4Difference(std::istream& file, const WrittenForm& form, const Payload& payload) {
  std::array rows = kMp4Rows;
  // The muxer lists key frames where not all frames are.
  const bool listsKeys = payload.keys.size() < payload.count;
  LayoutRow& keys = *std::ranges::find(rows, "stss", &LayoutRow::id);
  keys.min = keys.max = listsKeys ? 1 : 0;
  return differenceFrom(rows, valuesOf(form, payload), file, mp4BoxAt);
}

}  // namespace rotatebook::video
