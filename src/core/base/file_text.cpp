#include "base/file_text.h"

#include "base/text.h"

namespace rotatebook {
namespace {

void appendUtf8(std::string& text, char32_t code) {
  const int rest = code < 0x80 ? 0 : code < 0x800 ? 1 : code < 0x10000 ? 2 : 3;  // bytes
  constexpr unsigned kLeads[] = {0, 0xc0, 0xe0, 0xf0};
  text += static_cast<char>(kLeads[rest] | code >> 6 * rest);
  for (int i = rest - 1; i >= 0; --i) text += static_cast<char>(0x80 | (code >> 6 * i & 0x3f));
}

}  // namespace

std::string_view textOfFile(std::string_view bytes, std::string& decoded) {
  const bool isBigEndian = bytes.starts_with("\xFE\xFF");
  if (!isBigEndian && !bytes.starts_with("\xFF\xFE")) return withoutByteOrderMark(bytes);
  const auto unitAt = [&](std::size_t i) -> char32_t {
    const auto first = static_cast<unsigned char>(bytes[i]);
    const auto second = static_cast<unsigned char>(bytes[i + 1]);
    return isBigEndian ? first << 8 | second : second << 8 | first;
  };
  const auto isHalf = [](char32_t unit, char32_t first) { return (unit & 0xfc00) == first; };
  decoded.clear();
  decoded.reserve(bytes.size() / 2);
  for (std::size_t i = 2; i + 1 < bytes.size(); i += 2) {
    char32_t code = unitAt(i);
    const bool hasNext = i + 3 < bytes.size();
    if (isHalf(code, 0xd800) && hasNext && isHalf(unitAt(i + 2), 0xdc00)) {
      i += 2;
      code = 0x10000 + ((code & 0x3ff) << 10 | (unitAt(i) & 0x3ff));
    } else if (isHalf(code, 0xd800) || isHalf(code, 0xdc00)) {
      code = 0xfffd;
    }
    appendUtf8(decoded, code);
  }
  return decoded;
}

}  // namespace rotatebook
