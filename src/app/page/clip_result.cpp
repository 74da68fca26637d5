#include "page/clip_result.h"

#include <algorithm>

#include <fmt/core.h>

#include "base/error.h"
#include "page/figure.h"
#include "page/result_json.h"
#include "scene/poster_frame.h"
#include "store/fingerprint.h"

namespace rotatebook::page {
namespace {

/// Returns an event's words, a scene's word and perhaps a number, in the page's language.
std::string wordsOfEvent(const std::string& words, const scene::Words& ofScene,
                         const Language& say) {
  if (!say.ofPictures) return words;
  const std::size_t end = words.find_last_not_of("0123456789") + 1;
  const bool isNumbered = end > 0 && end < words.size() && words[end - 1] == ' ';
  const std::string word = isNumbered ? words.substr(0, end - 1) : words;
  const auto row = std::ranges::find(ofScene.texts, word);
  if (row == ofScene.texts.end()) return words;
  return say.ofPictures->texts[static_cast<std::size_t>(row - ofScene.texts.begin())] +
         words.substr(word.size());
}

timeline::ClipEvent eventIn(const Json& event, const scene::Words& ofScene, const Language& say) {
  const Json& label = event.at("label");
  return {event.at("frame").get<std::int64_t>(), event.at("time_s").get<double>(),
          label.is_null() ? "" : say(label.get<std::string>()),
          wordsOfEvent(event.at("words").get<std::string>(), ofScene, say)};
}

MotionResult motionIn(const Json& motion, const Language& say) {
  MotionResult result{numberIn(motion, "diverged_at_s")};
  if (motion.at("diverges_unexpectedly").get<bool>())
    result.checks.push_back(unexpectedDivergence(*result.divergedAt, say));
  for (const Json& expected : motion.at("expectations"))
    result.checks.push_back(checkOf(expectationIn(expected), say));
  return result;
}

/// Leaves of the motions' samples what the page draws and says: kinds of energy only of a lone book
/// of springs, and as many digits as its plots tell.
void keepPlotted(Json& motions) {
  constexpr int kDigits = 4;
  for (Json& motion : motions) {
    if (motions.size() > 1 || !motion.at("springs").get<bool>()) {
      for (const char* key : {"kinetic", "potential"}) motion.erase(key);
    }
    for (Json& member : motion) {
      if (!member.is_array()) continue;
      for (Json& value : member) {
        if (value.is_number_float()) value = roundedJson(value.get<double>(), kDigits);
      }
    }
  }
}

/// Returns JSON that is safe in a <script>: "<" is in texts alone.
std::string inScript(const Json& json) {
  std::string text;
  for (const char letter : json.dump()) text += letter == '<' ? "\\u003C" : std::string(1, letter);
  return text;
}

ClipResult resultIn(const Json& json, const scene::Scene& scene, const std::string& checksum,
                    const Language& say) {
  ClipResult result;
  result.frames = json.at("frames").get<std::int64_t>();
  for (const Json& motion : json.at("motions")) result.motions.push_back(motionIn(motion, say));
  for (const Json& event : json.at("events"))
    result.events.push_back(eventIn(event, scene.overlay.words, say));
  Json plots = json.at("plots");
  for (const char* key : {"rate", "frames"}) plots[key] = json.at(key);
  plots["poster"] = posterFrame(scene.clip, result.frames);
  for (Json& motion : plots.at("motions"))
    motion["label"] = say(motion.at("label").get<std::string>());
  keepPlotted(plots.at("motions"));
  if (!checksum.empty()) plots["checksum"] = checksum;
  result.plots = inScript(plots);
  return result;
}

}  // namespace

ClipResult readClipResult(const std::filesystem::path& file, const scene::Scene& scene,
                          const std::string& checksum, const Language& say) {
  requireFile(file, scene, "render");
  const auto result = readResult<ClipResult>(
      file, store::sceneChecksum(scene),
      [&](const Json& json) { return resultIn(json, scene, checksum, say); });
  if (result && result->motions.size() == scene.motions.size()) return *result;
  throw InputError(fmt::format("{} was made from another scene or with other settings; {}",
                               file.string(), renderAgain(scene, file.parent_path())));
}

}  // namespace rotatebook::page
