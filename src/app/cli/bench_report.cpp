#include "cli/bench_report.h"

#include <algorithm>
#include <array>
#include <string>

#include "base/json.h"
#include "base/text.h"
#include "cli/formatted.h"

namespace rotatebook::cli {
namespace {

using pipeline::Stage;
using pipeline::WorkTime;

/// A stage with its label in the text report and its `key` in the JSON report.
struct Row {
  Stage stage;
  const char* label;
  const char* key;
  WorkTime time;
};

std::array<Row, 5> rowsOf(const pipeline::StageTimes& stages) {
  return {{{Stage::Simulate, "simulate", "simulate", stages.simulate},
           {Stage::Book, "draw the book", "book", stages.book},
           {Stage::Compose, "edges, overlays", "compose", stages.compose},
           {Stage::Png, "PNG", "png", stages.png},
           {Stage::Video, "convert and encode", "video", stages.video}}};
}

Row rowOf(Stage stage) {
  const auto rows = rowsOf({});
  return *std::ranges::find(rows, stage, &Row::stage);
}

std::string coresText(int cores) {
  return std::to_string(cores) + (cores == 1 ? " core" : " cores");
}

std::string limitText(const pipeline::SpeedLimit& limit, const pipeline::Speed& speed) {
  const std::string bound =
      formatted("  limit: %.2f ms a frame, %.1f frames/s; the render took %.2f times that\n",
                limit.wall, 1000 / limit.wall, speed.whole.wall / limit.wall);
  const std::string stage = std::string("\"") + rowOf(limit.stage).label + "\"";
  if (limit.ofCores) {
    return bound + "  what limits: the " + coresText(speed.cores) + ", which are busiest with " +
           stage + "\n";
  }
  return bound + "  what limits: " + stage +
         ", for which the other stages wait while cores are idle\n";
}

std::string adviceText(const pipeline::SpeedAdvice& advice, const pipeline::Speed& speed) {
  return formatted("    %-24s up to %.2f times as fast, %.0f frames/s; %s\n", advice.change.c_str(),
                   advice.gain, advice.gain * speed.framesPerSecond(), advice.effect.c_str());
}

std::string json(const WorkTime& time) {
  return JsonObject().addNumber("wall", time.wall).addNumber("processor", time.processor).text();
}

std::string json(const pipeline::StageTimes& stages) {
  JsonObject object;
  for (const Row& row : rowsOf(stages)) object.add(row.key, json(row.time));
  return object.text();
}

}  // namespace

void reportSpeed(const scene::Scene& scene, const pipeline::Speed& speed, std::ostream& out) {
  out << scene.name << ": " << speed.frames << " frames, "
      << sizeText(scene.clip.width, scene.clip.height) << ", PNGs and MP4\n"
      << "  renderer " << speed.renderer << "; encoder " << speed.encoder << "; "
      << coresText(speed.cores) << '\n'
      << formatted(
             "  %.1f frames/s, %.2f ms a frame, %.2f ms of processor time; started in %.2f s\n",
             speed.framesPerSecond(), speed.whole.wall, speed.whole.processor, speed.startUp)
      << formatted("  drawing alone: %.1f frames/s, %.2f ms a frame, %.2f ms of processor time\n",
                   1000 / speed.drawing.wall, speed.drawing.wall, speed.drawing.processor)
      << formatted("\n  %-20s %9s %10s %7s\n", "each stage alone", "ms/frame", "processor",
                   "share");
  const double sum = speed.stages.processorSum();
  for (const Row& row : rowsOf(speed.stages)) {
    out << formatted("  %-20s %9.2f %10.2f %5.0f %%\n", row.label, row.time.wall,
                     row.time.processor, 100 * row.time.processor / sum);
  }
  out << formatted("  %-20s %9s %10.2f\n\n", "all", "", sum);
  out << limitText(speedLimit(speed.stages, speed.cores), speed);
  const auto advice = speedAdvice(scene, speed);
  if (!advice.empty()) out << "  what would help:\n";
  for (const pipeline::SpeedAdvice& one : advice) out << adviceText(one, speed);
}

void reportSpeedAsJson(const scene::Scene& scene, const pipeline::Speed& speed, std::ostream& out) {
  const pipeline::SpeedLimit limit = speedLimit(speed.stages, speed.cores);
  out << JsonObject()
             .addString("scene", scene.name)
             .addInteger("frames", speed.frames)
             .addNumber("width", scene.clip.width)
             .addNumber("height", scene.clip.height)
             .addNumber("cores", speed.cores)
             .addString("renderer", speed.renderer)
             .addString("encoder", speed.encoder)
             .addNumber("start_up_s", speed.startUp)
             .addNumber("frames_per_second", speed.framesPerSecond())
             .add("whole", json(speed.whole))
             .add("drawing", json(speed.drawing))
             .addNumber("limit", limit.wall)
             .addString("limited_by", limit.ofCores ? "cores" : rowOf(limit.stage).key)
             .add("stages", json(speed.stages))
             .text()
      << '\n';
}

}  // namespace rotatebook::cli
