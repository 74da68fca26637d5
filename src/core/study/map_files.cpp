#include "study/map_files.h"

#include <bit>
#include <cstdint>

#include "base/number_text.h"
#include "base/text.h"
#include "scene/names.h"
#include "study/bounds_json.h"

namespace rotatebook::study {
namespace {

using scene::Axis;
using scene::MapSettings;
using scene::Outcome;

constexpr std::string_view kOutcomeColumn = ",outcome";
constexpr std::string_view kNpyMagic("\x93NUMPY\x01\x00", 8);

std::string npyHeader(const MapSettings& map, std::size_t panels) {
  constexpr std::size_t kAlignment = 64, kPrefix = kNpyMagic.size() + 2;
  std::string text = "{'descr': '<f8', 'fortran_order': False, 'shape': (" +
                     (panels > 1 ? std::to_string(panels) + ", " : "") +
                     std::to_string(map.height) + ", " + std::to_string(map.width) + "), }";
  while ((kPrefix + text.size() + 1) % kAlignment != 0) text += ' ';
  text += '\n';
  const auto size = static_cast<unsigned>(text.size());
  return std::string(kNpyMagic) + static_cast<char>(size & 0xff) + static_cast<char>(size >> 8) +
         text;
}

std::string nameOf(Outcome outcome) {
  return std::string(scene::nameOf(scene::kOutcomes, outcome));
}

Json axisJson(const Axis& axis, int count) {
  return {{"key", axis.key},
          {"label", orNull(axis.label)},
          {"from", axis.from},
          {"to", axis.to},
          {"scale", scene::nameOf(scene::kScales, axis.scale)},
          {"count", count},
          {"first", axis.at(0, count)},
          {"last", axis.at(count - 1, count)}};
}

Json valueJson(double value) {
  const bool isNumber = outcomeOf(value) == Outcome::Value;
  return isNumber ? Json(value) : Json(nameOf(outcomeOf(value)));
}

Json markJson(const MarkedValue& marked) {
  return {{"label", marked.mark.label},
          {"x", marked.mark.x},
          {"y", marked.mark.y},
          {"values", arrayOf(marked.values, valueJson)}};
}

}  // namespace

std::string bytesOf(const std::vector<double>& values) {
  std::string bytes(values.size() * sizeof(double), '\0');
  char* byte = bytes.data();
  for (const double value : values) {
    auto bits = std::bit_cast<std::uint64_t>(value);
    for (std::size_t i = 0; i < sizeof bits; ++i, bits >>= 8) *byte++ = static_cast<char>(bits);
  }
  return bytes;
}

std::vector<double> doublesOf(std::string_view bytes) {
  std::vector<double> values(bytes.size() / sizeof(double));
  for (std::size_t n = 0; n < values.size(); ++n) {
    std::uint64_t bits = 0;
    for (std::size_t i = sizeof bits; i > 0; --i) {
      bits = bits << 8 | static_cast<unsigned char>(bytes[n * sizeof bits + i - 1]);
    }
    values[n] = std::bit_cast<double>(bits);
  }
  return values;
}

std::string npyOf(const MapResult& result, const MapSettings& map) {
  std::string bytes = npyHeader(map, result.values.size());
  for (const std::vector<double>& panel : result.values) bytes += bytesOf(panel);
  return bytes;
}

bool readNpy(std::string_view bytes, const MapSettings& map, MapResult& result) {
  const std::string header = npyHeader(map, result.values.size());
  const std::size_t size = static_cast<std::size_t>(map.runs()) * sizeof(double);
  if (!bytes.starts_with(header)) return false;
  bytes.remove_prefix(header.size());
  if (bytes.size() != size * result.values.size()) return false;
  for (std::size_t i = 0; i < result.values.size(); ++i) {
    result.values[i] = doublesOf(bytes.substr(i * size, size));
  }
  return true;
}

Json factsJson(const MapFacts& facts) {
  return {{"runs", facts.runs},       {"with_value", facts.withValue()},
          {"never", facts.never},     {"diverged", facts.diverged},
          {"refused", facts.refused}, {"smallest", facts.smallest},
          {"largest", facts.largest}, {"mean", facts.mean}};
}

Json expectationsJson(const std::vector<ExpectedOfMap>& expected, const scene::MapSettings& map) {
  return arrayOf(expected, [&](const ExpectedOfMap& one) {
    return boundsJson(one.subject(), rowOf(map.measure).meaning, one.expectation.bounds,
                      one.measured);
  });
}

Json mapJson(const MapResult& result, const scene::Scene& scene, const MapRuns& runs,
             const MapChecksums& sums) {
  const MapSettings& map = *scene.map;
  return {{"result", "map"},
          {"name", scene.name},
          {"title", scene.title},
          {"measure", nameOf(map.measure)},
          {"moment", scene::nameOf(scene::kMapMoments, map.moment)},
          {"panels", result.labels},
          {"x", axisJson(map.x, map.width)},
          {"y", axisJson(map.y, map.height)},
          {"order", "rows from the bottom; a value is that of its pixel's middle"},
          {"nan", "refused: no such motion, or no such step"},
          {"inf", "never: what is measured doesn't happen"},
          {"-inf", "diverged"},
          {"facts", factsJson(factsOf(result))},
          {"marks", arrayOf(result.marks, markJson)},
          {"expectations", expectationsJson(expectedOf(result, map, runs), map)},
          {"fingerprint", sums.fingerprint},
          {"scene_xxh128", sums.scene},
          {"npy_xxh128", sums.npy}};
}

MapChecksums checksumsIn(std::string_view json) {
  const auto isKept = [](int depth, Json::parse_event_t, const Json&) { return depth < 2; };
  const Json map = Json::parse(json, isKept, /*allow_exceptions=*/false);
  const auto textOf = [&](const char* key) {
    const bool isText = map.is_object() && map.contains(key) && map[key].is_string();
    return isText ? map[key].get<std::string>() : "";
  };
  return {textOf("fingerprint"), textOf("scene_xxh128"), textOf("npy_xxh128")};
}

bool isMapHeader(std::string_view row) {
  return row.ends_with(kOutcomeColumn);
}

std::string mapCsv(const MapResult& result, const scene::Scene& scene) {
  const MapSettings& map = *scene.map;
  const bool isAlone = result.labels.size() == 1;
  std::string text = (isAlone ? "" : "panel,") + map.x.key + "," + map.y.key + "," +
                     std::string(nameOf(map.measure)) + std::string(kOutcomeColumn) + "\n";
  for (std::size_t panel = 0; panel < result.labels.size(); ++panel) {
    for (std::size_t i = 0; i < result.values[panel].size(); ++i) {
      const int x = static_cast<int>(i) % map.width, y = static_cast<int>(i) / map.width;
      const double value = result.values[panel][i];
      const Outcome outcome = outcomeOf(value);
      text += (isAlone ? "" : csvField(result.labels[panel]) + ",") +
              shortestText(map.x.at(x, map.width)) + "," + shortestText(map.y.at(y, map.height)) +
              "," + (outcome == Outcome::Value ? shortestText(value) : "") + "," + nameOf(outcome) +
              "\n";
    }
  }
  return text;
}

}  // namespace rotatebook::study
