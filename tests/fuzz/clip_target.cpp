// A clip's metadata and header: any bytes are refused, or tell what the clip says of itself.
#include <span>
#include <sstream>
#include <string>

#include "fuzz/fuzzing.h"
#include "video/clip_reader.h"
#include "video/mp4_header.h"
#include "video/webm_header.h"
#include "video/whole_file.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  using namespace rotatebook;
  fuzzing::mayRefuse([&] { video::readClipMetadata(std::span(bytes, size), "clip"); });
  std::istringstream file(std::string(bytes, bytes + size));
  fuzzing::require(video::readMp4Header(file).edits.size() <= 16);
  video::readWebmHeader(file);
  fuzzing::mayRefuse([&] { video::requireWholeFile(file, "clip"); });
  return 0;
}
