#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <fmt/ostream.h>

#include "base/error.h"
#include "base/text.h"
#include "cli/commands.h"
#include "cli/exit_code.h"
#include "cli/input_guard.h"
#include "cli/judge_pack.h"
#include "cli/option_checks.h"
#include "cli/recordings.h"
#include "cli/scene_options.h"
#include "cli/verdict_report.h"
#include "physics/motion_start.h"
#include "physics/recorded_start.h"
#include "physics/simulate.h"
#include "recording/recorded_motion.h"
#include "system/atomic_file.h"
#include "system/read_file.h"
#include "timeline/simulate_scene.h"

namespace rotatebook::cli {
namespace {

struct JudgeArguments {
  std::vector<std::string> files;
  std::string inertia, size;
  RecordingOptions recording;
  SceneOptions scene;
  VerdictBounds bounds;
  bool json = false;
  std::string junit;
  std::string pack;
};

/// Prints the notes that the verdict doesn't say.
void printNotes(const std::string& name, const recording::RecordedMotion& motion) {
  for (const std::string& note : motion.notes()) {
    if (std::ranges::find(motion.flaws(), note) == motion.flaws().end())
      fmt::print(std::cerr, "note: {}: {}\n", oneLine(name), note);
  }
}

/// Returns the motion of a table, of a body that the command line states.
physics::MotionSettings motionOf(const std::string& file, const JudgeArguments& arguments) {
  const recording::ReadOptions options = arguments.recording.read();
  const TableFile table = openRecording(file, "", options).motion;
  if (arguments.inertia.empty() == arguments.size.empty()) {
    throw InputError(fmt::format(
        "{}: a table of a motion doesn't say what moves; state {}the body's moments with --inertia "
        "IX,IY,IZ or a solid cuboid's edges with --size X,Y,Z",
        system::nameOfInput(file), arguments.inertia.empty() ? "" : "either "));
  }
  physics::MotionSettings motion;
  if (!arguments.size.empty()) {
    motion.body.size = threeNumbers(arguments.size, "--size");
  } else {
    takeInertia(motion, threeNumbers(arguments.inertia, "--inertia").asDiagonal());
  }
  auto recorded = std::make_shared<recording::RecordedMotion>(
      recording::readRecording(table.bytes, table.name, options));
  printNotes(table.name, *recorded);
  motion.simulation.timePerFrame =
      recorded->duration() / static_cast<double>(recorded->moments().size() - 1);
  takeRecording(motion, std::move(recorded), system::nameOfInput(file));
  return motion;
}

/// Returns the verdict on a table's motion, or what is wrong with the table.
JudgedMotion judgedTable(const std::string& file, const JudgeArguments& arguments) {
  const std::string name = system::nameOfInput(file);
  try {
    const physics::MotionSettings motion = motionOf(file, arguments);
    std::vector<double> times;
    for (const auto& moment : motion.simulation.recorded.motion->moments())
      times.push_back(moment.time);
    return judgedMotion(name, motion, physics::simulate(motion, times));
  } catch (const recording::ContradictionError& error) {
    const std::string mistake = error.what(), head = name + ": ";
    return {.name = name,
            .mistake = mistake.starts_with(head) ? mistake.substr(head.size()) : mistake};
  }
}

/// Returns whether an option is given that only a table takes.
bool statesTable(const JudgeArguments& arguments) {
  const recording::ReadOptions& options = arguments.recording.options;
  return !arguments.inertia.empty() || !arguments.size.empty() || options.from || options.to ||
         !options.unit.empty() || !options.timeUnit.empty() || !options.ratesAlong.empty() ||
         !arguments.recording.columns.empty();
}

/// Returns the files that are scenes; the standard input is one unless a table's options are given.
std::vector<std::string> scenesOf(const JudgeArguments& arguments) {
  std::vector<std::string> scenes;
  for (const std::string& file : arguments.files) {
    const bool isInput = file == system::kStandardInput;
    if (isInput ? !statesTable(arguments) : std::filesystem::path(file).extension() == ".toml")
      scenes.push_back(file);
  }
  return scenes;
}

scene::Scene readScene(const std::string& file, const JudgeArguments& arguments) {
  try {
    return arguments.scene.read(file);
  } catch (const InputError& error) {
    if (file != system::kStandardInput) throw;
    throw InputError(std::string(error.what()) +
                     "\n  - is a scene here; a table needs --inertia or --size");
  }
}

void addJudgedScene(const std::string& file, const JudgeArguments& arguments,
                    std::vector<JudgedMotion>& judged) {
  const scene::Scene scene = readScene(file, arguments);
  const std::string name = system::nameOfInput(file);
  if (!arguments.junit.empty())
    refuseInputs(arguments.junit, inputsOf(file, scene), "name another file with --junit");
  const timeline::ClipMotion motion = timeline::simulateScene(scene);
  const std::vector<scene::Panel>& panels = scene.motions;
  for (std::size_t i = 0; i < panels.size(); ++i) {
    const auto& simulation = panels[i].simulation;
    if (simulation.model == physics::Model::Recorded) printNotes(name, *simulation.recorded.motion);
    judged.push_back(judgedMotion(panels[i].label.empty() ? name : name + ": " + panels[i].label,
                                  panels[i].motion(), motion.trajectories()[i]));
  }
}

/// Throws InputError for options that none of the files takes, or a pack, or without files.
void refuseIdleOptions(const JudgeArguments& arguments) {
  const auto& bounds = arguments.bounds;
  const bool judges = statesTable(arguments) || !arguments.scene.overrides.empty() ||
                      arguments.json || !arguments.junit.empty() || bounds.errorDeg ||
                      bounds.energyDrift || bounds.momentumDrift || bounds.halfTurns;
  if (!arguments.pack.empty()) {
    if (judges) throw InputError("--pack judges nothing; leave the options for that out");
    return;
  }
  if (arguments.files.empty())
    throw InputError("name a table or a scene to judge, or a folder with --pack");
  const std::size_t scenes = scenesOf(arguments).size();
  if (statesTable(arguments) && scenes == arguments.files.size()) {
    throw InputError(
        "--inertia, --size and the options of recordings are a table's, and there is "
        "none; a scene states them itself, or with --set");
  }
  if (!arguments.scene.overrides.empty() && scenes == 0)
    throw InputError("--set is a scene's, and there is none; a table takes --inertia or --size");
}

int judgeAll(const JudgeArguments& arguments) {
  refuseIdleOptions(arguments);
  if (!arguments.pack.empty()) {
    writePack(arguments.pack);
    fmt::print(std::cout, "wrote {} and a table for each of its motions\n",
               oneLine((std::filesystem::path(arguments.pack) / "pack.json").string()));
    return statusOf(true);
  }
  if (!arguments.junit.empty()) {
    requireAbsentOr(arguments.junit, kJunitBeginning);
    for (const std::string& file : arguments.files)
      refuseInputs(arguments.junit, {{file, "to be judged"}}, "name another file with --junit");
  }
  const std::vector<std::string> scenes = scenesOf(arguments);
  std::vector<JudgedMotion> judged;
  for (const std::string& file : arguments.files) {
    if (std::ranges::count(scenes, file) > 0) {
      addJudgedScene(file, arguments, judged);
    } else {
      judged.push_back(judgedTable(file, arguments));
    }
  }
  (arguments.json ? reportVerdictsAsJson : reportVerdicts)(judged, arguments.bounds, std::cout);
  if (!arguments.junit.empty()) {
    system::writeFileAtomically(arguments.junit, junitOf(judged, arguments.bounds));
  }
  return statusOf(allMet(judged, arguments.bounds));
}

void addBounds(CLI::App& command, VerdictBounds& bounds) {
  constexpr const char* kGroup = "Bounds, of which one that isn't kept ends in exit status 1";
  addOption(command, "--max-error-deg", "DEGREES", bounds.errorDeg,
            "On the angle to the exact attitude", kGroup)
      ->check(notNegative);
  addOption(command, "--max-energy-drift", "PART", bounds.energyDrift,
            "On the energy's relative drift, e.g. 0.01 for a hundredth", kGroup)
      ->check(notNegative);
  addOption(command, "--max-L-drift", "PART", bounds.momentumDrift,
            "On the drift of the angular momentum's size, likewise", kGroup)
      ->check(notNegative);
  command.add_flag("--half-turns", bounds.halfTurns, "As many half-turns as the exact motion")
      ->group(kGroup);
}

}  // namespace

void addJudgeCommand(CLI::App& program, Action& action) {
  auto [command, arguments] =
      addCommand(program, action, "judge",
                 "Compare recorded motions, or a scene's, with the exact ones", judgeAll);
  CLI::Option* const files =
      command
          .add_option("FILE", arguments.files,
                      "Tables of motions (CSV), or scenes (TOML); - is the standard input")
          ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  addOption(command, "--inertia", "IX,IY,IZ", arguments.inertia,
            "Principal moments of a table's body");
  addOption(command, "--size", "X,Y,Z", arguments.size, "Edges of a table's solid cuboid instead");
  command.add_flag("--json", arguments.json, "Print one JSON object");
  addOption(command, "--junit", "FILE", arguments.junit,
            "Write JUnit's XML, a test case for each bound");
  addOption(command, "--pack", "DIR", arguments.pack,
            "Judge nothing, but write starts, exact states and bounds for an engine's own tests")
      ->excludes(files);
  repeated(addOption(command, "--set", "KEY=VALUE", arguments.scene.overrides,
                     "Override a key of the scenes"));
  command.add_flag("--allow-outside", arguments.scene.allowOutside,
                   "Let scenes read files from outside their folders");
  addBounds(command, arguments.bounds);
  arguments.recording.addTo(command);
  addOption(
      command, "--rates-along", "body|world", arguments.recording.options.ratesAlong,
      "Whose axes the rates beside attitudes are along; body for a gyroscope's columns, world "
      "for others",
      "Recording")
      ->check(oneOf({"body", "world"}));
  command.footer(R"(
Prints the error, the drift of energy and angular momentum, the flips made and due, and the kind of
method that errs so. A table whose rates contradict its attitudes, or that tells too little, isn't
judged: what is wrong with it is said, and the exit status is 1. - is a scene, or with --inertia or
another option of tables a table.

Examples:
  rotatebook judge scenes/comparisons/recordings/*.csv --size 0.15,0.22,0.04
  rotatebook judge motion.csv --inertia 1,2,2.5 --max-error-deg 1 --junit judged.xml
  rotatebook judge scenes/starter.toml --half-turns
  ./engine | rotatebook judge - --size 0.15,0.22,0.04
  rotatebook judge --pack exact)");
}

}  // namespace rotatebook::cli
