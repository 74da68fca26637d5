#include <algorithm>
#include <exception>
#include <filesystem>
#include <iostream>
#include <iterator>
#include <memory>
#include <optional>
#include <regex>
#include <string>
#include <vector>

#include "base/error.h"
#include "base/text.h"
#include "cli/clip_options.h"
#include "cli/commands.h"
#include "cli/error_report.h"
#include "cli/exit_code.h"
#include "cli/input_guard.h"
#include "cli/interrupt.h"
#include "cli/progress_line.h"
#include "cli/scene_options.h"
#include "diagnose/study_execution.h"
#include "document/toml_text.h"
#include "plot/study_plots.h"
#include "report/study_report.h"
#include "store/fingerprint.h"
#include "store/result_owners.h"
#include "store/study_files.h"
#include "study/study.h"
#include "study/study_csv.h"
#include "study/sweep.h"
#include "system/atomic_file.h"

namespace rotatebook::cli {
namespace {

struct StudyArguments {
  std::vector<std::string> scenes;
  SceneOptions sceneOptions;
  std::string folder = "out";
  std::optional<std::string> steps;
  std::optional<std::string> integrators;
  bool json = false;
};

/// A scene, what is studied of it, and the files of the results.
struct Task {
  scene::Scene scene;
  scene::StudySettings study;
  store::StudyFiles files;
};

using report::StudiedScene;

Shorthand stepsShorthand(const std::string& steps) {
  static const std::regex kList("(0|[1-9][0-9]{0,8})(,(0|[1-9][0-9]{0,8}))*");
  if (!std::regex_match(steps, kList)) {
    throw InputError("--steps " + steps +
                     ": not a list of whole numbers; write substeps, for example 1,2,4,8");
  }
  return {"--steps " + steps, "study.steps=[" + steps + "]"};
}

Shorthand integratorsShorthand(const std::string& integrators) {
  std::vector<std::string> names;
  for (std::size_t begin = 0; begin <= integrators.size();) {
    const std::size_t end = std::min(integrators.find(',', begin), integrators.size());
    names.push_back(document::tomlString(integrators.substr(begin, end - begin)));
    begin = end + 1;
  }
  return {"--integrators " + integrators, "study.integrators=[" + joined(names) + "]"};
}

std::vector<Shorthand> shorthandsOf(const StudyArguments& arguments) {
  std::vector<Shorthand> shorthands;
  if (arguments.steps) shorthands.push_back(stepsShorthand(*arguments.steps));
  if (arguments.integrators) shorthands.push_back(integratorsShorthand(*arguments.integrators));
  return shorthands;
}

/// Reads all scenes before anything is written, so that a mistake in the last one costs nothing.
std::vector<Task> readTasks(const StudyArguments& arguments) {
  const std::vector<Shorthand> shorthands = shorthandsOf(arguments);
  std::vector<scene::Scene> scenes;
  std::vector<Input> inputs;
  for (const std::string& path : arguments.scenes) {
    scenes.push_back(arguments.sceneOptions.read(path, shorthands));
    std::ranges::move(inputsOf(path, scenes.back()), std::back_inserter(inputs));
  }
  refuseSameNames(scenes);
  std::vector<Task> tasks;
  for (const scene::Scene& scene : scenes) {
    tasks.push_back({scene, scene.study.value_or(scene::defaultStudy(scene.simulation.model)),
                     store::studyFiles(arguments.folder, scene.name)});
    const scene::StudySettings& settings = tasks.back().study;
    plot::requireStudyLetters(scene, settings);
    if (!settings.isOfTilts() && !settings.sweep) study::requireStudyable(scene, settings);
    store::Footprint footprint;
    footprint.addStudy(tasks.back().files);
    refuseInputs(footprint, inputs);
    store::refuseResultsOfOthers(
        {store::ResultKind::Study, scene.name}, allOf(tasks.back().files),
        "the study of " + scene.name + " would replace it; name another folder with -o");
  }
  return tasks;
}

void refuseNoResult(const Task& task, const study::PrecisionStudy& result) {
  const bool any = std::ranges::any_of(result.rows, [](const study::PrecisionRow& row) {
    return row.end.kind == study::RunEnd::Kind::Whole;
  });
  if (any) return;
  throw InputError(task.scene.name + ": no run reached its end (" + task.files.csv.string() +
                   " says why), so that there is nothing to compare; the first: " +
                   result.rows.front().end.text() +
                   "; take shorter steps, for example --steps 256,512,1024,2048");
}

void refuseNoResult(const Task& task, const study::TiltStudy& result) {
  const bool any = std::ranges::any_of(result.rows, [](const study::TiltRow& row) {
    return row.end.kind == study::RunEnd::Kind::Whole;
  });
  if (any) return;
  throw InputError(task.scene.name + ": no run shows two flips (" + task.files.csv.string() +
                   " says why), so that there is no interval to measure; make the motion longer, "
                   "for example --set clip.duration=60");
}

// Runs that end early are results of a sweep.
void refuseNoResult(const Task&, const study::SweepStudy&) {}

/// The paths of a study's tables, and what is in them.
using Tables = std::vector<std::pair<std::filesystem::path, std::string>>;

Tables tablesOf(const Task& task, const study::PrecisionStudy& result) {
  return {{task.files.csv, precisionCsv(result)}, {task.files.orders, ordersCsv(result)}};
}

Tables tablesOf(const Task& task, const study::TiltStudy& result) {
  return {{task.files.csv, tiltCsv(result)}};
}

Tables tablesOf(const Task& task, const study::SweepStudy& result) {
  return {{task.files.csv, sweepCsv(result, *task.study.sweep)}};
}

/// Returns `studied` with the names of its files alone, so that a folder can be moved, and that the
/// same study leaves the same bytes in any.
StudiedScene besideItsFiles(StudiedScene studied) {
  for (std::string& file : studied.files) {
    file = std::filesystem::path(file).filename().string();
  }
  return studied;
}

/// Writes and reports the results, which `studied` then holds.
template <typename Study>
int finish(const Task& task, const Study& result, StudiedScene& studied, std::ostream& out) {
  store::removeFiles(allOf(task.files));
  for (const auto& [path, text] : tablesOf(task, result)) {
    system::writeFileAtomically(path, text);
    studied.files.push_back(path.string());
  }
  studied.result = result;
  refuseNoResult(task, result);
  const int status = statusOf(report::reportStudy(result, task.study, out));
  plot::writeStudyPlot(result, task.scene, task.study, task.files.plots);
  for (const auto& file : task.files.plots) studied.files.push_back(file.string());
  studied.files.push_back(task.files.json.string());
  system::writeFileAtomically(task.files.json, report::studyJson(besideItsFiles(studied)) + '\n');
  out << "  wrote " << oneLine(listed(studied.files)) << std::endl;
  return status;
}

template <typename Study>
using StudyFunction = std::optional<Study> (*)(const scene::Scene&, const scene::StudySettings&,
                                               const study::Execution&);

template <typename Study>
int runAndFinish(StudyFunction<Study> run, const Task& task, const std::atomic<bool>& stop,
                 StudiedScene& studied, std::ostream& out) {
  std::optional<Study> result;
  {
    ProgressLine progress(task.scene.name, "runs");
    system::RunOptions options;
    options.stop = &stop;
    options.progress = progress.updater();
    result = run(task.scene, task.study, diagnose::onThisMachine(options));
  }
  if (result) return finish(task, *result, studied, out);
  out << "  interrupted; nothing was written" << std::endl;
  studied.interrupted = true;
  return interruptStatus();
}

/// Returns the result of `work` for a scene; `studied` has the message of an error that is thrown.
template <typename Work>
auto noted(StudiedScene& studied, const Work& work) {
  try {
    return work();
  } catch (const std::exception& error) {
    studied.error = error.what();
    throw;
  }
}

int runTask(const Task& task, const std::atomic<bool>& stop, StudiedScene& studied,
            std::ostream& out) {
  out << task.scene.name << ": " << task.scene.title << std::endl;
  if (task.study.sweep) return runAndFinish(&study::runSweep, task, stop, studied, out);
  return task.study.isOfTilts() ? runAndFinish(&study::runTiltStudy, task, stop, studied, out)
                                : runAndFinish(&study::runPrecisionStudy, task, stop, studied, out);
}

int runTasks(const std::vector<Task>& tasks, const std::atomic<bool>& stop,
             std::vector<StudiedScene>& studied, std::ostream& out) {
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    noted(studied[i], [&] {
      system::createFolders(tasks[i].files.csv.parent_path());
      store::requireWritable(allOf(tasks[i].files));
    });
  }
  int status = kDone;
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    const int outcome = noted(studied[i], [&] { return runTask(tasks[i], stop, studied[i], out); });
    if (outcome >= kInterrupted) return outcome;
    status = std::max(status, outcome);
  }
  return status;
}

/// Prints one JSON object at the end, also after an error, which it reports.
int runTasksAsJson(const std::vector<Task>& tasks, const std::atomic<bool>& stop,
                   std::vector<StudiedScene>& studied) {
  std::ostream nowhere(nullptr);
  const int status = guarded([&] { return runTasks(tasks, stop, studied, nowhere); });
  report::reportStudiesAsJson(studied, status >= kInterrupted, std::cout);
  return status;
}

int study(const StudyArguments& arguments) {
  const std::vector<Task> tasks = readTasks(arguments);
  const std::atomic<bool>& stop = catchInterrupts();
  std::vector<StudiedScene> studied;
  for (const Task& task : tasks)
    studied.push_back({task.scene, task.study, store::studySceneChecksum(task.scene)});
  return reportIfUnmet(arguments.json ? runTasksAsJson(tasks, stop, studied)
                                      : runTasks(tasks, stop, studied, std::cout));
}

}  // namespace

void addStudyCommand(CLI::App& program, Action& action) {
  auto arguments = std::make_shared<StudyArguments>();
  CLI::App* command = program.add_subcommand(
      "study", "Compare integrators and steps, tilts, or values of any key: tables and plots");
  command->add_option("SCENE", arguments->scenes, "Scene files")->required();
  command->add_option("-o,--output", arguments->folder, "Folder for the results")
      ->type_name("DIR")
      ->capture_default_str();
  command->add_option("--steps", arguments->steps, "Substeps to compare, e.g. 1,2,4,8")
      ->type_name("N,N,...");
  command
      ->add_option("--integrators", arguments->integrators,
                   "Integrators to compare, e.g. euler,rk4")
      ->type_name("NAME,...");
  command->add_flag("--json", arguments->json, "Print one JSON object: what was measured");
  arguments->sceneOptions.addTo(*command, /*draws=*/false);
  arguments->sceneOptions.addChecksum(*command);
  addRetryStatus(*command);
  command->footer(R"(
Runs each integrator with each number of substeps that [study] of the scene lists, by default all
of the model's with 1, 2, 4 ... 1024. If [study] lists tilts, the scene's own integrator runs from each;
with study.x, the scene runs with each value of that axis, and what study.measure lists is measured.
Writes DIR/NAME-study.csv, DIR/NAME-study-orders.csv (of integrators), the plot as DIR/NAME-study.png,
.svg and .pdf, and DIR/NAME-study.json.

Examples:
  rotatebook study scenes/studies/*.toml
  rotatebook study scenes/starter.toml --integrators splitting,rk4 --steps 1,2,4,8,16
  rotatebook study my.toml -o /tmp/studies --set clip.duration=2)");
  command->callback([arguments, &action] { action = [arguments] { return study(*arguments); }; });
}

}  // namespace rotatebook::cli
