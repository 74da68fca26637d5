#include "study/map_result.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "base/number_text.h"

namespace rotatebook::study {
namespace {

using scene::MapExpectation;
using scene::Outcome;
using Of = MapExpectation::Of;
using Panels = std::vector<std::size_t>;

/// Returns the panels that something is expected of.
Panels panelsOf(const MapExpectation& one, const MapResult& result) {
  Panels panels;
  for (std::size_t i = 0; i < result.labels.size(); ++i) {
    if (result.labels[i] == one.panel.value_or(result.labels[i])) panels.push_back(i);
  }
  return panels;
}

MapFacts factsOf(const MapResult& result, const Panels& panels) {
  MapFacts facts;
  double sum = 0;
  for (const std::size_t panel : panels) {
    for (const double value : result.values[panel]) {
      ++facts.runs;
      if (!std::isfinite(value)) {
        const Outcome outcome = outcomeOf(value);
        facts.never += outcome == Outcome::Never;
        facts.diverged += outcome == Outcome::Diverged;
        facts.refused += outcome == Outcome::Refused;
        continue;
      }
      sum += value;
      // Written so that the first value replaces NaN.
      if (!(facts.smallest <= value)) facts.smallest = value;
      if (!(facts.largest >= value)) facts.largest = value;
    }
  }
  if (facts.withValue() > 0) facts.mean = sum / static_cast<double>(facts.withValue());
  return facts;
}

bool counts(const MapExpectation& one, double value) {
  const Outcome outcome = outcomeOf(value);
  if (one.outcome && outcome != *one.outcome) return false;
  if (!one.over && !one.under) return true;
  return outcome == Outcome::Value && (!one.over || value > *one.over) &&
         (!one.under || value < *one.under);
}

double shareOf(const MapExpectation& one, const MapResult& result, const Panels& panels) {
  double all = 0, counted = 0;
  for (const std::size_t panel : panels) {
    const std::vector<double>& values = result.values[panel];
    all += static_cast<double>(values.size());
    counted += static_cast<double>(
        std::ranges::count_if(values, [&](double value) { return counts(one, value); }));
  }
  return counted / all;
}

double measured(const MapExpectation& one, const MapResult& result, const MapRuns& runs) {
  const Panels panels = panelsOf(one, result);
  if (one.of == Of::Share) return shareOf(one, result, panels);
  if (one.of == Of::Value) return runs.valueAt(panels.front(), (*one.at)[0], (*one.at)[1]);
  const MapFacts facts = factsOf(result, panels);
  return one.of == Of::Smallest  ? facts.smallest
         : one.of == Of::Largest ? facts.largest
                                 : facts.mean;
}

std::string shareText(const MapExpectation& one) {
  constexpr const char* kOutcomes[] = {"with a value", "never", "diverged", "refused"};
  std::string text = "share";
  if (one.outcome) text += std::string(" ") + kOutcomes[static_cast<std::size_t>(*one.outcome)];
  if (one.over) text += " over " + shortestText(*one.over);
  if (one.under) text += std::string(one.over ? " and" : "") + " under " + shortestText(*one.under);
  return text;
}

}  // namespace

std::string ExpectedOfMap::subject() const {
  const MapExpectation& one = expectation;
  std::string text = one.of == Of::Smallest  ? "smallest value"
                     : one.of == Of::Largest ? "largest value"
                     : one.of == Of::Mean    ? "mean value"
                     : one.of == Of::Share   ? shareText(one)
                                             : "value at [" + shortestText((*one.at)[0]) + ", " +
                                                 shortestText((*one.at)[1]) + "]";
  return text + (one.panel ? ", of " + *one.panel : "");
}

MapResult emptyResult(const scene::Scene& scene, const MapRuns& runs) {
  MapResult result;
  for (const scene::Panel& panel : scene.motions) {
    result.labels.push_back(panel.label);
    result.values.emplace_back(static_cast<std::size_t>(scene.map->runs()), kRefused);
  }
  for (const scene::MapMark& mark : scene.map->marks) {
    result.marks.push_back({mark});
    for (std::size_t i = 0; i < runs.panels(); ++i) {
      result.marks.back().values.push_back(runs.valueAt(i, mark.x, mark.y));
    }
  }
  return result;
}

void putTile(const MapTile& tile, const std::vector<double>& values, const scene::MapSettings& map,
             MapResult& result) {
  const auto width = static_cast<std::ptrdiff_t>(tile.width);
  auto row = values.begin();
  for (int y = tile.bottom; y < tile.bottom + tile.height; ++y, row += width) {
    const std::ptrdiff_t start = static_cast<std::ptrdiff_t>(y) * map.width + tile.left;
    std::copy(row, row + width, result.values[tile.panel].begin() + start);
  }
}

MapFacts factsOf(const MapResult& result) {
  return factsOf(result, panelsOf({}, result));
}

std::vector<ExpectedOfMap> expectedOf(const MapResult& result, const scene::MapSettings& map,
                                      const MapRuns& runs) {
  std::vector<ExpectedOfMap> all;
  for (const MapExpectation& one : map.expected) all.push_back({one, measured(one, result, runs)});
  return all;
}

}  // namespace rotatebook::study
