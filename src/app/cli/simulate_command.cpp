#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

#include <fmt/ostream.h>

#include "base/error.h"
#include "base/text.h"
#include "cli/commands.h"
#include "cli/exit_code.h"
#include "cli/input_guard.h"
#include "cli/motion_report.h"
#include "cli/scene_options.h"
#include "store/clip_files.h"
#include "store/result_owners.h"
#include "store/tables.h"
#include "timeline/clip_tables.h"
#include "timeline/simulate_scene.h"

namespace rotatebook::cli {
namespace {

struct SimulateArguments {
  std::string scene;
  SceneOptions sceneOptions;
  std::string csv;
  bool json = false;
  bool noExpect = false;
};

std::vector<timeline::MotionSummary> summariesOf(const scene::Scene& scene,
                                                 const timeline::ClipMotion& motion,
                                                 bool noExpect) {
  std::vector<timeline::MotionSummary> motions = timeline::summarize(scene, motion);
  if (noExpect) timeline::leaveUnjudged(motions);
  return motions;
}

/// Prints the table of a scene that has a single one to the standard output.
int printTable(const scene::Scene& scene, bool noExpect) {
  if (timeline::tableCount(scene) > 1) {
    throw InputError(fmt::format(
        "--csv -: {} has panels, each with a table of its own; name a file", scene.name));
  }
  const timeline::ClipMotion motion = timeline::simulateScene(scene);
  std::cout << timeline::tableText(scene, motion, 0);
  const std::vector<timeline::MotionSummary> motions = summariesOf(scene, motion, noExpect);
  reportMotions(motions, std::clog);
  reportNotes(scene, motions, std::cerr);
  return reportIfUnmet(statusOf(timeline::allMet(motions)), false);
}

void reportAsText(const scene::Scene& scene, const std::vector<WrittenTable>& tables,
                  const std::vector<timeline::MotionSummary>& motions, std::ostream& out) {
  fmt::print(out, "{}: {}\n", scene.name, scene.title);
  for (const WrittenTable& table : tables) {
    fmt::print(out, "  wrote {}, {} rows\n", oneLine(table.path.string()), table.rows);
  }
  reportMotions(motions, out);
}

int simulateScene(const SimulateArguments& arguments) {
  if (arguments.csv == "-" && arguments.json) {
    throw InputError(
        "--csv - and --json both print to the standard output; name a file with --csv");
  }
  const scene::Scene scene = arguments.sceneOptions.read(arguments.scene);
  reportNotes(scene, std::cerr);
  if (arguments.csv == "-") return printTable(scene, arguments.noExpect);
  std::vector<std::filesystem::path> files;
  if (!arguments.csv.empty()) files = store::csvFiles(arguments.csv, scene);
  for (const auto& file : files) {
    refuseInputs(file, inputsOf(arguments.scene, scene), "name another file with --csv");
    requireEnding(file, ".csv", "--csv");
  }
  const std::string remedy = "the table would replace it; name another file with --csv";
  store::refuseResultsOfOthers({store::ResultKind::Clip, scene.name}, files, remedy);
  if (!files.empty()) {
    const std::filesystem::path folder = files.front().parent_path();
    store::refuseNoResultsOfClip(store::clipFiles(folder, scene.name), files, remedy);
  }
  const timeline::ClipMotion motion = timeline::simulateScene(scene);
  if (!files.empty()) store::writeTables(files, scene, motion);
  const std::vector<timeline::MotionSummary> motions =
      summariesOf(scene, motion, arguments.noExpect);
  std::vector<WrittenTable> tables;
  for (std::size_t i = 0; i < files.size(); ++i) {
    tables.push_back({files[i], timeline::rowCount(scene, motion, i)});
  }
  (arguments.json ? reportSimulationAsJson : reportAsText)(scene, tables, motions, std::cout);
  reportNotes(scene, motions, std::cerr);
  return reportIfUnmet(statusOf(timeline::allMet(motions)), !files.empty());
}

}  // namespace

void addSimulateCommand(CLI::App& program, Action& action) {
  auto [command, arguments] =
      addCommand(program, action, "simulate",
                 "Simulate a scene without drawing it; needs no graphics", simulateScene);
  command.add_option("SCENE", arguments.scene, "Scene file")->required();
  addOption(command, "--csv", "FILE", arguments.csv,
            "Table to write, one row a frame; - for the standard output");
  command.add_flag("--json", arguments.json, "Print one JSON object: what was measured");
  arguments.sceneOptions.addTo(command, /*draws=*/false);
  addNoExpect(command, arguments.noExpect);
  command.footer(R"(
Reports flips, energy, distance to the exact motion, and what was expected.

Examples:
  rotatebook simulate scenes/starter.toml
  rotatebook simulate scenes/starter.toml --csv motion.csv
  rotatebook simulate scenes/starter.toml --csv - --set simulation.model=particles | head)");
}

}  // namespace rotatebook::cli
