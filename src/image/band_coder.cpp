#include "image/band_coder.h"

#include <isa-l.h>
#include <stdexcept>

namespace rotatebook::image {
namespace {

constexpr int kLevel = 1;

/// More than `size` bytes take: stored, with heads of blocks twice as many as need be, and an empty
/// block.
std::size_t packedBound(std::size_t size) {
  constexpr std::size_t kBlock = 32'768, kHeads = 10, kRest = 64;
  return size + (size / kBlock + 1) * kHeads + kRest;
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
  stream.flush = FULL_FLUSH;
  stream.next_in = const_cast<std::uint8_t*>(bytes.data());  // It is only read.
  stream.avail_in = static_cast<std::uint32_t>(bytes.size());
  stream.next_out = packed.data();
  stream.avail_out = static_cast<std::uint32_t>(packed.size());
  if (isal_deflate(&stream) != COMP_OK || stream.avail_in != 0 || stream.avail_out == 0) {
    throw std::logic_error("igzip had no room for a band of a picture");
  }
  packed.resize(stream.total_out);
}

}  // namespace rotatebook::image
