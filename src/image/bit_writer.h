// Bits in deflate's order. Inside the room only.
#pragma once

#include <bit>
#include <cstdint>
#include <cstring>

namespace rotatebook::image {

/// The eight bytes there, the first one lowest.
inline std::uint64_t loadWord(const std::uint8_t* bytes) {
  std::uint64_t word;
  std::memcpy(&word, bytes, sizeof word);
  return std::endian::native == std::endian::little ? word : __builtin_bswap64(word);
}

inline void storeWord(std::uint8_t* bytes, std::uint64_t word) {
  if (std::endian::native != std::endian::little) word = __builtin_bswap64(word);
  std::memcpy(bytes, &word, sizeof word);
}

/// Writes bits from the lowest of each byte upwards. Up to 8 bytes behind what is written must be
/// there.
class BitWriter {
 public:
  explicit BitWriter(std::uint8_t* out) : out_(out) {}

  /// The lowest `count` bits of `value`, whose other bits are 0. At most 57 without a flush().
  void put(std::uint64_t value, unsigned count) {
    bits_ |= value << held_;
    held_ += count;
  }
  void flush() {
    storeWord(out_, bits_);
    out_ += held_ / 8;
    bits_ >>= held_ & ~7U;
    held_ &= 7U;
  }
  /// Fills the last byte with zeros; returns where the next one goes.
  std::uint8_t* finishByte() {
    held_ = (held_ + 7) & ~7U;
    flush();
    return out_;
  }

 private:
  std::uint8_t* out_;
  std::uint64_t bits_ = 0;
  unsigned held_ = 0;
};

}  // namespace rotatebook::image
