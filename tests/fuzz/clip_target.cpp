// A clip's metadata: any bytes are refused, or tell what the clip says of itself.
#include <span>

#include "fuzz/fuzzing.h"
#include "video/clip_reader.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  using namespace rotatebook;
  fuzzing::mayRefuse([&] { video::readClipMetadata(std::span(bytes, size), "clip"); });
  return 0;
}
