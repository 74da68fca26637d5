#include "picture/interchange/aligned_zip.h"

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "system/zip_archive.h"

namespace rotatebook::interchange {

std::string alignedZip(const std::vector<NamedBytes>& files) {
  constexpr std::size_t kAlignment = 64, kHead = 30, kFieldHead = 4;
  constexpr std::uint16_t kPadding = 0x1986;  // What USD's own archives call it.
  system::MemoryZip archive("can't make an archive");
  std::size_t end = 0;  // Of the file before.
  for (const NamedBytes& file : files) {
    const std::size_t begin = end + kHead + file.name.size() + kFieldHead;
    const std::string padding((kAlignment - begin % kAlignment) % kAlignment, '\0');
    archive.addBytes(file.bytes, file.name, kPadding, padding);
    end = begin + padding.size() + file.bytes.size();
  }
  std::string bytes;
  archive.finish([&](std::string_view piece) { bytes += piece; });
  return bytes;
}

}  // namespace rotatebook::interchange
