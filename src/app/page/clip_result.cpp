#include "page/clip_result.h"

#include <fmt/core.h>

#include "base/error.h"
#include "page/figure.h"
#include "page/result_json.h"
#include "store/fingerprint.h"

namespace rotatebook::page {
namespace {

timeline::ClipEvent eventIn(const Json& event) {
  const Json& label = event.at("label");
  return {event.at("frame").get<std::int64_t>(), event.at("time_s").get<double>(),
          label.is_null() ? "" : label.get<std::string>(), event.at("words").get<std::string>()};
}

MotionResult motionIn(const Json& motion) {
  MotionResult result{numberIn(motion, "diverged_at_s")};
  if (motion.at("diverges_unexpectedly").get<bool>())
    result.checks.push_back(unexpectedDivergence(*result.divergedAt));
  for (const Json& expected : motion.at("expectations"))
    result.checks.push_back(checkOf(expectationIn(expected)));
  return result;
}

/// Returns JSON that is safe in a <script>: "<" is in texts alone.
std::string inScript(const Json& json) {
  std::string text;
  for (const char letter : json.dump()) text += letter == '<' ? "\\u003C" : std::string(1, letter);
  return text;
}

ClipResult resultIn(const Json& json, const std::string& checksum) {
  ClipResult result;
  result.frames = json.at("frames").get<std::int64_t>();
  for (const Json& motion : json.at("motions")) result.motions.push_back(motionIn(motion));
  for (const Json& event : json.at("events")) result.events.push_back(eventIn(event));
  Json plots = json.at("plots");
  for (const char* key : {"rate", "frames"}) plots[key] = json.at(key);
  if (!checksum.empty()) plots["checksum"] = checksum;
  result.plots = inScript(plots);
  return result;
}

}  // namespace

ClipResult readClipResult(const std::filesystem::path& file, const scene::Scene& scene,
                          const std::string& checksum) {
  requireFile(file, scene, "render");
  const auto result =
      readResult<ClipResult>(file, store::sceneChecksum(scene),
                             [&](const Json& json) { return resultIn(json, checksum); });
  if (result && result->motions.size() == scene.motions.size()) return *result;
  throw InputError(fmt::format("{} was made from another scene or with other settings; {}",
                               file.string(), renderAgain(scene, file.parent_path())));
}

}  // namespace rotatebook::page
