// Deflate for parts of a stream that are compressed separately. Inside the room only.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace rotatebook::image {

/// Compresses with ISA-L's igzip, level 1.
class BandCoder {
 public:
  BandCoder();

  /// Replaces `packed` by deflate blocks (RFC 1951) that depend on `bytes` alone, end on a byte
  /// boundary, and don't include the stream's last, so that they can be joined with others.
  void pack(std::span<const std::uint8_t> bytes, std::vector<std::uint8_t>& packed);

 private:
  std::vector<std::uint8_t> workspace_, room_;
};

}  // namespace rotatebook::image
