#include "system/build_id.h"

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <link.h>
#include <span>
#include <string_view>

#include <fmt/core.h>

#include "system/file_checksum.h"

namespace rotatebook::system {
namespace {

using Bytes = std::span<const unsigned char>;

std::size_t padded(std::size_t size) {
  return (size + 3) / 4 * 4;
}

std::string hexadecimal(Bytes bytes) {
  std::string text;
  for (const unsigned char byte : bytes) text += fmt::format("{:02x}", byte);
  return text;
}

/// Returns the build id among notes of the format ELF; empty if it isn't there.
std::string buildIdOf(Bytes notes) {
  ElfW(Nhdr) head;
  while (notes.size() >= sizeof head) {
    std::memcpy(&head, notes.data(), sizeof head);
    const std::size_t nameEnd = sizeof head + padded(head.n_namesz);
    if (nameEnd + head.n_descsz > notes.size()) return "";
    const bool gnu =
        head.n_namesz == 4 && std::memcmp(notes.data() + sizeof head, ELF_NOTE_GNU, 4) == 0;
    if (gnu && head.n_type == NT_GNU_BUILD_ID) {
      return hexadecimal(notes.subspan(nameEnd, head.n_descsz));
    }
    notes = notes.subspan(std::min(notes.size(), nameEnd + padded(head.n_descsz)));
  }
  return "";
}

/// Writes the build id of the first object, which is the program, to the string at `text`.
int readFirst(dl_phdr_info* object, std::size_t, void* text) {
  auto& id = *static_cast<std::string*>(text);
  for (const ElfW(Phdr) & part : std::span(object->dlpi_phdr, object->dlpi_phnum)) {
    if (part.p_type != PT_NOTE || !id.empty()) continue;
    // The layout of a loaded program: NOLINTNEXTLINE(performance-no-int-to-ptr)
    const auto* begin = reinterpret_cast<const unsigned char*>(object->dlpi_addr + part.p_vaddr);
    id = buildIdOf({begin, part.p_memsz});
  }
  return 1;  // No further objects.
}

std::string readBuildId() {
  std::string id;
  dl_iterate_phdr(readFirst, &id);
  return id.empty() ? checksumOfFile("/proc/self/exe") : id;
}

}  // namespace

const std::string& buildId() {
  static const std::string id = readBuildId();
  return id;
}

}  // namespace rotatebook::system
