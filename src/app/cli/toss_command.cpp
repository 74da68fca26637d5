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
#include "cli/recording_options.h"
#include "recording/toss.h"
#include "report/toss_report.h"
#include "system/atomic_file.h"

namespace rotatebook::cli {
namespace {

namespace fs = std::filesystem;

struct TossArguments {
  std::string file, scene;
  RecordingOptions recording;
  recording::TossOptions options;
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

int fitAndReport(const TossArguments& arguments) {
  const recording::ReadOptions options = arguments.recording.read();
  const std::string path = arguments.scene.empty() ? "" : pathFrom(arguments.scene, arguments.file);
  if (!path.empty()) requireAbsent(arguments.scene);
  recording::TossOptions toss = arguments.options;
  toss.from = options.from;
  toss.to = options.to;
  const recording::TossFit fit = recording::fitToss(
      recording::readInertial(recordingBytes(arguments.file), arguments.file, options),
      arguments.file, toss);
  (arguments.json ? report::reportTossAsJson : report::reportToss)(fit, arguments.file, std::cout);
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
  command->add_option("FILE", arguments->file, "Table of the rates (CSV), e.g. phyphox's")
      ->required();
  command
      ->add_option("-o,--output", arguments->scene,
                   "Scene to write, beside the recording: as measured, and exact")
      ->type_name("FILE");
  command->add_flag("--json", arguments->json, "Print one JSON object");
  command
      ->add_option("--lever", arguments->options.lever,
                   "Largest distance of the accelerometer from the centre of mass")
      ->check(notNegative)
      ->type_name("METRES")
      ->capture_default_str();
  arguments->recording.addTo(*command);
  command->footer(R"(
Prints the ratios of the principal moments with intervals that hold in 95 of 100 tosses. The flight is
found from the accelerometer's columns, if there are any; else state it with --from and --to.

Examples:
  rotatebook toss toss.csv
  rotatebook toss toss.csv --from 1.2 --to 2.0 -o toss.toml)");
  command->callback(
      [arguments, &action] { action = [arguments] { return fitAndReport(*arguments); }; });
}

}  // namespace rotatebook::cli
