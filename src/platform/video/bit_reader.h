// Reads coded headers bit by bit. Inside the room only.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace rotatebook::video {

class BitReader {
 public:
  explicit BitReader(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

  /// Returns the next `count` bits, at most 32, as a number; zeros beyond the end.
  std::uint32_t bits(int count) {
    std::uint32_t value = 0;
    for (int i = 0; i < count; ++i, ++at_) {
      const bool isInside = at_ / 8 < bytes_.size();
      value = value << 1 | (isInside ? bytes_[at_ / 8] >> (7 - at_ % 8) & 1U : 0U);
    }
    return value;
  }
  bool flag() { return bits(1) != 0; }

  /// Returns the next number in H.264's ue(v), ITU-T H.264, 9.1; that of se(v) needs as many bits.
  std::uint32_t golomb() {
    int zeros = 0;
    while (zeros < 31 && bits(1) == 0) ++zeros;
    return (1U << zeros) - 1 + bits(zeros);
  }

  /// Returns whether nothing is left but a one and zeros up to the end of the byte: H.264's
  /// rbsp_trailing_bits.
  bool isAtEnd() {
    if (bits(1) != 1) return false;
    while (at_ % 8 != 0) {
      if (bits(1) != 0) return false;
    }
    return at_ / 8 == bytes_.size();
  }

 private:
  std::span<const std::uint8_t> bytes_;
  std::size_t at_ = 0;  // [bits]
};

}  // namespace rotatebook::video
