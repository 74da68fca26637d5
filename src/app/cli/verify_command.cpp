#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <initializer_list>
#include <iostream>
#include <ranges>
#include <string>

#include <fmt/ostream.h>

#include "base/json.h"
#include "base/number_text.h"
#include "base/text.h"
#include "cli/clip_options.h"
#include "cli/commands.h"
#include "cli/device_options.h"
#include "cli/exit_code.h"
#include "cli/option_checks.h"
#include "cli/progress_line.h"
#include "cli/render_scenes.h"
#include "pipeline/verify/verify_clip.h"

namespace rotatebook::cli {
namespace {

using pipeline::ClipCheck;
using pipeline::PictureCheck;
using pipeline::Verification;

constexpr int kAlwaysShown = 2;  // Of the measures: these have their place in each line.

std::string checkText(const ClipCheck& check) {
  return fmt::format("  {:<8}{:<13}{} ({})\n", check.passed ? "ok" : "FAILED", check.what,
                     check.measured,
                     check.measured == check.wanted ? "as it must be" : check.wanted);
}

std::string numberText(double value) {
  return roundedText(value, 3);
}

/// Returns "brightness or contrast changed by 1.1 (at most 0.4)", and whatever else is too large.
std::string excessOf(const PictureCheck& check) {
  std::string text;
  for (const pipeline::MeasureRow& row : pipeline::kMeasures | std::views::drop(kAlwaysShown)) {
    const double measured = check.measured.*row.value, bound = check.bound.*row.value;
    if (measured <= bound) continue;
    text +=
        fmt::format("; {} by {} (at most {})", row.text, numberText(measured), numberText(bound));
  }
  return text;
}

/// Converts to a check that is printed like the others.
ClipCheck asClipCheck(const PictureCheck& check) {
  std::string measured =
      fmt::format("off by {} of 255, {} in the worst block{}", numberText(check.measured.rms),
                  numberText(check.measured.worstBlock), excessOf(check));
  if (check.closerTo) measured += fmt::format("; it is closer to frame {}", *check.closerTo);
  return {fmt::format("frame {}", check.frame), measured,
          fmt::format("at most {} and {}", numberText(check.bound.rms),
                      numberText(check.bound.worstBlock)),
          check.passed()};
}

std::string framesText(const Verification& found) {
  if (!found.record.part) return fmt::format("{} frames", found.wholeCount);
  return fmt::format("frames {} of {}", rangeText(found.range), found.wholeCount);
}

/// Returns "0, 12, 25"; of many only the first.
std::string framesCompared(const Verification& found) {
  constexpr std::size_t kMaxNamed = 12;
  return joinedOf(found.pictures | std::views::take(kMaxNamed),
                  [](const PictureCheck& check) { return std::to_string(check.frame); }) +
         (found.pictures.size() > kMaxNamed ? ", ..." : "");
}

std::string picturesCompared(const Verification& found) {
  return fmt::format("{} of {} pictures", found.pictures.size(), found.range.count());
}

std::string proofText(const Verification& found) {
  if (std::ssize(found.pictures) == found.range.count()) {
    return fmt::format("Proved: the motion and all {} pictures are those of the scene.",
                       found.pictures.size());
  }
  return fmt::format(
      "Proved for {} ({}): they and the motion are those of the scene; --all compares every "
      "picture.",
      picturesCompared(found), framesCompared(found));
}

/// Returns how well the stream is coded: with as many digits as show on which side of the limit.
std::string quantiserText(const Verification& found) {
  if (!found.quantiser) return "its quantiser isn't measured";
  const bool isNear = std::abs(*found.quantiser - pipeline::kCoarsestProof) < 1;
  const bool isCoarse = found.verdict() == pipeline::Verdict::Coarse;
  return fmt::format("coded at a mean quantiser of {} of 51{}",
                     roundedText(*found.quantiser, isNear ? 5 : 3),
                     isCoarse ? ", above " + numberText(pipeline::kCoarsestProof) : "");
}

/// Returns how well the stream is coded, and the smallest changes that are noticed for sure.
std::string worthText(const Verification& found) {
  const pipeline::Deviation bound = found.unnoticed();
  return fmt::format(
      "Worth: {}; changes of up to {} in 16x16 pixels, {} on average in 32x32, {} in brightness "
      "and {} in colour (of 255), and shifts of {} pixels may pass unnoticed.",
      quantiserText(found), numberText(bound.worstBlock),
      numberText(std::max(bound.lumaPatch, bound.chromaPatch)), numberText(bound.brightness),
      numberText(bound.colour), numberText(bound.shift));
}

std::string verdictText(const Verification& found) {
  switch (found.verdict()) {
    case pipeline::Verdict::Proved:
      return proofText(found) + "\n" + worthText(found);
    case pipeline::Verdict::Coarse:
      return fmt::format(
          "Consistent, coarsely: the motion is that of the scene, and {} may be, but the stream is "
          "coded too coarsely to prove it.\n{}",
          picturesCompared(found), worthText(found));
    case pipeline::Verdict::Motion:
      return "Motion proved: it is that of the scene, bit for bit. The pictures are a browser's "
             "own, "
             "which can't be compared.";
    case pipeline::Verdict::NotProved:
      return fmt::format("NOT PROVED: {} failed; {} were compared.",
                         countText(found.failures(), "check"), picturesCompared(found));
  }
  return "";
}

/// A verdict's word in JSON, and the command's status.
struct VerdictRow {
  const char* word;
  ExitCode status;
};

VerdictRow rowOf(pipeline::Verdict verdict) {
  switch (verdict) {
    case pipeline::Verdict::Proved:
      return {"proved", kDone};
    case pipeline::Verdict::Coarse:
      return {"consistent, coarsely", kCoarse};
    case pipeline::Verdict::Motion:
      return {"motion proved", kCoarse};
    case pipeline::Verdict::NotProved:
      break;
  }
  return {"not proved", kUnmet};
}

Json json(const ClipCheck& check) {
  return {{"check", check.what},
          {"passed", check.passed},
          {"measured", check.measured},
          {"wanted", check.wanted}};
}

Json json(const pipeline::Deviation& deviation) {
  Json object;
  for (const pipeline::MeasureRow& row : pipeline::kMeasures) {
    object[row.name] = deviation.*row.value;
  }
  return object;
}

Json json(const PictureCheck& check) {
  return {{"frame", check.frame},         {"passed", check.passed()},
          {"quantiser", check.quantiser}, {"measured", json(check.measured)},
          {"bound", json(check.bound)},   {"closer_to", orNull(check.closerTo)}};
}

Json json(const store::Provenance& provenance) {
  return {{"scene", provenance.scene},
          {"version", provenance.program},
          {"renderer", provenance.renderer},
          {"ffmpeg", provenance.ffmpeg}};
}

Json json(store::FrameRange range) {
  return Json::array({range.first, range.end});
}

/// Prints what made the clip, a line for each check with what was measured beside its bound, and a
/// verdict. `clip` is the file's name.
void reportVerification(const std::string& clip, const Verification& found, std::ostream& out) {
  const store::Provenance& provenance = found.record.provenance;
  fmt::print(out, "{}: claims to be {} of the scene {}, made by rotatebook {}\n", oneLine(clip),
             framesText(found), provenance.scene, provenance.program);
  for (const std::string& difference : found.toolsDiffer)
    fmt::print(out, "  note    {}; pixels may differ\n", difference);
  for (const ClipCheck& check : found.checks) out << checkText(check);
  for (const PictureCheck& check : found.pictures) out << checkText(asClipCheck(check));
  fmt::print(out, "{}\n", verdictText(found));
}

/// Prints the same as one JSON object on one line.
void reportVerificationAsJson(const std::string& clip, const Verification& found,
                              std::ostream& out) {
  const auto asJson = [](const auto& check) { return json(check); };
  out << jsonLine({{"clip", clip},
                   {"proved", found.verdict() == pipeline::Verdict::Proved},
                   {"verdict", rowOf(found.verdict()).word},
                   {"quantiser", orNull(found.quantiser)},
                   {"made_with", json(found.record.provenance)},
                   {"frames", json(found.range)},
                   {"whole_frames", found.wholeCount},
                   {"tools_differ", found.toolsDiffer},
                   {"checks", arrayOf(found.checks, asJson)},
                   {"pictures", arrayOf(found.pictures, asJson)}});
}

struct VerifyArguments {
  std::filesystem::path clip;
  pipeline::VerifyOptions options;
  DeviceOptions deviceOptions;
  bool json = false;
  RerunArguments again;
};

int makeAgain(const VerifyArguments& arguments) {
  RerunArguments again = arguments.again;
  again.clip = arguments.clip;
  again.textures = arguments.options.textures;
  again.deviceOptions = arguments.deviceOptions;
  return rerun(again);
}

int verify(const VerifyArguments& arguments) {
  if (!arguments.again.folder.empty()) return makeAgain(arguments);
  pipeline::VerifyOptions options = arguments.options;
  options.device = arguments.deviceOptions.choice();
  pipeline::Verification found;
  {
    ProgressLine progress(arguments.clip.string());
    options.progress = [&](pipeline::RenderProgress now) { progress.update(now.done, now.total); };
    found = pipeline::verifyClip(arguments.clip, options);
  }
  (arguments.json ? reportVerificationAsJson : reportVerification)(arguments.clip, found,
                                                                   std::cout);
  return rowOf(found.verdict()).status;
}

/// Adds --again and what belongs to it; it takes none of `others`.
void addAgain(CLI::App& command, RerunArguments& again,
              std::initializer_list<CLI::Option*> others) {
  CLI::Option* option =
      addOption(command, "--again", "DIR", again.folder,
                "Make the clip again from its record, in this folder, and compare the bytes");
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
  auto [command, arguments] = addCommand(program, action, "verify",
                                         "Prove that a clip shows what it was made from", verify);
  addClip(command, arguments.clip);
  CLI::Option* frames =
      addOption(command, "--frames", "N,...", arguments.options.frames,
                "Frames whose pictures are compared, e.g. 0,10,20; by default one of each "
                "sixth of the clip, chosen by the motion's checksum")
          ->delimiter(',')
          ->check(wholeNumber(0, kMax))
          ->allow_extra_args(false);
  CLI::Option* all = command.add_flag("--all", arguments.options.allFrames, "Compare all pictures");
  all->excludes(frames);
  CLI::Option* json = command.add_flag("--json", arguments.json, "Print one JSON object");
  addAgain(command, arguments.again, {frames, all, json});
  addTextureOptions(command, arguments.options.textures);
  arguments.deviceOptions.addTo(command);
  command.footer(R"(
Takes the scene from the clip's metadata, simulates it again and compares the motion, bit by bit; draws
frames of it again and compares them with the clip's pictures, which must not be closer to the frame
before or after; checks size, codec, colours, how the file has players crop, turn, stretch, deinterlace
and time the pictures, number of frames, time stamps and duration. Only the pictures that were compared
are proved: all of them with --all. How closely they must agree follows from the stream's quantisers; one
that is coded coarsely is consistent at best. The last line says what the proof is worth. Of a clip that
the live book saved in a browser only the motion is proved.
If the clip was made with another renderer, FFmpeg or version, a note says so, as pixels may differ then.
With --again the clip is made anew as 'rotatebook render' does it, and what differs is said. The clip
itself is never replaced, nor another scene's of its name without --overwrite.

Exit status: 0 all is proved, or the same bytes; 1 a check failed, or other bytes; 2 the file can't be read, ends early or isn't a clip of
rotatebook, 3 the machine can't draw, 4 nothing fails, but the stream is too coarse to prove it,
or the pictures are a browser's.

Examples:
  rotatebook verify out/starter.mp4
  rotatebook verify out/starter.mp4 --all --json | python3 -m json.tool
  rotatebook verify clips/cover.webm --frames 0,60 --scene-folder scenes
  rotatebook verify out/starter.mp4 --again again)");
}

}  // namespace rotatebook::cli
