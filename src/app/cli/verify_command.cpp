#include <cstdint>
#include <filesystem>
#include <iostream>
#include <memory>
#include <string>

#include "cli/clip_options.h"
#include "cli/commands.h"
#include "cli/device_options.h"
#include "cli/exit_code.h"
#include "cli/progress_line.h"
#include "report/verify_report.h"

namespace rotatebook::cli {
namespace {

struct VerifyArguments {
  std::filesystem::path clip;
  verify::VerifyOptions options;
  DeviceOptions deviceOptions;
  bool json = false;
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

int verify(const VerifyArguments& arguments) {
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
  command->add_flag("--all", arguments->options.allFrames, "Compare all pictures")
      ->excludes(frames);
  addTextureOptions(*command, arguments->options.textures);
  arguments->deviceOptions.addTo(*command);
  command->add_flag("--json", arguments->json, "Print one JSON object");
  command->footer(R"(
Takes the scene from the clip's metadata, simulates it again and compares the motion, bit by bit; draws
frames of it again and compares them with the clip's pictures, which must not be closer to the frame
before or after; checks size, codec, colours, how the file has players crop, turn, stretch, deinterlace
and time the pictures, number of frames, time stamps and duration. Only the pictures that were compared
are proved: all of them with --all. How closely they must agree follows from the stream's quantisers; one
that is coded coarsely is consistent at best. The last line says what the proof is worth.
If the clip was made with another renderer, FFmpeg or version, a note says so, as pixels may differ then.

Exit status: 0 all is proved, 1 a check failed, 2 the file can't be read, ends early or isn't a clip of
rotatebook, 3 the machine can't draw, 4 nothing fails, but the stream is too coarse to prove it.

Examples:
  rotatebook verify out/starter.mp4
  rotatebook verify out/starter.mp4 --all --json | python3 -m json.tool
  rotatebook verify clips/cover.webm --frames 0,60 --scene-folder scenes)");
  command->callback([arguments, &action] { action = [arguments] { return verify(*arguments); }; });
}

}  // namespace rotatebook::cli
