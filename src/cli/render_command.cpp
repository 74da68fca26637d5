#include <algorithm>
#include <iostream>
#include <memory>
#include <regex>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"
#include "base/number_text.h"
#include "cli/commands.h"
#include "cli/exit_code.h"
#include "cli/expectation_report.h"
#include "cli/file_report.h"
#include "cli/interrupt.h"
#include "cli/motion_report.h"
#include "cli/progress_line.h"
#include "cli/scene_options.h"
#include "pipeline/preflight.h"
#include "pipeline/render_clip.h"
#include "pipeline/simulate_scene.h"
#include "scene/nearest_name.h"

namespace rotatebook::cli {
namespace {

struct RenderArguments {
  std::vector<std::string> scenes;
  SceneOptions sceneOptions;
  std::string frames;
  bool noPng = false;
  std::vector<std::string> formats{"mp4"};
  bool noMp4 = false;
  pipeline::RenderOptions options;
};

pipeline::FrameRange parseRange(const std::string& text) {
  std::smatch match;
  if (!std::regex_match(text, match, std::regex("([0-9]{1,12}):([0-9]{1,12})"))) {
    throw InputError("--frames " + text +
                     ": not a range; write first:end, for example 0:60 for the first 60 frames");
  }
  return {std::stoll(match[1]), std::stoll(match[2])};
}

video::VideoFormat parseFormat(const std::string& name) {
  std::vector<std::string_view> names;
  for (const video::VideoFormat format : video::kVideoFormats) {
    if (name == nameOf(format)) return format;
    names.push_back(nameOf(format));
  }
  throw InputError("--format " + name + ": unknown; there are " + scene::quotedList(names, "and") +
                   scene::didYouMean(name, names));
}

std::vector<video::VideoFormat> formatsOf(const RenderArguments& arguments) {
  std::vector<video::VideoFormat> formats;
  for (const std::string& name : arguments.formats) {
    const video::VideoFormat format = parseFormat(name);
    const bool left = format == video::VideoFormat::Mp4 && arguments.noMp4;
    if (!left && std::ranges::count(formats, format) == 0) formats.push_back(format);
  }
  return formats;
}

/// Throws InputError if a video of a scene would lose its transparency.
void refuseOpaque(const scene::Scene& scene, const std::vector<video::VideoFormat>& formats) {
  if (!pipeline::isTransparent(scene)) return;
  for (const video::VideoFormat format : formats) {
    if (keepsTransparency(format)) continue;
    throw InputError(scene.name + ": " + std::string(nameOf(format)) +
                     " can't hold the transparent background of look.background; take --format "
                     "webm,apng, or --no-mp4 for PNGs alone");
  }
}

/// All scenes, read before anything is written, so that a mistake in the last one costs nothing.
std::vector<scene::Scene> readScenes(const RenderArguments& arguments) {
  std::vector<scene::Scene> scenes;
  for (const std::string& path : arguments.scenes) {
    scenes.push_back(arguments.sceneOptions.read(path));
    pipeline::preflight(scenes.back());
  }
  refuseSameNames(scenes);
  for (const scene::Scene& scene : scenes) refuseOpaque(scene, formatsOf(arguments));
  return scenes;
}

void announce(const scene::Scene& scene, const std::string& renderer, const std::string& encoder) {
  std::cout << scene.name << ": " << scene.title << '\n'
            << "  " << scene.clip.width << "x" << scene.clip.height << " at "
            << scene.clip.frameRate.text() << " frames/s, " << shortestText(scene.clip.duration)
            << " s; renderer " << renderer
            << (encoder.empty() ? std::string() : "; encoder " + encoder) << std::endl;
}

/// The words for each thing that a render left.
std::vector<std::string> writtenThings(const pipeline::RenderResult& result,
                                       const pipeline::RenderOptions& options) {
  const pipeline::ClipFiles& files = result.files;
  const bool newFolder = result.interrupted && !options.frames;
  std::vector<std::string> things;
  for (const video::VideoFormat format : options.formats) {
    if (result.framesWritten == 0) break;
    things.push_back(
        (result.interrupted ? files.partialVideo(format) : files.video(format)).string());
  }
  if (!result.interrupted) {
    for (const auto& csv : result.csvs) things.push_back(csv.string());
  }
  if (!result.interrupted && !options.frames) things.push_back(files.poster.string());
  if (options.png) {
    things.push_back(std::to_string(result.framesWritten) + " frames in " +
                     (newFolder ? files.partialFrameFolder : files.frameFolder).string() + '/');
  }
  return things;
}

int renderScene(const scene::Scene& scene, const pipeline::RenderOptions& options) {
  const pipeline::ClipMotion motion = pipeline::simulateScene(scene, options.stop);
  if (*options.stop) {
    std::cout << scene.name << ": interrupted while simulating; nothing was written" << std::endl;
    return interruptStatus();
  }
  pipeline::RenderResult result;
  {
    ProgressLine progress(scene.name);
    pipeline::RenderListener listener;
    listener.started = [&](const std::string& renderer, const std::string& encoder) {
      announce(scene, renderer, encoder);
    };
    listener.progress = [&](pipeline::RenderProgress now) { progress.update(now.done, now.total); };
    result = renderClip(scene, motion, options, listener);
  }
  reportFiles(writtenThings(result, options));
  if (result.interrupted) {
    std::cout << "  interrupted after " << result.framesWritten << " frames" << std::endl;
    return interruptStatus();
  }
  return reportMotions(scene, motion, std::cout);
}

int render(const RenderArguments& arguments) {
  pipeline::RenderOptions options = arguments.options;
  options.png = !arguments.noPng;
  options.formats = formatsOf(arguments);
  if (!arguments.frames.empty()) options.frames = parseRange(arguments.frames);
  const std::vector<scene::Scene> scenes = readScenes(arguments);
  options.stop = &catchInterrupts();
  int status = kDone;
  for (const scene::Scene& scene : scenes) {
    const int outcome = renderScene(scene, options);
    if (outcome >= kInterrupted) return outcome;
    status = std::max(status, outcome);
  }
  return sayIfUnmet(status);
}

}  // namespace

void addRenderCommand(CLI::App& program, Action& action) {
  auto arguments = std::make_shared<RenderArguments>();
  CLI::App* command = program.add_subcommand("render", "Render scenes to PNG frames, MP4 and CSV");
  command->add_option("SCENE", arguments->scenes, "Scene files")->required();
  command->add_option("-o,--output", arguments->options.folder, "Folder for the results")
      ->type_name("DIR")
      ->capture_default_str();
  arguments->sceneOptions.addTo(*command);
  command
      ->add_option("--frames", arguments->frames,
                   "Only the frames from A up to, but not including, B")
      ->type_name("A:B");
  command->add_flag("--no-png", arguments->noPng, "Write no PNG frames");
  command
      ->add_option("--format", arguments->formats,
                   "Videos to make, of mp4, webm, gif and apng, e.g. mp4,gif")
      ->type_name("NAME,...")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->capture_default_str();
  command->add_flag("--no-mp4", arguments->noMp4, "Write no MP4");
  command
      ->add_option("--png-level", arguments->options.pngOptions.level,
                   "PNG compression, 0 (fastest) to 9 (smallest)")
      ->check(CLI::Range(0, 9))
      ->capture_default_str();
  command->footer(R"(
Writes DIR/NAME.mp4 (or other videos, as --format has it), DIR/NAME.csv, DIR/NAME.poster.png and DIR/NAME/frame_00000.png ..., where NAME is
the scene file's.
A scene with panels has a table for each, DIR/NAME_LABEL.csv.
With --frames the MP4 is DIR/NAME_A-B.mp4, and the frames join those of earlier parts.

Examples:
  rotatebook render scenes/starter.toml
  rotatebook render scenes/figures/fig05-unstable-x.toml --size 1920x1080 --no-png
  rotatebook render my.toml -o /tmp/clips --set simulation.model=matrix --set clip.duration=5
  rotatebook render my.toml --frames 0:60
  rotatebook render my.toml --format gif,apng --size 480x270 --no-png)");
  command->callback([arguments, &action] { action = [arguments] { return render(*arguments); }; });
}

}  // namespace rotatebook::cli
