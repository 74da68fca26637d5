// Archives whose files can be read in place. Inside the room only.
#pragma once

#include <string>
#include <vector>

namespace rotatebook::interchange {

/// A file in an archive.
struct NamedBytes {
  std::string name, bytes;
};

/// Returns a ZIP of files, uncompressed, each of which begins at a multiple of 64 bytes, as USDZ
/// wants it. Throws MachineError if libzip fails.
std::string alignedZip(const std::vector<NamedBytes>& files);

}  // namespace rotatebook::interchange
