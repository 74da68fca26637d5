// PNG in, with the chunks' checksums mended first: few inputs would get past them.
#include <vector>
#include <zlib.h>

#include "fuzz/decoded_picture.h"
#include "image/png_file.h"

namespace rotatebook::fuzzing {
namespace {

constexpr std::size_t kSignature = 8;
constexpr std::size_t kWord = 4;

std::size_t wordAt(const std::vector<std::uint8_t>& bytes, std::size_t at) {
  std::size_t word = 0;
  for (std::size_t i = 0; i < kWord; ++i) word = word << 8 | bytes[at + i];
  return word;
}

void putWord(std::vector<std::uint8_t>& bytes, std::size_t at, std::size_t word) {
  for (std::size_t i = 0; i < kWord; ++i) {
    bytes[at + i] = static_cast<std::uint8_t>(word >> (8 * (kWord - 1 - i)));
  }
}

/// Length, type, content, checksum of type and content: as far as the lengths lead.
void mendChecksums(std::vector<std::uint8_t>& bytes) {
  for (std::size_t at = kSignature; at + 3 * kWord <= bytes.size();) {
    const std::size_t length = wordAt(bytes, at);
    if (length > bytes.size() - at - 3 * kWord) return;
    const std::size_t end = at + 2 * kWord + length;
    const auto* named = bytes.data() + at + kWord;
    putWord(bytes, end, crc32(0, named, static_cast<uInt>(kWord + length)));
    at = end + kWord;
  }
}

}  // namespace
}  // namespace rotatebook::fuzzing

int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  using namespace rotatebook;
  std::vector<std::uint8_t> file(bytes, bytes + size);
  fuzzing::mendChecksums(file);
  fuzzing::requireWholeOrRefused([&] { return image::decodePng(file, "a.png"); });
  return 0;
}
