// A clip's metadata and header: any bytes are refused, or tell what the clip says of itself.
#include <cstring>
#include <span>
#include <sstream>
#include <string>

#include "bridge/bridge.h"
#include "fuzz/fuzzing.h"
#include "video/clip_reader.h"
#include "video/coded_units.h"
#include "video/mp4_layout.h"
#include "video/webm_layout.h"
#include "video/whole_file.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  using namespace rotatebook;
  fuzzing::mayRefuse([&] { video::readClipMetadata(std::span(bytes, size), "clip"); });
  std::istringstream file(std::string(bytes, bytes + size));
  fuzzing::require(!video::mp4Difference(file, {}, {}).empty());
  fuzzing::require(!video::webmDifference(file, {}, {}).empty());
  video::h264Difference(std::span(bytes, size), {}, {});
  video::h264Picture(std::span(bytes, size), true, {});
  video::PictureOrder(std::span(bytes, size)).isPlain(std::span(bytes, size), 1);
  video::vp9Picture(std::span(bytes, size), {});
  fuzzing::mayRefuse([&] { video::requireWholeFile(file, "clip"); });
  static rb_context* const context = rb_new(0, 0);
  rb_clip(context, static_cast<double>(size));
  std::memcpy(rb_buffer(context), bytes, size);  // One piece, as clip's MAX_LENGTH is smaller.
  fuzzing::require(rb_record(context, static_cast<std::int32_t>(size)) != 0);
  return 0;
}
