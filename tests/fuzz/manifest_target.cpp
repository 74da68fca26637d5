// The manifest beside the frames: any text is refused, or gives one that is read back as it was.
#include <optional>

#include "base/document/toml_tree.h"
#include "fuzz/fuzzing.h"
#include "store/manifest.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  using namespace rotatebook;
  std::optional<store::Manifest> manifest;
  fuzzing::mayRefuse(
      [&] { manifest = store::parseManifest(fuzzing::textOf(bytes, size), "manifest"); });
  if (!manifest) return 0;
  const std::string text = manifestText(*manifest);
  if (text.size() > document::kLongestToml) return 0;
  fuzzing::require(store::parseManifest(text, "manifest") == *manifest);
  return 0;
}
