#include <iostream>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "base/error.h"
#include "cli/bench_report.h"
#include "cli/commands.h"
#include "cli/device_options.h"
#include "cli/exit_code.h"
#include "cli/interrupt.h"
#include "cli/progress_line.h"
#include "cli/scene_options.h"
#include "diagnose/checkup.h"
#include "diagnose/doctor_report.h"
#include "embedded/cli.h"
#include "picture/preflight.h"
#include "pipeline/benchmark.h"
#include "store/clip_files.h"

// The embedded default scene: Figure 5, as in scenes/figures.
namespace rotatebook::cli {
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
  picture::TextureFiles textures = picture::preflight(scene);
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
    std::cout << scene.name << ": interrupted; nothing was measured" << std::endl;
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
      ->check(CLI::Range(std::int64_t{1}, kMax))
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

}  // namespace rotatebook::cli
