// PNG in, with the chunks' checksums mended first: few inputs would get past them.
#include <functional>
#include <iterator>
#include <string>
#include <vector>
#include <zlib.h>

#include "fuzz/fuzzing.h"
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

// libpng isn't built for the fuzzer, which sees none of its branches: what it complains about tells
// some of them apart.
[[gnu::section("__libfuzzer_extra_counters")]] std::uint8_t complaints[256];

void requireWhole(const image::Image& picture) {
  require(picture.width() > 0 && picture.width() <= kMaxPictureSide);
  require(picture.height() > 0 && picture.height() <= kMaxPictureSide);
  const std::uint8_t* last = picture.row(picture.height() - 1) + picture.stride() - 1;
  require(last - picture.row(0) + 1 == picture.stride() * picture.height());
}

}  // namespace
}  // namespace rotatebook::fuzzing

int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  using namespace rotatebook;
  std::vector<std::uint8_t> file(bytes, bytes + size);
  fuzzing::mendChecksums(file);
  const std::string words =
      fuzzing::mayRefuse([&] { fuzzing::requireWhole(image::decodePng(file, "a.png")); });
  fuzzing::complaints[std::hash<std::string>()(words) % std::size(fuzzing::complaints)] = 1;
  return 0;
}
