// The JSON Schema of scenes, by a validator of the part of draft 4 that it uses.
#include "scene/scene_schema.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/document/toml_json.h"
#include "base/document/toml_tree.h"
#include "base/json.h"
#include "scene/key_rows.h"

namespace rotatebook::scene {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;

using Problems = std::vector<std::string>;

bool isOfType(const Json& value, const std::string& type) {
  if (type == "integer") return value.is_number_integer();
  if (type == "number") return value.is_number();
  return type == value.type_name();  // the names of JSON Schema
}

bool isOfTypes(const Json& value, const Json& types) {
  if (types.is_string()) return isOfType(value, types);
  return std::ranges::any_of(types, [&](const Json& type) { return isOfType(value, type); });
}

Problems problemsOf(const Json& value, const Json& schema, const std::string& path);

void addMembers(const Json& value, const Json& schema, const std::string& path, Problems& all) {
  const auto add = [&](const Json& part, const Json& its, const std::string& name) {
    std::ranges::copy(problemsOf(part, its, path + "." + name), std::back_inserter(all));
  };
  for (const auto& [name, part] : value.items()) {
    if (value.is_array() && schema.contains("items")) add(part, schema["items"], name);
    if (!value.is_object() || !schema.contains("properties")) continue;
    if (schema["properties"].contains(name))
      add(part, schema["properties"][name], name);
    else
      all.push_back(path + "." + name + ": no such key");
  }
}

/// Returns what of `value` the schema refuses.
Problems problemsOf(const Json& value, const Json& schema, const std::string& path) {
  Problems all;
  const auto refuse = [&](bool isRefused, const char* why) {
    if (isRefused) all.push_back(path + ": " + why);
  };
  for (const auto& [word, of] : schema.items()) {
    if (word == "type") refuse(!isOfTypes(value, of), "type");
    if (word == "enum") refuse(std::ranges::count(of, value) == 0, "enum");
    if (word == "minimum") refuse(value.is_number() && value < of, "minimum");
    if (word == "maximum") refuse(value.is_number() && value > of, "maximum");
    if (word == "maxLength") refuse(value.is_string() && value.size() > of, "maxLength");
    if (word == "minItems") refuse(value.is_array() && value.size() < of, "minItems");
    if (word == "maxItems") refuse(value.is_array() && value.size() > of, "maxItems");
    if (word == "pattern" && value.is_string())
      refuse(!std::regex_search(std::string(value), std::regex(std::string(of))), "pattern");
    if (word == "required" && value.is_object())
      for (const std::string name : of) refuse(!value.contains(name), "required");
    if (word == "anyOf") {
      const auto takes = [&](const Json& one) { return problemsOf(value, one, path).empty(); };
      refuse(std::ranges::none_of(of, takes), "anyOf");
    }
  }
  addMembers(value, schema, path, all);
  return all;
}

Problems problemsOfScene(const std::string& text) {
  static const Json schema = Json::parse(sceneSchema());
  return problemsOf(Json::parse(document::jsonOf(document::parseToml(text, "a.toml"))), schema, "");
}

TEST(SceneSchema, TakesEveryShippedScene) {
  int count = 0;
  for (const auto& entry : fs::recursive_directory_iterator(ROTATEBOOK_SOURCE "/scenes")) {
    if (entry.path().extension() != ".toml") continue;
    std::ostringstream text;
    text << std::ifstream(entry.path()).rdbuf();
    EXPECT_THAT(problemsOfScene(text.str()), IsEmpty()) << entry.path();
    ++count;
  }
  EXPECT_GT(count, 50);  // measured 64
}

TEST(SceneSchema, RefusesSlips) {
  EXPECT_THAT(problemsOfScene("[body]\nmas = 1"), ElementsAre(".body.mas: no such key"));
  EXPECT_THAT(problemsOfScene("[bodies]\nmass = 1"), ElementsAre(".bodies: no such key"));
  EXPECT_THAT(problemsOfScene("body.mass = true"), ElementsAre(".body.mass: anyOf"));
  EXPECT_THAT(problemsOfScene("body.mass = 0"), ElementsAre(".body.mass: anyOf"));
  EXPECT_THAT(problemsOfScene("body.mass = '1 m'"), ElementsAre(".body.mass: anyOf"));
  EXPECT_THAT(problemsOfScene("body.mass = '800 g'"), IsEmpty());
  EXPECT_THAT(problemsOfScene("body.size = [1, 2]"), ElementsAre(".body.size: minItems"));
  EXPECT_THAT(problemsOfScene("camera.frame = 'bodi'"), ElementsAre(".camera.frame: enum"));
  EXPECT_THAT(problemsOfScene("clip.size = 720"), ElementsAre(".clip.size: type"));
  EXPECT_THAT(problemsOfScene("simulation.substeps = 1.5"),
              ElementsAre(".simulation.substeps: type"));
  EXPECT_THAT(problemsOfScene("video.crf = 99"), ElementsAre(".video.crf: maximum"));
  EXPECT_THAT(problemsOfScene("overlay.show = ['axis']"), ElementsAre(".overlay.show.0: enum"));
  EXPECT_THAT(problemsOfScene("[[nudge]]\naxes = 'body'"), ElementsAre(".nudge.0: required"));
  EXPECT_THAT(problemsOfScene("[[panel]]\nlabel = 'a'\nclip.fps = 3"),
              ElementsAre(".panel.0.clip: no such key"));
  EXPECT_THAT(problemsOfScene("[map]\nmeasure = 'half_turns'"), SizeIs(2));  // x and y
}

TEST(SceneSchema, RefusesSlipsInAxes) {
  const auto inColumns = [](const std::string& axis) {
    return problemsOfScene("grid.columns = { key = 'simulation.substeps', " + axis + " }");
  };
  EXPECT_THAT(inColumns("values = [1, 10]"), IsEmpty());
  EXPECT_THAT(inColumns("values = ['a', true, { label = 'b', value = [4, 0, 0] }]"), IsEmpty());
  EXPECT_THAT(inColumns("from = 1, to = 9, count = 3, scale = 'log'"), IsEmpty());
  EXPECT_THAT(inColumns("value = [1, 10]"), ElementsAre(".grid.columns.value: no such key"));
  EXPECT_THAT(inColumns("values = 10"), ElementsAre(".grid.columns.values: type"));
  EXPECT_THAT(inColumns("values = [[1]]"), ElementsAre(".grid.columns.values.0: anyOf"));
  EXPECT_THAT(inColumns("values = [{ label = 'b' }]"),
              ElementsAre(".grid.columns.values.0: anyOf"));
  EXPECT_THAT(inColumns("scale = 'logarithmic'"), ElementsAre(".grid.columns.scale: enum"));
  EXPECT_THAT(inColumns("from = '1 rpm', to = '2 deg'"), IsEmpty());
  EXPECT_THAT(inColumns("from = 'one'"), ElementsAre(".grid.columns.from: anyOf"));
  EXPECT_THAT(inColumns("count = 1"), ElementsAre(".grid.columns.count: minimum"));
  EXPECT_THAT(problemsOfScene("study.x = { values = [1] }"), ElementsAre(".study.x: required"));
  EXPECT_THAT(problemsOfScene("study.curves.key = 3"), ElementsAre(".study.curves.key: type"));
}

TEST(SceneSchema, RefusesAxesOfNoKey) {
  const auto hasKey = [](const std::string& axis, const std::string& key) {
    const Problems problems = problemsOfScene(axis + ".key = '" + key + "'");
    return std::ranges::count(problems, "." + axis + ".key: pattern") == 0;
  };
  for (const char* key : {"simulation.substeps", "initial.tilt.0", "nudge.0.at", "body.size.2",
                          "body.part.1.density", "body.dimensions.radius"}) {
    EXPECT_TRUE(hasKey("study.x", key)) << key;
    EXPECT_TRUE(hasKey("map.x", key)) << key;
  }
  for (const char* key : {"simulation.substep", "simulation", "substeps", "clip.fps", "map.size",
                          "nudge.at", "simulation-substeps"}) {
    EXPECT_FALSE(hasKey("study.x", key)) << key;
    EXPECT_FALSE(hasKey("map.x", key)) << key;
  }
  for (const char* key : {"time", "spin.longitude", "moments.middle"}) {
    EXPECT_FALSE(hasKey("study.x", key)) << key;
    EXPECT_TRUE(hasKey("map.x", key)) << key;
  }
}

TEST(SceneSchema, RefusesSlipsInStudiesAndMaps) {
  const std::string map =
      "[map]\nx = { key = 'time', from = 0, to = '1 min' }\n"
      "y = { key = 'initial.tilt.0', from = '1 deg', to = 2 }\n";
  EXPECT_THAT(problemsOfScene(map + "measure = 'growth'"), IsEmpty());
  EXPECT_THAT(problemsOfScene(map + "measure = 'order'"), ElementsAre(".map.measure: enum"));
  EXPECT_THAT(problemsOfScene("study.measure = ['order']"), IsEmpty());
  EXPECT_THAT(problemsOfScene("study.measure = ['half_turn']"),
              ElementsAre(".study.measure.0: enum"));
  const auto inMap = [&](const std::string& lines) {
    return problemsOfScene(map + "measure = 'growth'\n" + lines);
  };
  EXPECT_THAT(problemsOfScene("map.x = { key = 'time', from = 0 }"),
              ElementsAre(".map: required", ".map: required", ".map.x: required"));
  EXPECT_THAT(inMap("colors.palete = 'gray'"), ElementsAre(".map.colors.palete: no such key"));
  EXPECT_THAT(inMap("colors.palette = 'grey'"), ElementsAre(".map.colors.palette: enum"));
  EXPECT_THAT(inMap("colors.contours = ['a']"), ElementsAre(".map.colors.contours.0: type"));
  EXPECT_THAT(inMap("marks = [{ at = [1] }]"), SizeIs(2));  // A number, and the label
  EXPECT_THAT(inMap("marks = [{ at = [1, 2], label = 'a' }]"), IsEmpty());
  EXPECT_THAT(inMap("film = { x = [1, 2], duration = '10 m' }"),
              ElementsAre(".map.film.duration: anyOf"));
  EXPECT_THAT(inMap("size = [960.5, 540]"), ElementsAre(".map.size.0: type"));
}

TEST(SceneSchema, RefusesSlipsInExpectations) {
  EXPECT_THAT(problemsOfScene("expect.half_turns = [{ min = 1 }, { rises_to = 2, from = '3 s' }]"),
              IsEmpty());
  EXPECT_THAT(problemsOfScene("expect.half_turn = { min = 1 }"),
              ElementsAre(".expect.half_turn: no such key"));
  EXPECT_THAT(problemsOfScene("expect.growth = { min = 1 }"),
              ElementsAre(".expect.growth: no such key"));
  for (const char* bounds : {"{ min = '1' }", "{ minimum = 1 }", "[{ max = 'a' }]", "1"}) {
    EXPECT_THAT(problemsOfScene(std::string("expect.half_turns = ") + bounds),
                ElementsAre(".expect.half_turns: anyOf"));
    EXPECT_THAT(problemsOfScene(std::string("[[panel]]\nexpect.half_turns = ") + bounds),
                ElementsAre(".panel.0: required", ".panel.0.expect.half_turns: anyOf"));
  }
  const auto inSection = [](const std::string& section, const std::string& keys) {
    return problemsOfScene(section + ".expect = [{ " + keys + " }]");
  };
  EXPECT_THAT(inSection("grid", "of = 'stretch', column = 10, row = 'a', from = 3, max = 2"),
              IsEmpty());
  EXPECT_THAT(inSection("grid", "of = 'growth'"), ElementsAre(".grid.expect.0.of: enum"));
  EXPECT_THAT(inSection("grid", "min = 3"), ElementsAre(".grid.expect.0: required"));
  EXPECT_THAT(inSection("study", "of = 'order', x = 10, curve = true, min = 3"), IsEmpty());
  EXPECT_THAT(inSection("study", "of = 'order', column = 10"),
              ElementsAre(".study.expect.0.column: no such key"));
  EXPECT_THAT(inSection("study", "of = 'order', rises_to = 10"),
              ElementsAre(".study.expect.0.rises_to: no such key"));
  EXPECT_THAT(inSection("study", "of = 'order', min = '1'"),
              ElementsAre(".study.expect.0.min: type"));
}

TEST(SceneSchema, RefusesSlipsInOtherTables) {
  EXPECT_THAT(problemsOfScene("simulation.normalize = { every = 10 }"), IsEmpty());
  EXPECT_THAT(problemsOfScene("simulation.normalize = { ever = 10 }"),
              ElementsAre(".simulation.normalize: anyOf"));
  EXPECT_THAT(problemsOfScene("[[cue]]\nat = 1\nmove = { orbits = 1 }"),
              ElementsAre(".cue.0.move.orbits: no such key"));
  EXPECT_THAT(problemsOfScene("clip.size = [640, 360, 16]"), ElementsAre(".clip.size: maxItems"));
}

/// Returns the schema of the key: "nudge.N.at".
const Json& schemaOf(const Json& schema, const std::string& key) {
  const Json* found = &schema;
  std::istringstream parts(key);
  for (std::string part; std::getline(parts, part, '.');)
    found = part == "N" ? &found->at("items") : &found->at("properties").at(part);
  return *found;
}

TEST(SceneSchema, HasATypeAndADescriptionOfEachKey) {
  const Json schema = Json::parse(sceneSchema());
  for (const KeyRow& row : allKeys()) {
    const Json& key = schemaOf(schema, row.name);
    const bool isTyped = key.contains("enum") || key.contains("anyOf") ||
                         (key.contains("type") && !key["type"].empty());
    EXPECT_TRUE(isTyped) << row.name;
    EXPECT_FALSE(key.at("description").empty()) << row.name;
  }
  EXPECT_EQ(schemaOf(schema, "body.mass").at("default"), 1.0);
  EXPECT_EQ(schemaOf(schema, "panel.N.body.mass"), schemaOf(schema, "body.mass"));
}

TEST(SceneSchema, TakesTheDefaults) {
  const Json schema = Json::parse(sceneSchema());
  for (const KeyRow& row : allKeys()) {
    const Json& key = schemaOf(schema, row.name);
    if (!key.contains("default")) continue;
    EXPECT_THAT(problemsOf(key["default"], key, row.name), IsEmpty());
  }
}

}  // namespace
}  // namespace rotatebook::scene
