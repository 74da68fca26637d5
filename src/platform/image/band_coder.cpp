#include "image/band_coder.h"

#include <algorithm>
#include <isa-l.h>
#include <stdexcept>

namespace rotatebook::image {
namespace {

constexpr int kLevel = 1;

// ISA-L 2.30 looks up a stream's third byte by a number that depends on the stream's address in
// memory, so that one time in some thousand it finds other matches. It doesn't if one byte is
// packed before the others. For that the first call takes one byte more than ISA-L holds back for
// the next call; it holds back more where no flush follows.
constexpr std::size_t kHead = ISAL_LOOK_AHEAD + 1, kFlushedHead = 16 + 1;

/// Returns more than `size` bytes can take: stored uncompressed, with twice as many block headers
/// as needed, and two empty blocks. [bytes]
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
  room_.resize(std::max(room_.size(), packedBound(bytes.size())));
  isal_zstream stream;
  isal_deflate_init(&stream);
  stream.level = kLevel;
  stream.level_buf = workspace_.data();
  stream.level_buf_size = static_cast<std::uint32_t>(workspace_.size());
  stream.next_out = room_.data();
  stream.avail_out = static_cast<std::uint32_t>(room_.size());
  const bool isLong = bytes.size() > kHead;
  const std::size_t head = isLong ? kHead : std::min(bytes.size(), kFlushedHead);
  give(stream, bytes.first(head), isLong ? NO_FLUSH : SYNC_FLUSH);
  give(stream, bytes.subspan(head), FULL_FLUSH);
  packed.assign(room_.data(), room_.data() + stream.total_out);
}

}  // namespace rotatebook::image
