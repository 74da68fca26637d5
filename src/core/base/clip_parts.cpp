#include "base/clip_parts.h"

#include <array>
#include <bit>
#include <charconv>

namespace rotatebook {
namespace {

/// Takes from `bytes` the number of one to eight that they begin with; nothing if there is none.
std::string_view takeNumber(std::string_view& bytes) {
  const auto first = static_cast<std::uint8_t>(bytes.empty() ? 0 : bytes.front());
  const auto length = static_cast<std::size_t>(std::countl_zero(first)) + 1;
  if (first == 0 || length > bytes.size()) return {};
  const std::string_view number = bytes.substr(0, length);
  bytes.remove_prefix(length);
  return number;
}

}  // namespace

bool beginsAsMp4(std::string_view bytes) {
  return bytes.size() >= 8 && bytes.substr(4, 4) == "ftyp";
}

bool beginsAsWebm(std::string_view bytes) {
  return bytes.starts_with("\x1a\x45\xdf\xa3");
}

std::optional<Part> mp4Box(std::string_view bytes, std::uint64_t at, std::uint64_t end) {
  constexpr std::uint64_t kHead = 8;  // Of a box's size and type fields. [bytes]
  if (at > end || end - at < kHead || bytes.size() < kHead) return std::nullopt;
  std::uint64_t size = bigEndian(bytes.substr(0, 4)), begin = kHead;
  if (size == 1) {
    size = bigEndian(bytes.substr(kHead, kHead));
    begin = kMaxHead;
  }
  if (size == 0) size = end - at;  // The last box may omit its size.
  constexpr std::uint64_t kMax = std::uint64_t{1} << 62;
  if (size < begin || size > kMax) return std::nullopt;
  return Part{std::string(bytes.substr(4, 4)), at, at + begin, at + size};
}

std::optional<Part> webmElement(std::string_view bytes, std::uint64_t at, std::uint64_t end) {
  const std::string_view id = takeNumber(bytes), size = takeNumber(bytes);
  if (at >= end || size.empty()) return std::nullopt;
  const std::uint64_t mask = (std::uint64_t{1} << (7 * size.size())) - 1;
  const std::uint64_t length = bigEndian(size) & mask, content = at + id.size() + size.size();
  return Part{webmId(id), at, content, length == mask ? kUnknownEnd : content + length};
}

std::uint64_t bigEndian(std::string_view bytes) {
  std::uint64_t value = 0;
  for (const char byte : bytes) value = value << 8 | static_cast<unsigned char>(byte);
  return value;
}

std::string webmId(std::string_view bytes) {
  std::array<char, 16> digits{};
  const auto [end, error] =
      std::to_chars(digits.data(), digits.data() + digits.size(), bigEndian(bytes), 16);
  return {digits.data(), end};
}

}  // namespace rotatebook
