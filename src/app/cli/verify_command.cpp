#include <cstdint>
#include <filesystem>
#include <initializer_list>
#include <iostream>
#include <memory>
#include <string>

#include "cli/clip_options.h"
#include "cli/commands.h"
#include "cli/device_options.h"
#include "cli/exit_code.h"
#include "cli/progress_line.h"
#include "cli/rerun.h"
#include "report/verify_report.h"

namespace rotatebook::cli {
namespace {

struct VerifyArguments {
  std::filesystem::path clip;
  verify::VerifyOptions options;
  DeviceOptions deviceOptions;
  bool json = false;
  RerunArguments again;
};

int statusOf(verify::Verdict verdict) {
  switch (verdict) {
    case verify::Verdict::Proved:
      return kDone;
    case verify::Verdict::Coarse:
      return kCoarse;
    case verify::Verdict::NotProved:
      return kUnmet;
  }
  return kUnmet;
}

int makeAgain(const VerifyArguments& arguments) {
  RerunArguments again = arguments.again;
  again.clip = arguments.clip;
  again.textures = arguments.options.textures;
  again.deviceOptions = arguments.deviceOptions;
  return rerun(again);
}

int verify(const VerifyArguments& arguments) {
  if (!arguments.again.folder.empty()) return makeAgain(arguments);
  verify::VerifyOptions options = arguments.options;
  options.device = arguments.deviceOptions.choice();
  verify::Verification found;
  {
    ProgressLine progress(arguments.clip.string());
    options.progress = [&](pipeline::RenderProgress now) { progress.update(now.done, now.total); };
    found = verify::verifyClip(arguments.clip, options);
  }
  (arguments.json ? report::reportVerificationAsJson : report::reportVerification)(
      arguments.clip, found, std::cout);
  return statusOf(found.verdict());
}

/// Adds --again and what belongs to it; it takes none of `others`.
void addAgain(CLI::App& command, RerunArguments& again,
              std::initializer_list<CLI::Option*> others) {
  CLI::Option* option =
      command
          .add_option("--again", again.folder,
                      "Make the clip again from its record, in this folder, and compare the bytes")
          ->type_name("DIR");
  for (CLI::Option* other : others) option->excludes(other);
  command.add_flag("--png", again.png, "Write PNG frames, too")->needs(option);
  command.add_flag("--resume", again.earlier.resume, "Go on where --again stopped")->needs(option);
  command
      .add_flag("--overwrite", again.earlier.overwrite,
                "Replace another scene's clip of the same name, and discard frames of an "
                "unfinished render")
      ->needs(option);
}

}  // namespace

void addVerifyCommand(CLI::App& program, Action& action) {
  constexpr std::int64_t kMax = 1'000'000;
  auto arguments = std::make_shared<VerifyArguments>();
  CLI::App* command =
      program.add_subcommand("verify", "Prove that a clip shows what it was made from");
  addClip(*command, arguments->clip);
  CLI::Option* frames =
      command
          ->add_option("--frames", arguments->options.frames,
                       "Frames whose pictures are compared, e.g. 0,10,20; by default one of each "
                       "sixth of the clip, chosen by the motion's checksum")
          ->type_name("N,...")
          ->delimiter(',')
          ->check(CLI::Range(std::int64_t{0}, kMax))
          ->allow_extra_args(false);
  CLI::Option* all =
      command->add_flag("--all", arguments->options.allFrames, "Compare all pictures");
  all->excludes(frames);
  CLI::Option* json = command->add_flag("--json", arguments->json, "Print one JSON object");
  addAgain(*command, arguments->again, {frames, all, json});
  addTextureOptions(*command, arguments->options.textures);
  arguments->deviceOptions.addTo(*command);
  command->footer(R"(
Takes the scene from the clip's metadata, simulates it again and compares the motion, bit by bit; draws
frames of it again and compares them with the clip's pictures, which must not be closer to the frame
before or after; checks size, codec, colours, how the file has players crop, turn, stretch, deinterlace
and time the pictures, number of frames, time stamps and duration. Only the pictures that were compared
are proved: all of them with --all. How closely they must agree follows from the stream's quantisers; one
that is coded coarsely is consistent at best. The last line says what the proof is worth.
If the clip was made with another renderer, FFmpeg or version, a note says so, as pixels may differ then.
With --again the clip is made anew as 'rotatebook render' does it, and what differs is said. The clip
itself is never replaced, nor another scene's of its name without --overwrite.

Exit status: 0 all is proved, or the same bytes; 1 a check failed, or other bytes; 2 the file can't be read, ends early or isn't a clip of
rotatebook, 3 the machine can't draw, 4 nothing fails, but the stream is too coarse to prove it.

Examples:
  rotatebook verify out/starter.mp4
  rotatebook verify out/starter.mp4 --all --json | python3 -m json.tool
  rotatebook verify clips/cover.webm --frames 0,60 --scene-folder scenes
  rotatebook verify out/starter.mp4 --again again)");
  command->callback([arguments, &action] { action = [arguments] { return verify(*arguments); }; });
}

}  // namespace rotatebook::cli
