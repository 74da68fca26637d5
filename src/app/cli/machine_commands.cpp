#include "cli/machine_commands.h"

#include <algorithm>
#include <array>
#include <csignal>
#include <exception>
#include <iostream>
#include <optional>
#include <string>
#include <utility>

#include <fmt/ostream.h>

#include "base/error.h"
#include "base/json.h"
#include "base/text.h"
#include "cli/commands.h"
#include "cli/crash_handler.h"
#include "cli/device_options.h"
#include "cli/exit_code.h"
#include "cli/interrupt.h"
#include "cli/option_checks.h"
#include "cli/progress_line.h"
#include "cli/scene_options.h"
#include "diagnose/checkup.h"
#include "diagnose/doctor_report.h"
#include "embedded/cli.h"
#include "picture/preflight.h"
#include "pipeline/benchmark.h"

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

std::string speedAdviceText(const pipeline::SpeedAdvice& advice, const pipeline::Speed& speed) {
  return fmt::format("    {:<24} up to {:.2f} times as fast, {:.0f} frames/s; {}\n", advice.change,
                     advice.gain, advice.gain * speed.framesPerSecond(), advice.effect);
}

Json json(const WorkTime& time) {
  return {{"wall", time.wall}, {"processor", time.processor}};
}

Json json(const pipeline::StageTimes& stages) {
  Json object;
  for (const Row& row : rowsOf(stages)) object[row.key] = json(row.time);
  return object;
}

}  // namespace

void reportSpeed(const scene::Scene& scene, const pipeline::Speed& speed, std::ostream& out) {
  fmt::print(
      out,
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
    fmt::print(out, "  {:<20} {:9.2f} {:10.2f} {:5.0f} %\n", row.label, row.time.wall,
               row.time.processor, 100 * row.time.processor / sum);
  }
  fmt::print(out, "  {:<30} {:10.2f}\n\n", "all", sum);
  out << limitText(speedLimit(speed.stages, speed.cores), speed);
  const auto advice = speedAdvice(scene, speed);
  if (!advice.empty()) out << "  what would help:\n";
  for (const pipeline::SpeedAdvice& one : advice) out << speedAdviceText(one, speed);
}

void reportSpeedAsJson(const scene::Scene& scene, const pipeline::Speed& speed, std::ostream& out) {
  const pipeline::SpeedLimit limit = speedLimit(speed.stages, speed.cores);
  out << jsonLine({{"scene", scene.name},
                   {"frames", speed.frames},
                   {"width", scene.clip.width},
                   {"height", scene.clip.height},
                   {"cores", speed.cores},
                   {"renderer", speed.renderer},
                   {"encoder", speed.encoder},
                   {"start_up_s", speed.startUp},
                   {"frames_per_second", speed.framesPerSecond()},
                   {"whole", json(speed.whole)},
                   {"drawing", json(speed.drawing)},
                   {"limit", limit.wall},
                   {"limited_by", limit.ofCores ? "cores" : rowOf(limit.stage).key},
                   {"stages", json(speed.stages)}});
}

namespace {

struct BenchArguments {
  std::string scene;
  SceneOptions sceneOptions;
  DeviceOptions deviceOptions;
  std::int64_t frames = pipeline::SpeedOptions{}.frames;
  bool json = false;
};

scene::Scene readScene(const BenchArguments& arguments) {
  if (!arguments.scene.empty()) return arguments.sceneOptions.read(arguments.scene);
  return arguments.sceneOptions.parse(benchScene(), "builtin");
}

void refuseTransparent(const scene::Scene& scene) {
  if (!scene::isTransparent(scene)) return;
  throw InputError(scene.name +
                   ": the MP4 that is measured can't hold the transparent background of "
                   "look.background; add --set look.background=studio");
}

int bench(const BenchArguments& arguments) {
  const scene::Scene scene = readScene(arguments);
  refuseTransparent(scene);
  picture::TextureFiles textures = picture::preflight(scene).textures;
  pipeline::SpeedOptions options{.frames = arguments.frames,
                                 .device = arguments.deviceOptions.choice(),
                                 .textures = std::move(textures)};
  options.stop = &catchInterrupts();
  std::optional<pipeline::Speed> speed;
  {
    ProgressLine line(scene.name);
    options.progress = [&line](std::int64_t done, std::int64_t total) { line.update(done, total); };
    speed = pipeline::measureSpeed(scene, options);
  }
  if (!speed) {
    fmt::print(std::cout, "{}: interrupted; nothing was measured\n", scene.name);
    return interruptStatus();
  }
  (arguments.json ? reportSpeedAsJson : reportSpeed)(scene, *speed, std::cout);
  return kDone;
}

}  // namespace

void addBenchCommand(CLI::App& program, Action& action) {
  constexpr std::int64_t kMax = 1'000'000;
  auto [command, arguments] = addCommand(
      program, action, "bench", "Measure how fast this machine renders, and what limits it", bench);
  command.add_option("SCENE", arguments.scene,
                     "Scene file; by default a built-in one, a tumbling book with overlays");
  addOption(command, "--frames", "N", arguments.frames, "Frames to render, from the first")
      ->check(wholeNumber(1, kMax))
      ->capture_default_str();
  command.add_flag(
      "--json", arguments.json,
      "Print one JSON object; times are in milliseconds a frame, start_up_s in seconds");
  arguments.sceneOptions.addTo(command);
  arguments.deviceOptions.addTo(command);
  command.footer(R"(
Renders the frames three times, into a folder below TMPDIR that is removed afterwards: once stage by
stage, once drawing alone, and once as render does it, to PNGs and an MP4. Each stage is measured while
nothing else runs; "processor" is the time of all cores together.

Examples:
  rotatebook bench
  rotatebook bench my.toml --frames 60 --size 1920x1080
  rotatebook bench --set "overlay.show=['axes']")");
}

namespace {

struct DoctorArguments {
  std::string folder = "out";
  bool json = false;
};

int examine(const DoctorArguments& arguments) {
  const diagnose::Checkup checkup = diagnose::checkUp(arguments.folder);
  (arguments.json ? diagnose::reportCheckupAsJson : diagnose::reportCheckup)(checkup, std::cout);
  return checkup.ready() ? kDone : kMachineFailed;
}

}  // namespace

void addDoctorCommand(CLI::App& program, Action& action) {
  auto [command, arguments] = addCommand(
      program, action, "doctor",
      "Check whether this machine can render; if not, report why and what helps", examine);
  addOption(command, "-o,--output", "DIR", arguments.folder,
            "Folder for the results: its free space is reported, and whether it can be "
            "written; nothing is left there")
      ->capture_default_str();
  command.add_flag("--json", arguments.json, "Print one JSON object");
  command.footer(R"(
Lists the EGL devices, whose numbers --device takes, and the other EGL displays; draws a small picture
with each and compares it with a stored one. Then checks encoders, font, folder, cores and memory.

Exit status: 0 if render works as it is by default, 3 if it doesn't.

Examples:
  rotatebook doctor
  rotatebook doctor --json | python3 -m json.tool)");
}

namespace {

struct CrashArguments {
  DeviceOptions deviceOptions;
  bool resumable = false;
  int stackFile = -1;
  int signal = SIGABRT;
};

/// Reports the driver that crashed. If none did, ends as the process that crashed would have.
int explain(const CrashArguments& arguments) {
  if (arguments.resumable) adviseResume();
  try {
    if (const auto problem = diagnose::explainCrash(arguments.deviceOptions.parsed())) {
      fmt::print(std::cerr, "rotatebook: can't draw: {}\n  remedy: {}{}", problem->what,
                 problem->remedy, crashAdvice());
      return kMachineFailed;
    }
  } catch (...) {
    reportError(std::current_exception(), "the drivers can't be tried: ");
  }
  takeCrashStack(arguments.stackFile);
  return raise(arguments.signal);  // Reported by the handler of crashes.
}

}  // namespace

void addAfterCrashCommand(CLI::App& program, Action& action) {
  auto [command, arguments] =
      addCommand(program, action, kAfterCrash, "Explain the crash of a command", explain);
  command.group("");  // Hidden.
  arguments.deviceOptions.addTo(command);
  command.add_option(kStack, arguments.stackFile);
  command.add_flag(kResumable, arguments.resumable);
  command.add_option("SIGNAL", arguments.signal)->required();
}

}  // namespace rotatebook::cli
