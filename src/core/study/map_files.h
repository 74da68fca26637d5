// Maps as files: arrays of NumPy, JSON and CSV.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "base/json.h"
#include "scene/scene.h"
#include "study/map_result.h"

namespace rotatebook::study {

/// Most runs of which a map has a CSV.
inline constexpr std::size_t kMaxMapRows = 10'000;
/// Longest array of a map, with its header. [bytes]
inline constexpr std::size_t kLongestNpy = sizeof(double) * scene::kMaxMapRuns + 1024;

/// Returns the values as a file of NumPy, format 1.0: little-endian doubles, row by row from the
/// bottom, of the shape [height, width], or [panels, height, width] of several panels. NaN is a
/// refused run, infinity one that never does what is measured, minus infinity one that diverged.
/// (https://numpy.org/doc/stable/reference/generated/numpy.lib.format.html)
std::string npyOf(const MapResult& result, const scene::MapSettings& map);
/// Reads the values of a result of the same shape from such a file. Returns false, with nothing
/// changed, if `bytes` aren't one.
bool readNpy(std::string_view bytes, const scene::MapSettings& map, MapResult& result);

/// Returns doubles as little-endian bytes, and doubles from them.
std::string bytesOf(const std::vector<double>& values);
std::vector<double> doublesOf(std::string_view bytes);

/// Checksums that a map's JSON states.
struct MapChecksums {
  std::string fingerprint;  ///< Of all that the values depend on.
  std::string scene;        ///< Of the whole scene.
  std::string npy;          ///< Of the array's file.
};

/// Returns the numbers of a whole map as a JSON object.
Json factsJson(const MapFacts& facts);
/// Returns what was expected of a map, and measured, as a JSON array of boundsJson().
Json expectationsJson(const std::vector<ExpectedOfMap>& expected, const scene::MapSettings& map);

/// Returns the axes, the panels, the meaning of the values, the numbers of the whole map, its marks
/// and what was expected of it as JSON.
Json mapJson(const MapResult& result, const scene::Scene& scene, const MapRuns& runs,
             const MapChecksums& sums);
/// Returns the checksums in a text that mapJson() wrote; those that another text lacks are empty.
MapChecksums checksumsIn(std::string_view json);

/// Returns a header row and one row a run: panel if there are several, both keys, the measure,
/// outcome.
std::string mapCsv(const MapResult& result, const scene::Scene& scene);
/// Returns whether a table with this header row is one of mapCsv().
bool isMapHeader(std::string_view row);

}  // namespace rotatebook::study
