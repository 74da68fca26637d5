#include "system/file_checksum.h"

#include <fmt/core.h>

#include "base/checksum.h"
#include "base/error.h"
#include "system/file_descriptor.h"
#include "system/read_file.h"

namespace rotatebook::system {

std::string checksumOfFile(const std::filesystem::path& path) try {
  Checksum sum;
  if (!readBlocks(openFile(path), [&](std::string_view block) { sum.add(block); })) {
    throwLastError(path, "read");
  }
  return sum.text();
} catch (const InputError& error) {
  throw MachineError(fmt::format("can't read {}: {}", path.string(), error.what()));
}

}  // namespace rotatebook::system
