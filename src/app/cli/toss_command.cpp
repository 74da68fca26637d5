#include <filesystem>
#include <iostream>
#include <memory>
#include <string>
#include <system_error>

#include "base/error.h"
#include "base/text.h"
#include "cli/commands.h"
#include "cli/exit_code.h"
#include "cli/input_guard.h"
#include "cli/recording_files.h"
#include "cli/recording_options.h"
#include "recording/toss.h"
#include "report/toss_report.h"
#include "system/atomic_file.h"

namespace rotatebook::cli {
namespace {

namespace fs = std::filesystem;

struct TossArguments {
  std::string file, acceleration, scene;
  RecordingOptions recording;
  recording::TossOptions options;
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
    throw InputError(scene.string() + ": a scene reads nothing from outside its folder, where " +
                     recording.string() + " isn't; write it beside the recording");
  }
  return path.generic_string();
}

/// Returns the recording's path from the scene to write; empty if none is to be written.
std::string pathInScene(const TossArguments& arguments, const RecordingFiles& files) {
  if (arguments.scene.empty()) return "";
  if (files.path.empty()) {
    throw InputError(arguments.scene + ": a scene reads no archive; unpack " + arguments.file +
                     ", and toss the folder");
  }
  requireAbsent(arguments.scene);
  return pathFrom(arguments.scene, files.path);
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
  if (arguments.list) {
    (arguments.json ? report::reportThrowsAsJson : report::reportThrows)(
        recording::findThrows(recording, files.motion.name, toss), files.motion.name, std::cout);
    return kDone;
  }
  const recording::TossFit fit = recording::fitToss(recording, files.motion.name, toss);
  (arguments.json ? report::reportTossAsJson : report::reportToss)(fit, files.motion.name,
                                                                   std::cout);
  if (path.empty()) return kDone;
  system::writeFileAtomically(arguments.scene, report::tossScene(fit, path, options));
  if (!arguments.json) std::cout << "wrote " << oneLine(arguments.scene) << '\n';
  return kDone;
}

}  // namespace

void addTossCommand(CLI::App& program, Action& action) {
  auto arguments = std::make_shared<TossArguments>();
  CLI::App* command =
      program.add_subcommand("toss", "Find a body's inertia from the gyroscope that flew with it");
  command
      ->add_option("FILE", arguments->file,
                   "Table of the rates (CSV), or a phone's export: a folder, or ZIP")
      ->required();
  command
      ->add_option("--acceleration", arguments->acceleration,
                   "Table of the accelerometer's readings, with gravity, at times of its own")
      ->type_name("FILE");
  CLI::Option* const scene =
      command
          ->add_option("-o,--output", arguments->scene,
                       "Scene to write, beside the recording: as measured, and exact")
          ->type_name("FILE");
  command
      ->add_flag("--list", arguments->list,
                 "List the flights that the rates alone show, and what each tells")
      ->excludes(scene);
  command->add_flag("--json", arguments->json, "Print one JSON object");
  command
      ->add_option("--lever", arguments->options.lever,
                   "Largest distance of the accelerometer from the centre of mass")
      ->check(notNegative)
      ->type_name("METRES")
      ->capture_default_str();
  arguments->recording.addTo(*command);
  command->footer(R"(
Prints the ratios of the principal moments with intervals that hold in 95 of 100 tosses by noise
alone, wider where the residual shows other errors. The flight is found by the accelerometer's columns,
or without them by the rates alone if there is one throw; else state it with --from and --to.

Examples:
  rotatebook toss phyphox.zip
  rotatebook toss Gyroscope.csv --acceleration Accelerometer.csv
  rotatebook toss racket.csv --list
  rotatebook toss toss.csv --from 1.2 --to 2.0 -o toss.toml)");
  command->callback(
      [arguments, &action] { action = [arguments] { return fitAndReport(*arguments); }; });
}

}  // namespace rotatebook::cli
