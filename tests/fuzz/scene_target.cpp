// The scene reader: any text is refused, or a scene that is written and read back without a change.
#include <optional>
#include <string>

#include "base/document/toml_tree.h"
#include "fuzz/fuzzing.h"
#include "scene/scene_text.h"

namespace rotatebook::fuzzing {
namespace {

// No exception is caught here: what sceneText() writes must be read.
void requireReadBack(const scene::Scene& scene) {
  const std::string text = scene::sceneText(scene);
  if (text.size() > document::kLongestToml) return;
  require(scene::sceneText(scene::parseScene(text, scene.name + ".toml")) == text);
}

}  // namespace
}  // namespace rotatebook::fuzzing

int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  using namespace rotatebook;
  std::optional<scene::Scene> scene;
  fuzzing::mayRefuse([&] { scene = scene::parseScene(fuzzing::textOf(bytes, size), "a.toml"); });
  if (scene) fuzzing::requireReadBack(*scene);
  return 0;
}
