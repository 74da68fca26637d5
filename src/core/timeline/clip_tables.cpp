#include "timeline/clip_tables.h"

#include "base/number_text.h"
#include "base/text.h"
#include "timeline/trajectory_csv.h"

namespace rotatebook::timeline {
namespace {

using scene::Axis;
using scene::Measure;

/// Returns the quantities that a single moment has.
std::vector<Measure> momentaryMeasures() {
  std::vector<Measure> all;
  for (const Measure measure : scene::kMeasuresOfMotions) {
    if (rowOf(measure).span == scene::MeasureSpan::Moment) all.push_back(measure);
  }
  return all;
}

constexpr std::string_view kMotionColumns = "frame,time_s,qw,qx,qy,qz,wx,wy,wz,";
constexpr std::string_view kDivergenceColumn = ",diverges_at";

std::string keyCell(const std::optional<Axis>& axis) {
  return axis ? axis->key + "," : "";
}

std::string valueCell(const std::optional<Axis>& axis, std::size_t index) {
  return axis ? csvField(axis->values[index].label) + "," : "";
}

std::string numbersOf(const physics::Trajectory& trajectory) {
  std::string text = shortestText(trajectory.samples.back().time);
  for (const Measure measure : momentaryMeasures()) {
    text += ',' + shortestText(scene::valueOn(trajectory.samples.back(), trajectory.samples.front(),
                                              measure));
  }
  return text + ',' + (trajectory.divergedAt ? shortestText(*trajectory.divergedAt) : "");
}

}  // namespace

std::string gridCsv(const scene::Scene& scene, const ClipMotion& motion) {
  const scene::GridSettings& grid = *scene.grid;
  std::string text = keyCell(grid.columns) + keyCell(grid.rows) + "time_s";
  for (const Measure measure : momentaryMeasures()) text += ',' + std::string(nameOf(measure));
  text += std::string(kDivergenceColumn) + '\n';
  const std::size_t columns = grid.columnCount();
  for (std::size_t i = 0; i < motion.trajectories().size(); ++i) {
    text += valueCell(grid.columns, i % columns) + valueCell(grid.rows, i / columns) +
            numbersOf(motion.trajectories()[i]) + '\n';
  }
  return text;
}

std::size_t tableCount(const scene::Scene& scene) {
  return scene.grid || !scene.hasPanels() ? 1 : scene.motions.size();
}

void writeTable(const scene::Scene& scene, const ClipMotion& motion, std::size_t index,
                const std::function<void(std::string_view)>& take) {
  if (scene.grid) return take(gridCsv(scene, motion));
  writeCsv(motion.trajectories()[index], take);
}

std::string tableText(const scene::Scene& scene, const ClipMotion& motion, std::size_t index) {
  std::string text;
  writeTable(scene, motion, index, [&text](std::string_view piece) { text += piece; });
  return text;
}

bool isTableHeader(std::string_view row) {
  return row.starts_with(kMotionColumns) || row.ends_with(kDivergenceColumn);
}

std::size_t rowCount(const scene::Scene& scene, const ClipMotion& motion, std::size_t index) {
  return scene.grid ? motion.trajectories().size() : motion.trajectories()[index].samples.size();
}

}  // namespace rotatebook::timeline
