#include <filesystem>
#include <iostream>
#include <optional>
#include <string>
#include <vector>

#include <fmt/ostream.h>

#include "base/error.h"
#include "base/frame_rate.h"
#include "base/text.h"
#include "cli/clip_options.h"
#include "cli/commands.h"
#include "cli/exit_code.h"
#include "cli/input_guard.h"
#include "cli/option_checks.h"
#include "cli/progress_line.h"
#include "pipeline/assemble.h"
#include "store/clip_files.h"

namespace rotatebook::cli {
namespace {

struct AssembleArguments {
  std::string folder, output, frameRate;
  bool whole = false;
};

/// Throws InputError if the video would replace what it is made from.
void refuseFrames(const AssembleArguments& arguments) {
  const std::filesystem::path folder = arguments.folder;
  if (!std::filesystem::is_directory(folder)) return;
  std::vector<Input> inputs{{folder / store::kSceneCopyName, "the frames' record"},
                            {folder / store::kManifestName, "the frames' manifest"},
                            {folder / store::kFrameChecksumsName, "the frames' checksums"}};
  for (const std::string& name : store::partChecksumsIn(folder))
    inputs.push_back({folder / name, "the checksums of some frames"});
  for (const std::int64_t frame : store::framesIn(folder)) {
    inputs.push_back({folder / store::frameName(frame), "one of the frames"});
  }
  refuseInputs(arguments.output, inputs);
}

/// Returns, for example, ": 0:60 of the scene's 90".
std::string partText(const pipeline::Assembled& made) {
  return fmt::format(": {} of the scene's {}", store::rangeText(made.frames), *made.sceneFrames);
}

int assembleFrames(const AssembleArguments& arguments) {
  const std::optional<FrameRate> rate = parseFrameRate(arguments.frameRate);
  if (!rate && !arguments.frameRate.empty()) {
    throw InputError(fmt::format("--fps {}: not a frame rate; write for example 60 or 30000/1001",
                                 arguments.frameRate));
  }
  refuseFrames(arguments);
  pipeline::Assembled made;
  {
    ProgressLine progress(arguments.output);
    made = pipeline::assemble(
        arguments.folder, arguments.output, rate,
        [&](pipeline::RenderProgress now) { progress.update(now.done, now.total); },
        arguments.whole);
  }
  if (made.unlisted > 0) {
    fmt::print(
        std::cerr,
        "note: {} of them without a checksum in {}: whole PNGs, but maybe not as they were drawn\n",
        countText(made.unlisted, "frame"), store::kFrameChecksumsName);
  }
  for (const pipeline::LostColours& lost : made.lost) {
    fmt::print(std::cerr, "note: {} {} {}\n", countText(lost.frames, "frame"),
               lost.frames == 1 ? "has" : "have", lost.text);
  }
  fmt::print(std::cout, "wrote {} to {}{}\n", countText(made.frames.count(), "frame"),
             oneLine(arguments.output), made.isPart() ? partText(made) : "");
  return kDone;
}

}  // namespace

void addAssembleCommand(CLI::App& program, Action& action) {
  auto [command, arguments] = addCommand(
      program, action, "assemble", "Make a video from PNG frames on the disk", assembleFrames);
  command.add_option("DIR", arguments.folder, "Folder with frame_00000.png ...")
      ->required()
      ->check(notStandardInput);
  addOption(command, "-o,--output", "FILE", arguments.output,
            "Video to write: " + listFormats(&video::FormatRow::ending, "or"))
      ->required();
  addOption(command, "--fps", "RATE", arguments.frameRate,
            "Frame rate, e.g. 60 or 30000/1001; only where DIR has no scene.toml");
  command.add_flag("--whole", arguments.whole,
                   "Write nothing unless all frames of the scene are there");
  addRetryStatus(command);
  command.footer(R"(
With the scene.toml that a render leaves beside its frames, this writes the same bytes as the render.
If a frame is missing or no longer has its checksum in frames.xxh128, nothing is written: render with
--resume, which draws the frame again, or remove frames.xxh128 to join the frames as they are. A frame
without a checksum there is joined if it is a whole PNG, and reported. The folder of a whole clip that is
still being rendered is refused, too. If only parts of a clip are there, the frames that were joined are
reported; with --whole nothing is written. Frames are read as sRGB of 8 bits a channel, and reported where
they are of another kind; transparency that the video would lose is refused.

Example:
  rotatebook assemble out/starter -o starter.mp4)");
}

}  // namespace rotatebook::cli
