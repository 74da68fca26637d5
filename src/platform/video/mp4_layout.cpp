#include "video/mp4_layout.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <limits>
#include <numeric>

#include "base/clip_parts.h"
#include "video/layout.h"
#include "video/mp4_chapters.h"

namespace rotatebook::video {
namespace {

/// All boxes in their order, with all their fields; all but chpl are the muxer's. Measured on
/// libavformat 59.27 and 62.19, which write the same but for the duration in mdhd; of 62.19, the
/// tables of samples and btrt are as its source has them.
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
    LayoutRow{3, "mdhd", 1, 1, "00000000 zero:8 media_clock:4 media_length 55c4 0000"},
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
    LayoutRow{7, "btrt", 0, 1, "00000000 rates"},
    LayoutRow{5, "stts", 1, 1, "00000000 00000001 frames:4 tick:4"},
    LayoutRow{5, "stss", 0, 1, "00000000 keys"},
    LayoutRow{5, "ctts", 0, 1, "00000000 delays"},
    LayoutRow{5, "stsc", 1, 1, "00000000 chunk_sizes"},
    LayoutRow{5, "stsz", 1, 1, "00000000 sizes"},
    LayoutRow{5, "stco", 0, 1, "00000000 chunks"},
    LayoutRow{5, "co64", 0, 1, "00000000 long_chunks"},
    LayoutRow{1, "udta"},
    LayoutRow{2, "meta", 1, 1, "00000000"},
    LayoutRow{3, "hdlr", 1, 1, "zero:8 6d646972 6170706c zero:9"},
    LayoutRow{3, "ilst"},
    LayoutRow{4, "\251nam", 0, 1, "", "title"},
    LayoutRow{5, "data", 1, 1, "00000001 00000000 title"},
    LayoutRow{4, "\251cmt", 1, 1, "", "comment"},
    LayoutRow{5, "data", 1, 1, "00000001 00000000 comment"},
    LayoutRow{2, "chpl", 0, 1, "chapters"},
    LayoutRow{0, "free", 0, 1, ""},  // None where the pictures have 4 GB.
    LayoutRow{0, "mdat", 1, 1, "payload"}};

/// The identity, as boxes state matrices.
std::string identity() {
  std::string bytes(36, '\0');
  bytes[1] = bytes[17] = 1;
  bytes[32] = 0x40;
  return bytes;
}

std::string fourBytes(std::uint64_t number) {
  return bigEndianBytes(number, 4);
}

/// Returns the count and the numbers, from 1, of all key frames.
std::string keysOf(const Payload& payload) {
  std::string numbers;
  for (const std::size_t key : payload.keys) numbers += fourBytes(key + 1);
  return fourBytes(payload.keys.size()) + numbers;
}

/// Returns the size of all samples or 0, their count and, where they differ, each one's size.
std::string sizesOf(const Payload& payload) {
  const std::vector<std::uint64_t>& all = payload.sizes;
  const bool areEqual = std::ranges::adjacent_find(all, std::ranges::not_equal_to()) == all.end();
  std::string sizes;
  for (std::size_t i = 0; i < all.size() && !areEqual; ++i) sizes += fourBytes(all[i]);
  return fourBytes(areEqual && !all.empty() ? all[0] : 0) + fourBytes(all.size()) + sizes;
}

/// Returns the count of runs of equal numbers, and each run's length and number.
std::string runsOf(const std::vector<std::uint64_t>& numbers) {
  std::string runs;
  std::size_t count = 0;
  for (std::size_t first = 0, end = 0; first < numbers.size(); first = end, ++count) {
    while (end < numbers.size() && numbers[end] == numbers[first]) ++end;
    runs += fourBytes(end - first) + fourBytes(numbers[first]);
  }
  return fourBytes(count) + runs;
}

/// A run of samples that the file states the place of.
struct Chunk {
  std::uint64_t offset = 0;  ///< From the first sample on. [bytes]
  std::uint64_t samples = 0;
};

/// Returns the chunks in which the muxer lays samples one after the other.
std::vector<Chunk> chunksOf(const Payload& payload) {
  constexpr std::uint64_t kEnd = 1 << 20;  // Of a chunk's size. [bytes]
  std::vector<Chunk> chunks;
  std::uint64_t offset = 0;
  for (const std::uint64_t size : payload.sizes) {
    const bool isNew = chunks.empty() || offset + size - chunks.back().offset >= kEnd;
    if (isNew) chunks.push_back({.offset = offset});
    ++chunks.back().samples;
    offset += size;
  }
  return chunks;
}

/// Returns the count of runs of chunks of as many samples, and each run's first chunk and samples.
std::string chunkSizesOf(const std::vector<Chunk>& chunks) {
  std::string runs;
  std::size_t count = 0;
  for (std::size_t i = 0; i < chunks.size(); ++i) {
    if (i > 0 && chunks[i].samples == chunks[i - 1].samples) continue;
    runs += fourBytes(i + 1) + fourBytes(chunks[i].samples) + fourBytes(1);
    ++count;
  }
  return fourBytes(count) + runs;
}

/// Returns the count and the offsets in the file of all chunks.
std::string placesOf(const std::vector<Chunk>& chunks, std::uint64_t begin, int bytes) {
  std::string places = fourBytes(chunks.size());
  for (const Chunk& chunk : chunks) places += bigEndianBytes(begin + chunk.offset, bytes);
  return places;
}

/// Returns the largest and the mean rate of bits, where newer muxers state no mean.
std::vector<std::string> ratesOf(std::uint64_t size, std::uint64_t clock, std::uint64_t length) {
  const std::string rate = fourBytes(8 * size * clock / std::max<std::uint64_t>(length, 1));
  return {rate + rate, rate + fourBytes(0)};
}

/// Returns the offset of the first sample. [bytes]
std::uint64_t beginOfSamples(std::istream& file) {
  std::optional<Part> box = partAt(file, mp4Box, 0, sizeOf(file));
  while (box && box->id != "mdat") box = partAt(file, mp4Box, box->end, sizeOf(file));
  return box ? box->content : 0;
}

LayoutValues valuesOf(const WrittenForm& form, const Payload& payload, std::uint64_t begin) {
  constexpr std::uint64_t kFinestClock = 10'000;  // The muxer doubles coarser ones.
  const auto rate = static_cast<std::uint64_t>(form.frameRate.numerator);
  auto tick = static_cast<std::uint64_t>(form.frameRate.denominator);
  const auto frames = static_cast<std::uint64_t>(form.frames);
  const std::uint64_t length = frames * tick;
  std::uint64_t clock = rate;
  for (; clock < kFinestClock; clock *= 2) tick *= 2;
  const std::uint64_t delay = payload.delays.empty() ? 0 : payload.delays.front();
  const std::uint64_t size = std::accumulate(payload.sizes.begin(), payload.sizes.end(), 0ULL);
  const std::vector<Chunk> chunks = chunksOf(payload);
  const auto only = [](std::uint64_t value) { return LayoutValues::Range{value, value}; };
  return {.numbers = {{"clock", only(rate)},
                      {"length", only(length)},
                      {"media_clock", only(clock)},
                      {"tick", only(tick)},
                      {"delay", only(delay)},
                      {"frames", only(frames)},
                      {"width", only(static_cast<std::uint64_t>(form.width))},
                      {"height", only(static_cast<std::uint64_t>(form.height))},
                      {"payload", only(size)}},
          .texts = {{"matrix", {identity()}},
                    {"keys", {keysOf(payload)}},
                    // Newer muxers count the delay.
                    {"media_length", {fourBytes(frames * tick), fourBytes(frames * tick + delay)}},
                    {"rates", ratesOf(size, clock, frames * tick)},
                    {"delays", {runsOf(payload.delays)}},
                    {"sizes", {sizesOf(payload)}},
                    {"chunk_sizes", {chunkSizesOf(chunks)}},
                    {"chunks", {placesOf(chunks, begin, 4)}},
                    {"long_chunks", {placesOf(chunks, begin, 8)}},
                    {"title", {payload.title}},
                    {"comment", {payload.comment}},
                    {"chapters", {chapterList(form.chapters, form.frameRate)}}}};
}

/// Like mp4Box(); nothing if the box doesn't state its size as the muxer does.
std::optional<Part> writtenBox(std::string_view bytes, std::uint64_t at, std::uint64_t end) {
  const std::optional<Part> box = mp4Box(bytes, at, end);
  if (!box) return box;
  const std::uint64_t size = box->end - box->start;
  const bool isLong = size > std::numeric_limits<std::uint32_t>::max();
  return bigEndian(bytes.substr(0, 4)) == (isLong ? 1 : size) ? box : std::nullopt;
}

}  // namespace

std::string mp4Difference(std::istream& file, const WrittenForm& form, const Payload& payload) {
  std::array rows = kMp4Rows;
  const auto demand = [&](std::string_view id, bool isThere) {
    LayoutRow& row = *std::ranges::find(rows, id, &LayoutRow::id);
    row.min = row.max = isThere ? 1 : 0;
  };
  // The muxer lists key frames where not all frames are, and delays where there are some.
  demand("stss", payload.keys.size() < payload.sizes.size());
  demand("ctts", std::ranges::any_of(payload.delays, [](auto delay) { return delay > 0; }));
  demand("chpl", !form.chapters.empty());
  const LayoutValues values = valuesOf(form, payload, beginOfSamples(file));
  return differenceFrom(rows, values, file, writtenBox, PartOrder::AsRows);
}

}  // namespace rotatebook::video
