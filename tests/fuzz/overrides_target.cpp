// --set: several of them over a scene, divided by bars.
#include <algorithm>
#include <string>
#include <vector>

#include "fuzz/fuzzing.h"
#include "scene/scene_text.h"

namespace rotatebook::fuzzing {
namespace {

constexpr const char* kScene = R"(
[initial]
angular_velocity = [5, 0, 0]
tilt = [0.01, "z"]
[expect]
tilt_deg = [{ max = 10, to = 2 }, { rises_to = 170 }]
[[panel]]
label = "a"
[[panel]]
label = "b"
simulation.model = "exact"
)";

std::vector<std::string> dividedByBars(std::string_view text) {
  std::vector<std::string> parts;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find('|', begin), text.size());
    parts.emplace_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return parts;
}

}  // namespace
}  // namespace rotatebook::fuzzing

int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  using namespace rotatebook;
  const auto overrides = fuzzing::dividedByBars(fuzzing::textOf(bytes, size));
  fuzzing::mayRefuse([&] { scene::parseScene(fuzzing::kScene, "a.toml", overrides); });
  return 0;
}
