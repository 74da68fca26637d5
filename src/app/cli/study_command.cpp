#include "cli/study_command.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <optional>
#include <regex>
#include <string>
#include <utility>
#include <vector>

#include <fmt/ostream.h>

#include "base/document/toml_text.h"
#include "base/error.h"
#include "base/json.h"
#include "base/number_text.h"
#include "base/text.h"
#include "cli/batch.h"
#include "cli/clip_options.h"
#include "cli/commands.h"
#include "cli/exit_code.h"
#include "cli/input_guard.h"
#include "cli/interrupt.h"
#include "cli/motion_report.h"
#include "cli/progress_line.h"
#include "cli/scene_options.h"
#include "cli/study_execution.h"
#include "plot/plot_files.h"
#include "plot/study_plots.h"
#include "scene/expectation_text.h"
#include "scene/names.h"
#include "scene/source_locations.h"
#include "store/fingerprint.h"
#include "study/bounds_json.h"
#include "study/study.h"
#include "study/study_csv.h"
#include "system/atomic_file.h"
#include "system/program_mark.h"

namespace rotatebook::cli {
namespace {

using scene::Measure;
using scene::StudySettings;
using study::RunEnd;
using study::StudyRow;

constexpr std::array<std::pair<RunEnd::Kind, const char*>, 3> kFailures{
    {{RunEnd::Kind::Diverged, "diverged"},
     {RunEnd::Kind::NoConvergence, "found no solution for their steps"},
     {RunEnd::Kind::StepTooLong, "had steps too long for their series"}}};

std::string orderLine(const study::CurveOrder& order) {
  const study::OrderFit& fit = order.fit;
  const std::string curve = order.curve.empty() ? "" : fmt::format("{:<16} ", order.curve);
  if (std::isnan(fit.order)) {
    return fmt::format("{}no order: {} usable runs, {} needed", curve, fit.runs, study::kMinRuns);
  }
  return fmt::format("{}order {:5.2f} from {:2} runs, steps of {:.3g} to {:.3g} s", curve,
                     fit.order, fit.runs, fit.shortest, fit.longest);
}

/// Returns "euler: 3 of 11 runs diverged"; empty if no run ended like that.
std::string failureLine(const study::Study& result, const std::string& curve, RunEnd::Kind kind,
                        const char* outcome) {
  const auto runs = std::ranges::count(result.rows, curve, &StudyRow::curve);
  const auto failed = std::ranges::count_if(
      result.rows, [&](const StudyRow& row) { return row.curve == curve && row.end.kind == kind; });
  if (failed == 0) return "";
  return fmt::format("  {}{} of {} runs {}\n", curve.empty() ? "" : curve + ": ", failed, runs,
                     outcome);
}

/// Returns "matrix, 10: diverges_at 4.5, half_turns 2; diverged at 4.5 s".
std::string runLine(const StudyRow& row, const StudySettings& study) {
  std::vector<std::string> numbers;
  for (std::size_t i = 0; i < study.measures.size(); ++i) {
    const double value = row.measured[i];
    const std::string text = std::isnan(value)   ? "–"
                             : std::isinf(value) ? "not within " + roundedText(row.length, 4) + " s"
                                                 : roundedText(value, 4);
    const bool isError = study.measures[i] == Measure::Order;
    numbers.push_back(
        fmt::format("{} {}", isError ? "error_deg" : nameOf(study.measures[i]), text));
  }
  const std::string end = row.end.kind == RunEnd::Kind::Whole ? "" : "; " + row.end.text();
  return fmt::format("{}: {}{}", joined({row.curve, row.value}), joined(numbers), end);
}

Json expectedJson(const study::StudyExpectation& expected) {
  return study::boundsJson(expected.subject(), rowOf(expected.expectation.measure).meaning,
                           expected.expectation.bounds(), expected.measured);
}

Json orderJson(const study::CurveOrder& order) {
  const study::OrderFit& fit = order.fit;
  const bool known = !std::isnan(fit.order);
  return {{"curve", order.curve},
          {"order", fit.order},
          {"runs", fit.runs},
          {"shortest_h_s", known ? fit.shortest : fit.order},
          {"longest_h_s", known ? fit.longest : fit.order}};
}

Json runJson(const StudyRow& row, const StudySettings& study) {
  Json object;
  object["value"] = row.value;
  object["curve"] = row.curve;
  for (std::size_t i = 0; i < study.measures.size(); ++i) {
    if (study.measures[i] == Measure::Order) {
      object["h_s"] = row.step;
      object["error_deg"] = row.measured[i];
      object["ns_per_step"] = row.nsPerStep;
    } else {
      object[std::string(nameOf(study.measures[i]))] = row.measured[i];
    }
  }
  object["status"] = row.end.text();
  return object;
}

}  // namespace

Json studyJson(const StudiedScene& studied) {
  const StudySettings& study = *studied.scene.study;
  const study::Study result = studied.result.value_or(study::Study{});
  return {{"result", "study"},
          {"name", studied.scene.name},
          {"title", studied.scene.title},
          {"scene_xxh128", studied.checksum},
          {"x", study.x.key},
          {"curves", study.curves ? study.curves->key : ""},
          {"interrupted", studied.interrupted},
          {"error", orNull(studied.error)},
          {"files", studied.written},
          {"runs", arrayOf(result.rows, [&](const auto& row) { return runJson(row, study); })},
          {"orders", arrayOf(result.orders, orderJson)},
          {"expectations", arrayOf(expectedOf(result, study), expectedJson)}};
}

bool reportStudy(const study::Study& result, const StudySettings& study, std::ostream& out) {
  for (const study::CurveOrder& order : result.orders) fmt::print(out, "  {}\n", orderLine(order));
  if (study.measures == std::vector{Measure::Order}) {
    for (const study::CurveOrder& order : result.orders) {
      for (const auto& [kind, outcome] : kFailures)
        out << failureLine(result, order.curve, kind, outcome);
    }
  } else {
    for (const StudyRow& row : result.rows) fmt::print(out, "  {}\n", runLine(row, study));
  }
  bool met = true;
  for (const study::StudyExpectation& one : expectedOf(result, study)) {
    fmt::print(out, "  {}\n", reportLine(one.subject(), one.expectation.bounds(), one.measured));
    met &= one.isMet();
  }
  return met;
}

namespace {

struct StudyArguments {
  std::vector<std::string> scenes;
  SceneOptions sceneOptions;
  std::string folder = "out";
  std::optional<std::string> steps;
  std::optional<std::string> integrators;
  bool json = false;
};

Shorthand stepsShorthand(const std::string& steps) {
  static const std::regex kList("(0|[1-9][0-9]{0,8})(,(0|[1-9][0-9]{0,8}))*");
  if (!std::regex_match(steps, kList)) {
    throw InputError(fmt::format(
        "--steps {}: not a list of whole numbers; write substeps, for example 1,2,4,8", steps));
  }
  return {"--steps " + steps,
          fmt::format(R"(study.x={{ key = "simulation.substeps", values = [{}] }})", steps)};
}

Shorthand integratorsShorthand(const std::string& integrators) {
  return {"--integrators " + integrators,
          fmt::format(R"(study.curves={{ key = "simulation.integrator", values = [{}] }})",
                      joinedOf(itemsOf(integrators), document::tomlString))};
}

/// Returns what the options set. Of other runs than the scene's nothing is expected, unless --set
/// says what.
std::vector<Shorthand> shorthandsOf(const StudyArguments& arguments) {
  std::vector<Shorthand> shorthands;
  if (arguments.steps) shorthands.push_back(stepsShorthand(*arguments.steps));
  if (arguments.integrators) shorthands.push_back(integratorsShorthand(*arguments.integrators));
  const bool expects =
      std::ranges::any_of(arguments.sceneOptions.overrides,
                          [](const std::string& text) { return text.starts_with("study.expect"); });
  if (!shorthands.empty() && !expects)
    shorthands.push_back({shorthands.front().option, "study.expect=[]"});
  return shorthands;
}

/// Reads a scene; one without a study gets that of the orders of all its integrators.
scene::Scene readStudied(const std::string& path, const StudyArguments& arguments) {
  arguments.sceneOptions.refuseSize("plots have a size of their own: leave it out");
  scene::Scene scene = arguments.sceneOptions.read(path, shorthandsOf(arguments),
                                                   Shorthand{"study " + path, "study={}"});
  if (scene.study) return scene;
  throw InputError(scene::locationOf(scene, "panel") +
                   ": a study needs a single motion, but this scene has several, panels or a grid");
}

std::vector<StudiedScene> readTasks(const StudyArguments& arguments) {
  const auto [scenes, inputs] = readAllScenes(
      arguments.scenes, [&](const std::string& path) { return readStudied(path, arguments); });
  refuseSameNames(scenes);
  std::vector<StudiedScene> tasks;
  for (const scene::Scene& scene : scenes) {
    tasks.push_back(
        {scene, store::studyFiles(arguments.folder, scene.name), store::studySceneChecksum(scene)});
    plot::requireStudyLetters(scene);
    refuseLosses(store::ResultKind::Study, scene, arguments.folder, inputs);
  }
  return tasks;
}

/// Throws InputError if there is nothing to plot. Runs that end early are results of some measures.
void refuseNoResult(const StudiedScene& task) {
  const std::vector<study::StudyRow>& rows = task.result->rows;
  const bool any = std::ranges::any_of(rows, [](const study::StudyRow& row) {
    return std::ranges::any_of(row.measured, [](double value) { return !std::isnan(value); });
  });
  if (any) return;
  throw InputError(fmt::format(
      "{}: no run reached its end ({} says why), so that there is nothing to compare; the first: "
      "{}; take shorter steps, for example --steps 256,512,1024,2048",
      task.scene.name, task.files.csv.string(), rows.front().end.text()));
}

/// Returns `task` with the names of its files alone, so that a folder can be moved, and that the
/// same study leaves the same bytes in any.
StudiedScene besideItsFiles(StudiedScene task) {
  for (std::string& file : task.written) file = std::filesystem::path(file).filename().string();
  return task;
}

/// Writes and reports the result.
int finish(StudiedScene& task, std::ostream& out) {
  const study::Study& result = *task.result;
  const auto note = [&](const std::filesystem::path& file) {
    task.written.push_back(file.string());
  };
  store::removeFiles(allOf(task.files));
  system::writeFileAtomically(task.files.csv, studyCsv(result, *task.scene.study));
  note(task.files.csv);
  refuseNoResult(task);
  const int status = statusOf(reportStudy(result, *task.scene.study, out));
  for (const plot::PlotFile& plotted : plot::studyPlot(result, task.scene, task.files.plots)) {
    system::writeMarked(plotted.path, plotted.bytes);
    note(plotted.path);
  }
  note(task.files.json);
  system::writeFileAtomically(task.files.json, jsonLine(studyJson(besideItsFiles(task))));
  fmt::print(out, "  wrote {}\n", oneLine(listed(task.written)));
  return status;
}

std::optional<study::Study> run(const scene::Scene& scene, const std::atomic<bool>& stop) {
  ProgressLine progress(scene.name, "runs");
  system::RunOptions options;
  options.stop = &stop;
  options.progress = progress.updater();
  return runStudy(scene, onThisMachine(options));
}

int runTask(StudiedScene& task, const std::atomic<bool>& stop, std::ostream& out) {
  fmt::print(out, "{}: {}\n", task.scene.name, task.scene.title);
  task.result = run(task.scene, stop);
  if (task.result) return finish(task, out);
  out << "  interrupted; nothing was written\n";
  task.interrupted = true;
  return interruptStatus();
}

int study(const StudyArguments& arguments) {
  std::vector<StudiedScene> tasks = readTasks(arguments);
  const std::atomic<bool>& stop = catchInterrupts();
  const auto runAll = [&](std::ostream& out) {
    for (StudiedScene& task : tasks) {
      noted(task, [&] {
        system::createFolders(task.files.csv.parent_path());
        store::requireWritable(allOf(task.files));
      });
    }
    return inTurn(tasks, [&](std::size_t i) { return runTask(tasks[i], stop, out); });
  };
  return reportIfUnmet(reportBatch(arguments.json, "studies", tasks, runAll, studyJson));
}

}  // namespace

void addStudyCommand(CLI::App& program, Action& action) {
  auto [command, arguments] =
      addCommand(program, action, "study",
                 "Compare integrators and steps, or values of any key: tables and plots", study);
  command.add_option("SCENE", arguments.scenes, "Scene files")->required();
  addOption(command, "-o,--output", "DIR", arguments.folder, "Folder for the results")
      ->capture_default_str();
  addOption(command, "--steps", "N,N,...", arguments.steps,
            "Substeps to compare, as study.x, e.g. 1,2,4,8");
  addOption(command, "--integrators", "NAME,...", arguments.integrators,
            "Integrators to compare, as study.curves, e.g. euler,rk4");
  command.add_flag("--json", arguments.json, "Print one JSON object: what was measured");
  arguments.sceneOptions.addTo(command, /*draws=*/false);
  arguments.sceneOptions.addChecksum(command);
  addRetryStatus(command);
  command.footer(R"(
Runs the scene with each value of the axis study.x, on a curve for each value of study.curves, and
measures what study.measure lists. Without [study], finds the order of each of the model's integrators
from runs with 1, 2, 4 ... 1024 substeps. --steps and --integrators make other runs than the scene's, of
which nothing is expected. Writes DIR/NAME-study.csv, the plot as DIR/NAME-study.png, .svg and .pdf,
and DIR/NAME-study.json.

Examples:
  rotatebook study scenes/studies/*.toml
  rotatebook study scenes/starter.toml --integrators splitting,rk4 --steps 1,2,4,8,16
  rotatebook study my.toml -o /tmp/studies --set clip.duration=2)");
}

}  // namespace rotatebook::cli
