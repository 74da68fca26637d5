#include <algorithm>
#include <cstdlib>
#include <string>
#include <vector>

#include <fmt/core.h>

#include "base/error.h"
#include "cli/clip_options.h"
#include "cli/commands.h"
#include "cli/device_options.h"
#include "cli/exit_code.h"
#include "cli/input_guard.h"
#include "cli/interrupt.h"
#include "cli/option_checks.h"
#include "cli/render_scenes.h"
#include "cli/scene_options.h"
#include "cli/stream_scene.h"
#include "cli/terminal.h"
#include "picture/preflight.h"
#include "pipeline/render_clip.h"
#include "pipeline/scenes_at_a_time.h"
#include "system/machine.h"

namespace rotatebook::cli {
namespace {

struct RenderArguments {
  std::vector<std::string> scenes;
  std::vector<std::string> outputs{"out"};
  SceneOptions sceneOptions;
  DeviceOptions deviceOptions;
  std::string frames, part;
  bool noPng = false;
  std::vector<std::string> formats;
  bool noMp4 = false;
  bool noExpect = false;
  int atATime = 0;
  ReportStyle style;
  pipeline::RenderOptions options;
  std::vector<const CLI::Option*> ofFiles;  ///< Options without a meaning for a stream.

  bool isStream() const { return std::ranges::count(outputs, kStandardOutput) > 0; }
  Destination destination() const { return destinationOf(outputs, scenes.size()); }
};

store::FrameRange rangeOf(const std::string& text) {
  if (const auto range = store::parseRange(text)) return *range;
  throw InputError(fmt::format(
      "--frames {}: not a range; write first:end, for example 0:60 for the first 60 frames", text));
}

std::vector<video::VideoFormat> formatsOf(const RenderArguments& arguments) {
  if (!arguments.part.empty()) return {};
  const Destination destination = arguments.destination();
  if (!destination.name.empty()) return destination.formats;
  return videoFormatsOf(arguments.formats, arguments.noMp4);
}

/// Throws InputError if videos are named, and other options ask for something else.
void refuseOtherOutputs(const RenderArguments& arguments) {
  const bool isOther = arguments.noMp4 || !arguments.formats.empty() || !arguments.frames.empty() ||
                       !arguments.part.empty();
  if (arguments.destination().name.empty() || !isOther) return;
  throw InputError(fmt::format(
      "--output {} is the whole clip as a video; name a folder with --format, --no-mp4, --frames "
      "and --part",
      arguments.outputs.back()));
}

std::vector<SceneToRender> readScenes(const RenderArguments& arguments,
                                      const pipeline::RenderOptions& options) {
  const std::string name = arguments.destination().name;
  std::vector<SceneToRender> read;
  const auto [scenes, inputs] = readAllScenes(arguments.scenes, [&](const std::string& path) {
    scene::Scene scene = arguments.sceneOptions.read(path);
    if (!name.empty()) scene.name = name;
    read.push_back({scene, picture::preflight(scene), !arguments.noExpect});
    return scene;
  });
  refuseSameNames(scenes);
  for (const scene::Scene& scene : scenes) {
    refuseOpaque(scene, formatsOf(options.outputs));
    refuseInputs(footprintOf(scene, options), inputs);
  }
  return read;
}

int scenesAtATime(const std::vector<SceneToRender>& all) {
  std::vector<scene::Scene> scenes;
  for (const SceneToRender& one : all) scenes.push_back(one.scene);
  return pipeline::scenesAtATime(scenes, system::coreCount(), system::memorySize());
}

/// Shares a software rasteriser's threads among the scenes that are rendered at a time: by default
/// each would have as many as there are cores, and eight clips on two cores take 92 s of processor
/// time, not 82. Comes before any thread.
void shareRasteriser(int scenes) {
  constexpr int kKeep = 0;
  if (scenes < 2) return;
  setenv("LP_NUM_THREADS", std::to_string(std::max(1, system::coreCount() / scenes)).c_str(),
         kKeep);
}

/// Throws InputError for what a stream of pictures can't be, or be asked for.
void refuseOtherThanStream(const RenderArguments& arguments) {
  if (arguments.scenes.size() > 1 || arguments.outputs.size() > 1) {
    throw InputError(
        "--output -: the standard output takes the pictures of one scene, and no other output may "
        "be named beside it");
  }
  for (const CLI::Option* option : arguments.ofFiles) {
    if (option->count() == 0) continue;
    throw InputError(fmt::format(
        "{} is about files: leave it out with --output -, which writes none", option->get_name()));
  }
  refuseTerminal("--output -");
}

int renderToStream(const RenderArguments& arguments) {
  refuseOtherThanStream(arguments);
  pipeline::StreamOptions options{.format = streamFormatOf(arguments.formats)};
  if (!arguments.frames.empty()) options.frames = rangeOf(arguments.frames);
  const scene::Scene scene = arguments.sceneOptions.read(arguments.scenes.front());
  options.device = arguments.deviceOptions.choice();
  return streamScene({scene, picture::preflight(scene), !arguments.noExpect}, options);
}

int render(const RenderArguments& arguments) {
  if (arguments.isStream()) return renderToStream(arguments);
  refuseOtherOutputs(arguments);
  pipeline::RenderOptions options = arguments.options;
  const Destination destination = arguments.destination();
  options.folder = destination.folder;
  const bool hasPng = !arguments.noPng && destination.name.empty();
  options.outputs = pipeline::outputsOf(hasPng, formatsOf(arguments));
  options.device = arguments.deviceOptions.choice(/*resumable=*/true);
  if (!arguments.frames.empty()) options.frames = rangeOf(arguments.frames);
  if (!arguments.part.empty()) options.part = partOf(arguments.part);
  const std::vector<SceneToRender> scenes = readScenes(arguments, options);
  options.stop = &catchInterrupts();
  const int atATime = arguments.atATime > 0 ? arguments.atATime : scenesAtATime(scenes);
  shareRasteriser(std::min(atATime, static_cast<int>(scenes.size())));
  return reportIfUnmet(renderScenes(scenes, options, atATime, arguments.style));
}

constexpr const char* kRenderFooter = R"(
Writes DIR/NAME.mp4 (or the videos that --format names), DIR/NAME.csv, DIR/NAME.json, DIR/NAME.poster.png and
DIR/NAME/frame_00000.png ..., where NAME is the scene file's; of a scene with cues DIR/NAME.vtt, its captions.
A scene with panels has a table for each, DIR/NAME_LABEL.csv; a grid a single one, a row for each book.
-o FILE, such as -o clip.mp4, makes that video alone of the frames; its table and poster are beside it,
named after it. -o clip.mp4 -o clip.gif makes both. -o DIR/ is a folder, also if its name has a dot.
-o - writes the pictures alone, of one scene, to the standard output, and nothing to the disk: as Y4M, with
--format png as one PNG after the other, with --format raw as rows of RGB, RGBA if they are transparent.
--grid shows up to 96 books, 12 a side, with other values of one key or two: the values of the first from
the left to the right, those of the second from the top to the bottom. 1..8 are whole numbers; a range of
others is as in scenes, { from = 0.001, to = 1.0, count = 8, scale = "log" }.
Other files stay as they are; those of the clip that were made with other settings are reported.
With --frames the MP4 is DIR/NAME_A-B.mp4, and the frames join those of earlier parts.
With --part there are only frames, which may be drawn on several machines at the same time; --resume
without --part joins them, draws what is missing, makes the other files and checks what is expected.
Whatever stops a render, it keeps the frames that are done; the same command with --resume goes on,
and its files are those of a render that never stopped.

Examples:
  rotatebook render scenes/starter.toml
  rotatebook render scenes/figures/fig05-unstable-x.toml --size 1920x1080 --no-png
  rotatebook render my.toml -o /tmp/clips --set simulation.model=matrix --set clip.duration=5
  rotatebook render my.toml --grid "initial.tilt=1e-2,1e-4,1e-6 x simulation.substeps=1..8"
  rotatebook render my.toml -o clip.mp4 -o clip.gif
  rotatebook render my.toml -o - | ffmpeg -colorspace bt709 -i - my.mkv
  rotatebook render my.toml --frames 0:60
  rotatebook render my.toml --part 3/16 --retry-status
  rotatebook render scenes/figures/*.toml --resume
  rotatebook render my.toml --format gif,apng --size 480x270 --no-png)";

}  // namespace

void addRenderCommand(CLI::App& program, Action& action) {
  constexpr const char* kClip = "Clip";
  auto [command, arguments] =
      addCommand(program, action, "render", "Render scenes to PNG frames, MP4 and CSV", render);
  command.add_option("SCENE", arguments.scenes, "Scene files")->required();
  repeated(addOption(command, "-o,--output", "DIR|FILE", arguments.outputs,
                     "Folder for the results, or a video to make, e.g. clip.mp4; several videos "
                     "of one name may be named; - is the standard output"))
      ->default_str("out");
  CLI::Option* frames = addOption(command, "--frames", "A:B", arguments.frames,
                                  "Only the frames from A up to, but not including, B", kClip);
  CLI::Option* noPng =
      command.add_flag("--no-png", arguments.noPng, "Write no PNG frames")->group(kClip);
  CLI::Option* format = addFormats(command, arguments.formats);
  addOption(command, "--part", "I/N", arguments.part,
            "Only the I-th of N parts, I from 1 to N: PNG frames alone, to be joined", kClip)
      ->excludes(frames)
      ->excludes(noPng)
      ->excludes(format);
  command.add_flag("--no-mp4", arguments.noMp4, "Write no MP4")->group(kClip);
  command.add_flag("--resume", arguments.options.earlier.resume,
                   "Go on where a render stopped, and skip what is done");
  command.add_flag("--overwrite", arguments.options.earlier.overwrite,
                   "Discard frames of an unfinished render; with --resume, only those of other "
                   "settings; with --frames, none");
  addOption(command, "-j,--jobs", "N", arguments.atATime,
            "Scenes to render at a time; by default two, or one for every 3 cores, as many as fit "
            "in a quarter of the memory")
      ->check(wholeNumber(1, 64));
  command.add_flag("--json", arguments.style.json,
                   "Print one JSON object: what was made and measured");
  command.add_flag("-v,--verbose", arguments.style.isDetailed,
                   "Say what draws and encodes, with how many threads");
  for (const char* name : {"--no-png", "--part", "--no-mp4", "--resume", "--overwrite", "--jobs",
                           "--json", "--verbose"}) {
    arguments.ofFiles.push_back(command.get_option(name));
  }
  arguments.sceneOptions.addTo(command);
  arguments.sceneOptions.addChecksum(command);
  addNoExpect(command, arguments.noExpect);
  arguments.deviceOptions.addTo(command);
  addRetryStatus(command);
  command.footer(kRenderFooter);
}

}  // namespace rotatebook::cli
