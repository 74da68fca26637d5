#include <algorithm>
#include <array>
#include <filesystem>
#include <iostream>
#include <numbers>
#include <string>
#include <system_error>

#include <Eigen/Core>
#include <fmt/ostream.h>

#include "base/error.h"
#include "base/json.h"
#include "base/number_text.h"
#include "base/text.h"
#include "cli/commands.h"
#include "cli/exit_code.h"
#include "cli/input_guard.h"
#include "cli/option_checks.h"
#include "cli/recordings.h"
#include "recording/toss.h"
#include "system/atomic_file.h"
#include "system/read_file.h"

namespace rotatebook::cli {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 2> kRatioNames{"I1/I3", "I2/I3"};

std::string digits4(double value) {
  return roundedText(value, 4);
}

std::string degreesASecond(double rate) {
  return roundedText(rate * 180 / std::numbers::pi, 3) + " deg/s";
}

Json ratioJson(const recording::Estimate& ratio) {
  return {{"value", ratio.value}, {"low", ratio.low}, {"high", ratio.high}};
}

/// Returns a sentence on what the intervals hold.
std::string intervalsText(const recording::TossFit& fit) {
  if (fit.noise == 0) {
    return "the intervals hold in 95 of 100 tosses by noise alone; without a rest before, other "
           "errors don't show";
  }
  const std::string residual = fmt::format("the residual is {} times the noise at rest",
                                           roundedText(fit.residual / fit.noise, 2));
  if (fit.widening > 1) {
    return fmt::format(
        "{}: the intervals that hold in 95 of 100 tosses by noise alone are widened by {}",
        residual, roundedText(fit.widening, 2));
  }
  return "the intervals hold in 95 of 100 tosses by noise alone; " + residual;
}

Json fitJson(const recording::TossFit& fit) {
  return {{"readings", fit.readings},
          {"I1_over_I3", ratioJson(fit.ratios[0])},
          {"I2_over_I3", ratioJson(fit.ratios[1])},
          {"inertia", matrixJson(fit.inertia)},
          {"angular_velocity", vectorJson(fit.start)},
          {"bias", vectorJson(fit.bias)},
          {"rest_s", fit.rest},
          {"residual", fit.residual},
          {"noise", fit.noise},
          {"widening", fit.widening},
          {"gap", fit.gap},
          {"notes", fit.notes}};
}

Json throwJson(const recording::Throw& one) {
  Json object{{"from_s", one.from},
              {"to_s", one.to},
              {"spin", one.spin},
              {"flight", one.isFlight},
              {"accepted", one.fit.has_value()}};
  object.update(one.fit ? fitJson(*one.fit) : Json{{"refusal", one.refusal}});
  return object;
}

/// Returns the keys of [simulation] that state what `options` does.
std::string statedKeys(const recording::ReadOptions& options) {
  std::string text;
  if (!options.timeUnit.empty()) text += "time_unit = " + quotedText(options.timeUnit) + "\n";
  if (!options.unit.empty()) text += "rates = " + quotedText(options.unit) + "\n";
  if (options.columns.empty()) return text;
  return text + "columns = { " +
         joinedOf(options.columns,
                  [](const auto& one) { return one.first + " = " + quotedText(one.second); }) +
         " }\n";
}

/// Prints the flight, the ratios of the moments with their intervals, and the fit's residual;
/// `name` is the recording's.
void reportToss(const recording::TossFit& fit, const std::string& name, std::ostream& out) {
  fmt::print(out, "{}: flight from {} to {} s, {} readings\n", oneLine(name),
             recording::timeText(fit.from), recording::timeText(fit.to), fit.readings);
  for (std::size_t i = 0; i < fit.ratios.size(); ++i) {
    const recording::Estimate& ratio = fit.ratios[i];
    fmt::print(out, "  {} = {}, {} to {}\n", kRatioNames[i], roundedText(ratio.value, 6),
               roundedText(ratio.low, 6), roundedText(ratio.high, 6));
  }
  fmt::print(out,
             "  {}\n  the fitted motion differs by {} (root mean square) of {}; gap of singular "
             "values {}\n",
             intervalsText(fit), degreesASecond(fit.residual), degreesASecond(fit.spin),
             roundedText(fit.gap, 3));
  if (fit.rest > 0) {
    fmt::print(out, "  bias {}, from {} s of rest before\n", degreesASecond(fit.bias.norm()),
               digits4(fit.rest));
  } else if (fit.isMeasured) {
    out << "  no rest before the flight: the gyroscope's bias isn't subtracted, and the intervals "
           "leave it out\n";
  }
  for (const std::string& note : fit.notes) fmt::print(out, "  note: {}\n", note);
}

void reportTossAsJson(const recording::TossFit& fit, const std::string& name, std::ostream& out) {
  Json object{{"name", name}, {"from_s", fit.from}, {"to_s", fit.to}};
  object.update(fitJson(fit));
  out << jsonLine(object);
}

/// Prints a line for each throw of a recording: its time and spin, and its ratios or why it is
/// refused.
void reportThrows(const std::vector<recording::Throw>& throws, const std::string& name,
                  std::ostream& out) {
  const auto flights = std::ranges::count(throws, true, &recording::Throw::isFlight);
  fmt::print(out, "{}: {}", oneLine(name), countText(flights, "flight"));
  if (throws.empty()) {
    fmt::print(out, ", as the body never turns faster than {} for {} s",
               degreesASecond(recording::kSlowestThrow), roundedText(recording::kShortestThrow, 2));
  }
  out << '\n';
  for (const recording::Throw& one : throws) {
    fmt::print(out, "  from {} to {}, {} s at {}: ", recording::timeText(one.from),
               recording::timeText(one.to), roundedText(one.to - one.from, 2),
               degreesASecond(one.spin));
    if (!one.fit) {
      // Each refusal begins with the recording's name.
      const bool isNamed = one.refusal.starts_with(name + ": ");
      fmt::print(out, "refused: {}\n", one.refusal.substr(isNamed ? name.size() + 2 : 0));
      continue;
    }
    fmt::print(out, "I1/I3 = {}, I2/I3 = {}\n", digits4(one.fit->ratios[0].value),
               digits4(one.fit->ratios[1].value));
    for (const std::string& note : one.fit->notes) fmt::print(out, "    note: {}\n", note);
  }
}

void reportThrowsAsJson(const std::vector<recording::Throw>& throws, const std::string& name,
                        std::ostream& out) {
  out << jsonLine({{"name", name}, {"throws", arrayOf(throws, throwJson)}});
}

/// Returns a scene of the toss: the recording beside the exact motion from its fitted start, at a
/// tenth of its speed. `file` is the recording's path from the scene's folder, `options` what the
/// command line stated about it.
std::string tossScene(const recording::TossFit& fit, const std::string& file,
                      const recording::ReadOptions& options) {
  constexpr double kSpeed = 0.1;
  // As large as the default book's, which is drawn.
  constexpr double kLargestMoment = 0.009988;  // [kg m^2]
  constexpr double kFramesASecond = 60;
  // The last frame is within the flight.
  const double duration = (fit.to - fit.from) / kSpeed - 1 / kFramesASecond;
  return fmt::format(
      R"(title = "A toss, as measured"
caption = "The outline is the exact motion of the inertia that the toss tells."

[body]
inertia = {}

[clip]
speed = {}
duration = {}

[overlay]
show = ["caption", "clock", "half_turns", "ghost", "error"]

[[panel]]
label = "measured"
[panel.simulation]
model = "recorded"
file = {}
from = {}
to = {}
bias = {}
{}
[[panel]]
label = "exact"
[panel.simulation]
model = "exact"
[panel.initial]
angular_velocity = {}
)",
      jsonText(matrixJson(kLargestMoment * fit.inertia)), shortestText(kSpeed),
      roundedText(duration, 6), quotedText(file), shortestText(fit.from), shortestText(fit.to),
      jsonText(vectorJson(fit.bias)), statedKeys(options), jsonText(vectorJson(fit.start)));
}

struct TossArguments {
  std::string file, acceleration, scene;
  RecordingOptions recording;
  recording::TossOptions options;
  const CLI::Option* lever = nullptr;
  bool list = false;
  bool json = false;
};

/// Returns the recording's path from the scene's folder, in which it must be.
std::string pathFrom(const fs::path& scene, const fs::path& recording) {
  if (scene.extension() != ".toml") {
    throw InputError(scene.string() + ": the name of a scene's file ends in .toml");
  }
  std::error_code error;
  const fs::path folder = scene.parent_path().empty() ? "." : scene.parent_path();
  const fs::path path = fs::relative(recording, folder, error);
  if (error || path.empty() || *path.begin() == "..") {
    throw InputError(fmt::format(
        "{}: a scene reads nothing from outside its folder, where {} isn't; write it beside the "
        "recording",
        scene.string(), recording.string()));
  }
  return path.generic_string();
}

/// Returns the recording's path from the scene to write; empty if none is to be written.
std::string pathInScene(const TossArguments& arguments, const RecordingFiles& files) {
  if (arguments.scene.empty()) return "";
  if (files.path.empty()) {
    throw InputError(fmt::format("{}: a scene reads no archive; unpack {}, and toss the folder",
                                 arguments.scene, arguments.file));
  }
  if (files.path == system::kStandardInput) {
    throw InputError(
        fmt::format("{}: a scene reads a file; save the recording, and toss that instead of -",
                    arguments.scene));
  }
  requireAbsent(arguments.scene);
  return pathFrom(arguments.scene, files.path);
}

/// Throws InputError if --lever is given where no flight is searched by an accelerometer.
void refuseIdleLever(const TossArguments& arguments, bool hasForce) {
  if (arguments.lever->count() == 0) return;
  const recording::ReadOptions& stated = arguments.recording.options;
  if (!stated.from && !stated.to && hasForce) return;
  throw InputError(
      fmt::format("--lever is for the search for the flight by an accelerometer, {}; leave it out",
                  hasForce ? "and --from and --to state it" : "and the recording has none"));
}

int fitAndReport(const TossArguments& arguments) {
  const recording::ReadOptions options = arguments.recording.read();
  RecordingFiles files = openRecording(arguments.file, arguments.acceleration, options);
  const std::string path = pathInScene(arguments, files);
  recording::TossOptions toss = arguments.options;
  toss.from = options.from;
  toss.to = options.to;
  const recording::InertialRecording recording = recording::readInertial(
      files.motion.bytes, files.motion.name, options, files.accelerationTable());
  refuseIdleLever(arguments, recording.hasForce);
  if (arguments.list) {
    (arguments.json ? reportThrowsAsJson : reportThrows)(
        recording::findThrows(recording, files.motion.name, toss), files.motion.name, std::cout);
    return kDone;
  }
  const recording::TossFit fit = recording::fitToss(recording, files.motion.name, toss);
  (arguments.json ? reportTossAsJson : reportToss)(fit, files.motion.name, std::cout);
  if (path.empty()) return kDone;
  system::writeFileAtomically(arguments.scene, tossScene(fit, path, options));
  if (!arguments.json) fmt::print(std::cout, "wrote {}\n", oneLine(arguments.scene));
  return kDone;
}

}  // namespace

void addTossCommand(CLI::App& program, Action& action) {
  auto [command, arguments] =
      addCommand(program, action, "toss",
                 "Find a body's inertia from the gyroscope that flew with it", fitAndReport);
  command
      .add_option(
          "FILE", arguments.file,
          "Table of the rates (CSV), or a phone's export: a folder, or ZIP; - is the standard "
          "input")
      ->required();
  CLI::Option* const acceleration =
      addOption(command, "--acceleration", "FILE", arguments.acceleration,
                "Table of the accelerometer's readings, with gravity, at times of its own");
  CLI::Option* const scene =
      addOption(command, "-o,--output", "FILE", arguments.scene,
                "Scene to write, beside the recording: as measured, and exact");
  command
      .add_flag("--list", arguments.list,
                "List the flights that the rates alone show, and what each tells")
      ->excludes(scene)
      ->excludes(acceleration);
  command.add_flag("--json", arguments.json, "Print one JSON object");
  arguments.lever = addOption(command, "--lever", "METRES", arguments.options.lever,
                              "Largest distance of the accelerometer from the centre of mass")
                        ->check(notNegative)
                        ->capture_default_str()
                        ->excludes("--list");
  arguments.recording.addTo(command);
  command.footer(R"(
Prints the ratios of the principal moments with intervals that hold in 95 of 100 tosses by noise
alone, wider where the residual shows other errors. The flight is found by the accelerometer's columns,
or without them by the rates alone if there is one throw; else state it with --from and --to.

Examples:
  rotatebook toss phyphox.zip
  rotatebook toss Gyroscope.csv --acceleration Accelerometer.csv
  rotatebook toss racket.csv --list
  rotatebook toss toss.csv --from 1.2 --to 2.0 -o toss.toml)");
}

}  // namespace rotatebook::cli
