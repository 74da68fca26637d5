// Results of commands, read from the JSON that they left. Inside the room only.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/error.h"
#include "base/json.h"
#include "page/expectation_table.h"
#include "scene/expectation.h"
#include "scene/scene.h"
#include "system/read_file.h"

namespace rotatebook::page {

/// Returns what `read` makes of the JSON in `file`; nothing unless that is a result of the scene
/// with this checksum.
template <typename Result, typename Read>
std::optional<Result> readResult(const std::filesystem::path& file,
                                 const std::string& sceneChecksum, const Read& read) {
  const Json json = Json::parse(system::readFileOrEmpty(file), nullptr,
                                /*allow_exceptions=*/false);
  try {
    if (json.at("scene_xxh128") == sceneChecksum) return read(json);
  } catch (const Json::exception&) {  // It is no result
  } catch (const InputError&) {       // Nor one of this version
  }
  return std::nullopt;
}

/// Returns the number called `key`; nothing for null. Throws Json::exception.
std::optional<double> numberIn(const Json& object, const char* key);

/// Returns the expectation on a motion that timeline::expectationJson() wrote. Throws
/// Json::exception, and InputError for a measure that there isn't.
scene::ExpectationResult expectationIn(const Json& expected);

/// Returns what was expected and measured of a study or a map of `scene`, by study::boundsJson().
/// Throws InputError unless `file` is the result of the scene with this checksum that
/// `rotatebook COMMAND` left; `again` is the remedy: "run the study again".
std::vector<Check> readChecks(const std::filesystem::path& file, const scene::Scene& scene,
                              const std::string& sceneChecksum, const std::string& command,
                              const std::string& again, const Language& say);

}  // namespace rotatebook::page
