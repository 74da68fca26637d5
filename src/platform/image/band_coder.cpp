#include "image/band_coder.h"

#include <algorithm>
#include <isa-l.h>
#include <stdexcept>

namespace rotatebook::image {
namespace {

constexpr int kLevel = 1;

// ISA-L 2.30 looks a stream's third byte up by a number made of the stream's address in memory, so
// that one time in some thousand other matches are found. Not if one byte comes before the others:
// the first beyond those that it keeps back for the next call, more of them where no flush follows.
constexpr std::size_t kHead = ISAL_LOOK_AHEAD + 1, kFlushedHead = 16 + 1;

/// More than `size` bytes take: stored, with heads of blocks twice as many as need be, and two
/// empty blocks.
std::size_t packedBound(std::size_t size) {
  constexpr std::size_t kBlock = 32'768, kHeads = 10, kRest = 128;
  return size + (size / kBlock + 1) * kHeads + kRest;
}

void give(isal_zstream& stream, std::span<const std::uint8_t> bytes, std::uint16_t flush) {
  stream.next_in = const_cast<std::uint8_t*>(bytes.data());  // It is only read.
  stream.avail_in = static_cast<std::uint32_t>(bytes.size());
  stream.flush = flush;
  if (isal_deflate(&stream) != COMP_OK || stream.avail_in != 0 || stream.avail_out == 0) {
    throw std::logic_error("igzip had no room for a band of a picture");
  }
}

}  // namespace

BandCoder::BandCoder() : workspace_(ISAL_DEF_LVL1_DEFAULT) {}

void BandCoder::pack(std::span<const std::uint8_t> bytes, std::vector<std::uint8_t>& packed) {
  packed.resize(packedBound(bytes.size()));
  isal_zstream stream;
  isal_deflate_init(&stream);
  stream.level = kLevel;
  stream.level_buf = workspace_.data();
  stream.level_buf_size = static_cast<std::uint32_t>(workspace_.size());
  stream.next_out = packed.data();
  stream.avail_out = static_cast<std::uint32_t>(packed.size());
  const bool isLong = bytes.size() > kHead;
  const std::size_t head = isLong ? kHead : std::min(bytes.size(), kFlushedHead);
  give(stream, bytes.first(head), isLong ? NO_FLUSH : SYNC_FLUSH);
  give(stream, bytes.subspan(head), FULL_FLUSH);
  packed.resize(stream.total_out);
}

}  // namespace rotatebook::image
