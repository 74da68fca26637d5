#include "study/map_runs.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "base/error.h"
#include "physics/simulate.h"
#include "study/map_point.h"
#include "study/map_value.h"
#include "study/run_value.h"
#include "study/whole_motion.h"

namespace rotatebook::study {
namespace {

using physics::MotionSettings;
using physics::Trajectory;
using scene::MapSettings;

// Of a tile's sides, which are multiples of it: small enough that little is lost with one, large
// enough that one takes a while, and that of motions whose steps differ from column to column or
// from row to row enough have the same.
constexpr int kTileSide = 32;
// Of a panel's tiles, each of which is a file for a time.
constexpr double kMaxTiles = 1024;

/// A panel's motion and the map's way of giving it other values.
struct PanelRuns {
  MapPoints points;
  std::optional<double> interval;  // [s]
  bool isIdleX{}, isIdleY{};       // whether all motions along the axis are one and the same

  /// Returns the run at a point; nullopt if there is none. What the closed form doesn't use is left
  /// out of it, so that points of the same motion can be told.
  std::optional<MapRun> at(double x, double y) const {
    try {
      MapRun run{points.at(x, y)};
      run.interval = interval.value_or(run.motion.simulation.timePerFrame);
      if (run.motion.simulation.model == physics::Model::Exact) {
        run.motion.simulation = {};
        run.motion.simulation.model = physics::Model::Exact;
        run.motion.simulation.timePerFrame = run.interval;
      }
      return run;
    } catch (const InputError&) {
      return std::nullopt;
    }
  }
};

double durationOf(const scene::Scene& scene) {
  const MapSettings& map = *scene.map;
  if (map.timeAxis() != nullptr) return map.timeAxis()->to;
  const double clip = static_cast<double>(scene.clip.frameCount() - 1) * scene.timePerFrame();
  return map.duration.value_or(clip);
}

/// Returns whether all motions along one of the axes are one and the same: those at its ends and
/// between, where an angle may be a turn.
bool isIdle(const scene::Axis& axis, const PanelRuns& panel, const MapSettings& map) {
  if (axis.kind == scene::AxisKind::Time) return true;
  const auto at = [&](double value) {
    return &axis == &map.x ? panel.at(value, map.y.from) : panel.at(map.x.from, value);
  };
  const auto first = at(axis.from), last = at(axis.to);
  const auto between = at(scene::numberWithin(axis.from, axis.to, 0.382, axis.scale));
  if (!first || !between || !last) return false;
  return first->motion == between->motion && first->motion == last->motion;
}

/// Returns the side of the tiles of a panel.
int tileSide(const MapSettings& map) {
  const double needed = std::sqrt(static_cast<double>(map.runs()) / kMaxTiles);
  return kTileSide * std::max(1, static_cast<int>(std::ceil(needed / kTileSide)));
}

/// Returns the values of an axis at `count` of its `size` pixels.
std::vector<double> valuesAlong(const scene::Axis& axis, int first, int count, int size) {
  std::vector<double> values;
  for (int i = 0; i < count; ++i) values.push_back(axis.at(first + i, size));
  return values;
}

}  // namespace

struct MapRuns::Parts {
  MapSettings map;
  MapPlan plan;
  std::vector<PanelRuns> panels{};

  std::vector<double> overTime(const MapTile& tile, Stop stop) const;
  std::vector<double> pointByPoint(const MapTile& tile, Stop stop) const;
  std::vector<double> ofPoints(const MapTile& points, Stop stop) const;
  std::vector<double> lineOverTime(const PanelRuns& panel, double other, Stop stop) const;
};

/// Returns the values of one motion at the times of all pixels along the axis of time.
std::vector<double> MapRuns::Parts::lineOverTime(const PanelRuns& panel, double other,
                                                 Stop stop) const {
  const bool isAcross = map.x.kind == scene::AxisKind::Time;
  const int count = isAcross ? map.width : map.height;
  std::vector<double> values(static_cast<std::size_t>(count), kRefused);
  const double time = map.timeAxis()->at(count - 1, count);
  const std::optional<MapRun> run = isAcross ? panel.at(time, other) : panel.at(other, time);
  if (!run) return values;
  try {
    ValueOverTime value(run->motion, plan.measure);
    for (int i = 0; i < count && !isSet(stop); ++i)
      values[static_cast<std::size_t>(i)] = value.at(map.timeAxis()->at(i, count));
  } catch (const InputError&) {  // StepError, too
  }
  return values;
}

std::vector<double> MapRuns::Parts::overTime(const MapTile& tile, Stop stop) const {
  const bool isAcross = map.x.kind == scene::AxisKind::Time;
  const int lines = isAcross ? tile.height : tile.width;
  std::vector<double> values(static_cast<std::size_t>(tile.width) *
                             static_cast<std::size_t>(tile.height));
  for (int line = 0; line < lines; ++line) {
    const double other =
        isAcross ? map.y.at(tile.bottom + line, map.height) : map.x.at(tile.left + line, map.width);
    const std::vector<double> along = lineOverTime(panels[tile.panel], other, stop);
    const auto start = static_cast<std::size_t>(isAcross ? line * tile.width : line);
    const auto step = static_cast<std::size_t>(isAcross ? 1 : tile.width);
    for (std::size_t i = 0; i < along.size(); ++i) values[start + i * step] = along[i];
  }
  return values;
}

std::vector<double> MapRuns::Parts::pointByPoint(const MapTile& tile, Stop stop) const {
  const PanelRuns& panel = panels[tile.panel];
  MapTile points = tile;
  if (panel.isIdleX) points.width = 1;
  if (panel.isIdleY) points.height = 1;
  const std::vector<double> values = ofPoints(points, stop);
  std::vector<double> all;
  for (int y = 0; y < tile.height; ++y) {
    const auto row = values.begin() + static_cast<std::ptrdiff_t>(y % points.height) * points.width;
    for (int x = 0; x < tile.width; ++x) all.push_back(row[x % points.width]);
  }
  return all;
}

std::vector<double> MapRuns::Parts::ofPoints(const MapTile& tile, Stop stop) const {
  const PanelRuns& panel = panels[tile.panel];
  const auto width = static_cast<std::size_t>(tile.width);
  const std::vector<double> across = valuesAlong(map.x, tile.left, tile.width, map.width);
  const std::vector<double> up = valuesAlong(map.y, tile.bottom, tile.height, map.height);
  MapValues found(plan, stop);
  std::vector<std::optional<std::size_t>> runAt(across.size() * up.size());
  std::vector<std::optional<MapRun>> last(width);  // of each column
  for (std::size_t i = 0; i < runAt.size(); ++i) {
    const std::size_t column = i % width;
    std::optional<MapRun> run = panel.at(across[column], up[i / width]);
    // Whole numbers, and the closed form, give many points the same motion.
    const auto isThat = [&](const std::optional<MapRun>& other) {
      return other && other->motion == run->motion;
    };
    if (!run) {
      // There is none.
    } else if (column > 0 && isThat(last[column - 1])) {
      runAt[i] = runAt[i - 1];
    } else if (isThat(last[column])) {
      runAt[i] = runAt[i - width];
    } else {
      runAt[i] = found.add(*run);
    }
    last[column] = std::move(run);
  }
  const std::vector<double> values = found.finish();
  std::vector<double> all;
  for (const auto& index : runAt) all.push_back(index ? values[*index] : kRefused);
  return all;
}

MapRuns::MapRuns(const scene::Scene& scene)
    : parts_(std::make_unique<Parts>(
          Parts{*scene.map, {scene.map->measure, scene.map->moment, durationOf(scene)}})) {
  requireSameLayout();
  for (const scene::Panel& panel : scene.motions) {
    PanelRuns runs{MapPoints(panel.motion(), *scene.map), scene.map->interval};
    runs.isIdleX = isIdle(scene.map->x, runs, *scene.map);
    runs.isIdleY = isIdle(scene.map->y, runs, *scene.map);
    parts_->panels.push_back(std::move(runs));
  }
}

MapRuns::~MapRuns() = default;

std::size_t MapRuns::panels() const {
  return parts_->panels.size();
}

std::vector<MapTile> MapRuns::tiles() const {
  const MapSettings& map = parts_->map;
  std::vector<MapTile> tiles;
  for (std::size_t panel = 0; panel < panels(); ++panel) {
    const PanelRuns& runs = parts_->panels[panel];
    const int stepX = runs.isIdleX ? map.width : tileSide(map);
    const int stepY = runs.isIdleY ? map.height : tileSide(map);
    for (int bottom = 0; bottom < map.height; bottom += stepY) {
      for (int left = 0; left < map.width; left += stepX) {
        tiles.push_back({panel, left, bottom, std::min(stepX, map.width - left),
                         std::min(stepY, map.height - bottom)});
      }
    }
  }
  return tiles;
}

std::vector<double> MapRuns::valuesOf(const MapTile& tile, Stop stop) const {
  return parts_->map.timeAxis() != nullptr ? parts_->overTime(tile, stop)
                                           : parts_->pointByPoint(tile, stop);
}

double MapRuns::valueAt(std::size_t panel, double x, double y) const {
  const PanelRuns& runs = parts_->panels[panel];
  MapPlan plan = parts_->plan;
  if (const auto* time = parts_->map.timeAxis()) plan.duration = time == &parts_->map.x ? x : y;
  const std::optional<MapRun> run = runs.at(x, y);
  if (!run) return kRefused;
  MapValues value(plan, nullptr);
  value.add(*run);
  return value.finish().front();
}

}  // namespace rotatebook::study
