// Results of commands, read from the JSON that they left. Inside the room only.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "page/expectation_table.h"
#include "scene/expectation.h"
#include "system/read_file.h"

namespace rotatebook::page {

using Json = nlohmann::json;

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
  }
  return std::nullopt;
}

/// Returns the number called `key`; nothing for null. Throws Json::exception.
std::optional<double> numberIn(const Json& object, const char* key);

/// Returns the expectation on a motion that timeline::expectationJson() wrote. Throws
/// Json::exception.
scene::ExpectationResult expectationIn(const Json& expected);

/// Returns the rows of "expectations" that scene::boundsJson() wrote. Throws Json::exception.
std::vector<Check> boundChecksIn(const Json& result);

}  // namespace rotatebook::page
