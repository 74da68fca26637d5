#include "cli/bench_report.h"

#include <algorithm>
#include <array>
#include <string>

#include <fmt/core.h>

#include "base/json.h"
#include "base/text.h"

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

std::string limitText(const pipeline::SpeedLimit& limit, const pipeline::Speed& speed) {
  const char* stage = rowOf(limit.stage).label;
  const std::string what =
      limit.ofCores
          ? fmt::format("the {}, which are busiest with \"{}\"", countText(speed.cores, "core"),
                        stage)
          : fmt::format("\"{}\", for which the other stages wait while cores are idle", stage);
  return fmt::format(
      "  limit: {:.2f} ms a frame, {:.1f} frames/s; the render took {:.2f} times that\n"
      "  what limits: {}\n",
      limit.wall, 1000 / limit.wall, speed.whole.wall / limit.wall, what);
}

std::string adviceText(const pipeline::SpeedAdvice& advice, const pipeline::Speed& speed) {
  return fmt::format("    {:<24} up to {:.2f} times as fast, {:.0f} frames/s; {}\n", advice.change,
                     advice.gain, advice.gain * speed.framesPerSecond(), advice.effect);
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
  out << fmt::format(
      "{}: {} frames, {}, PNGs and MP4\n"
      "  renderer {}; encoder {}; {}\n"
      "  {:.1f} frames/s, {:.2f} ms a frame, {:.2f} ms of processor time; started in {:.2f} s\n"
      "  drawing alone: {:.1f} frames/s, {:.2f} ms a frame, {:.2f} ms of processor time\n\n"
      "  each stage alone      ms/frame  processor   share\n",
      scene.name, speed.frames, sizeText(scene.clip.width, scene.clip.height), speed.renderer,
      speed.encoder, countText(speed.cores, "core"), speed.framesPerSecond(), speed.whole.wall,
      speed.whole.processor, speed.startUp, 1000 / speed.drawing.wall, speed.drawing.wall,
      speed.drawing.processor);
  const double sum = speed.stages.processorSum();
  for (const Row& row : rowsOf(speed.stages)) {
    out << fmt::format("  {:<20} {:9.2f} {:10.2f} {:5.0f} %\n", row.label, row.time.wall,
                       row.time.processor, 100 * row.time.processor / sum);
  }
  out << fmt::format("  {:<30} {:10.2f}\n\n", "all", sum);
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
