#include <algorithm>
#include <exception>
#include <iostream>
#include <iterator>
#include <optional>
#include <string>
#include <vector>

#include "base/error.h"
#include "base/json.h"
#include "base/number_text.h"
#include "base/text.h"
#include "cli/clip_options.h"
#include "cli/commands.h"
#include "cli/exit_code.h"
#include "cli/input_guard.h"
#include "cli/interrupt.h"
#include "cli/motion_report.h"
#include "cli/progress_line.h"
#include "cli/scene_options.h"
#include "pipeline/make_film.h"
#include "pipeline/make_map.h"
#include "pipeline/map_options.h"
#include "plot/map_plot.h"
#include "scene/scene.h"
#include "store/clip_files.h"
#include "store/result_owners.h"
#include "store/study_files.h"
#include "study/map_files.h"
#include "study/map_result.h"
#include "system/atomic_file.h"

namespace rotatebook::cli {
namespace {

/// A scene, and as much of its map's outcome as there is.
struct MappedScene {
  scene::Scene scene;
  std::optional<study::MapFacts> facts{};
  std::vector<study::MarkedValue> marks{};
  std::vector<study::ExpectedOfMap> expected{};
  std::vector<std::string> files{};  ///< That were written.
  bool interrupted = false;
  std::string error{};  ///< Empty if there was none.

  bool isMet() const { return std::ranges::all_of(expected, &study::ExpectedOfMap::isMet); }
};

std::string countText(std::int64_t count, const char* what) {
  return count > 0 ? std::to_string(count) + " " + what : "";
}

std::string factsLine(const study::MapFacts& facts) {
  constexpr int kDigits = 4;
  const std::string values = facts.withValue() == 0
                                 ? "no run has a value"
                                 : "values from " + roundedText(facts.smallest, kDigits) + " to " +
                                       roundedText(facts.largest, kDigits) + ", mean " +
                                       roundedText(facts.mean, kDigits);
  return std::to_string(facts.runs) + " runs: " +
         joined({values, countText(facts.never, "never"), countText(facts.diverged, "diverged"),
                 countText(facts.refused, "refused")});
}

std::string valueText(double value) {
  constexpr int kDigits = 5;
  switch (study::outcomeOf(value)) {
    case scene::Outcome::Value:
      break;
    case scene::Outcome::Never:
      return "never";
    case scene::Outcome::Diverged:
      return "diverged";
    case scene::Outcome::Refused:
      return "refused";
  }
  return roundedText(value, kDigits);
}

std::string mapJson(const MappedScene& mapped) {
  return JsonObject()
      .addString("name", mapped.scene.name)
      .addString("title", mapped.scene.title)
      .addBool("interrupted", mapped.interrupted)
      .addStringOrNull("error", mapped.error)
      .add("files", jsonArrayOf(mapped.files, jsonString))
      .add("facts", mapped.facts ? study::factsJson(*mapped.facts) : "null")
      .add("expectations", study::expectationsJson(mapped.expected, *mapped.scene.map))
      .text();
}

/// Prints a line for the values, and one for each mark and each expectation.
void reportMap(const MappedScene& mapped, std::ostream& out) {
  if (mapped.facts) out << "  " << factsLine(*mapped.facts) << '\n';
  for (const study::MarkedValue& marked : mapped.marks) {
    out << "  " << marked.mark.label << " at [" << shortestText(marked.mark.x) << ", "
        << shortestText(marked.mark.y) << "]: " << joinedOf(marked.values, valueText) << '\n';
  }
  for (const study::ExpectedOfMap& one : mapped.expected) {
    out << "  " << reportLine(one.subject(), one.expectation.bounds, one.measured) << '\n';
  }
}

/// Prints all as one JSON object. `interrupted` says that scenes were left out or undone.
void reportMapsAsJson(const std::vector<MappedScene>& maps, bool interrupted, std::ostream& out) {
  out << JsonObject()
             .addBool("interrupted", interrupted)
             .add("maps", jsonArrayOf(maps, mapJson))
             .text()
      << '\n';
}

struct MapArguments {
  std::vector<std::string> scenes;
  SceneOptions sceneOptions;
  std::string folder = "out";
  int threads = 0;
  std::string part;
  bool resume = false;
  bool overwrite = false;
  bool json = false;
  bool film = false;
};

/// A scene and the files of its map.
struct MapTask {
  scene::Scene scene;
  store::MapFiles files;
  std::vector<std::filesystem::path> outputs;  ///< All that is written.
};

/// Throws InputError if a map or its film would replace what it didn't leave.
void refuseLostResults(const MapTask& task, const MapArguments& arguments) {
  const store::ResultKind kind = arguments.film ? store::ResultKind::Film : store::ResultKind::Map;
  store::refuseResultsOfOthers({kind, task.scene.name}, task.outputs,
                               std::string("the ") + (arguments.film ? "film" : "map") + " of " +
                                   task.scene.name +
                                   " would replace it; name another folder with -o");
  if (!arguments.film) store::refuseNoResultsOfMap(task.files);
}

/// Reads all scenes before anything is written, so that a mistake in the last one costs nothing.
std::vector<MapTask> readMapTasks(const MapArguments& arguments,
                                  const pipeline::MapOptions& options) {
  std::vector<scene::Scene> scenes;
  std::vector<Input> inputs;
  for (const std::string& path : arguments.scenes) {
    scenes.push_back(arguments.sceneOptions.read(path));
    requireMap(scenes.back(), path);
    plot::requireMapLetters(scenes.back());
    std::ranges::move(inputsOf(path, scenes.back()), std::back_inserter(inputs));
  }
  refuseSameNames(scenes);
  std::vector<MapTask> tasks;
  for (const scene::Scene& scene : scenes) {
    const store::MapFiles files = store::mapFiles(arguments.folder, scene.name);
    tasks.push_back({scene, files, arguments.film ? std::vector{files.film} : allOf(files)});
    store::Footprint footprint;
    footprint.addMap(files);
    refuseInputs(footprint, inputs);
    refuseLostResults(tasks.back(), arguments);
    if (arguments.film) {
      pipeline::requireMayReplaceFilm(scene, files, options);
    } else {
      pipeline::requireMayReplaceMap(scene, files, options);
    }
  }
  return tasks;
}

/// Makes the runs, and shows their progress.
pipeline::MadeMap runTiles(const MapTask& task, const study::MapRuns& runs,
                           pipeline::MapOptions options) {
  ProgressLine progress(task.scene.name, "tiles");
  options.execution.progress = progress.updater();
  return pipeline::makeMap(task.scene, runs, task.files, options);
}

int reportPart(const pipeline::MadeMap& made, const store::ClipPart& part, std::ostream& out) {
  out << "  part " << part.number << " of " << part.count << " is done: " << made.tiles
      << (made.tiles == 1 ? " tile" : " tiles") << std::endl;
  return kDone;
}

int runMapTask(const MapTask& task, pipeline::MapOptions options, MappedScene& mapped,
               std::ostream& out) {
  out << task.scene.name << ": " << task.scene.title << std::endl;
  const study::MapRuns runs(task.scene);
  const system::AdvisoryLock lock(task.files.npy,
                                  options.part ? system::Lock::Shared : system::Lock::Exclusive);
  const pipeline::MadeMap made = runTiles(task, runs, options);
  if (!made.isWhole) {
    out << "  interrupted; " << made.finished << " of " << made.tiles << " tiles are in "
        << task.files.tiles.string() << "; go on with --resume" << std::endl;
    mapped.interrupted = true;
    return interruptStatus();
  }
  if (made.found > 0) {
    out << "  kept " << made.found << " of " << made.tiles << " tiles of an earlier run\n";
  }
  if (options.part) return reportPart(made, *options.part, out);
  mapped.facts = factsOf(made.result);
  mapped.marks = made.result.marks;
  mapped.expected = expectedOf(made.result, *task.scene.map, runs);
  reportMap(mapped, out);
  mapped.files = pipeline::writeMap(task.scene, runs, made.result, task.files);
  out << "  wrote " << oneLine(listed(mapped.files)) << std::endl;
  return statusOf(mapped.isMet());
}

/// Makes the frames, and shows their progress.
pipeline::MadeFilm runFrames(const MapTask& task, pipeline::MapOptions options) {
  ProgressLine progress(task.scene.name, "frames");
  options.execution.progress = progress.updater();
  return pipeline::makeFilm(task.scene, task.files, options);
}

int runFilmTask(const MapTask& task, pipeline::MapOptions options, MappedScene& mapped,
                std::ostream& out) {
  out << task.scene.name << ": " << task.scene.title << std::endl;
  const system::AdvisoryLock lock(task.files.film, system::Lock::Exclusive);
  const pipeline::MadeFilm made = runFrames(task, options);
  if (!made.isWhole) {
    out << "  interrupted; " << made.finished << " of " << made.frames << " frames are in "
        << task.files.filmFrames.string() << "; go on with --resume" << std::endl;
    mapped.interrupted = true;
    return interruptStatus();
  }
  if (made.wasDone) {
    out << "  already done: " << oneLine(task.files.film.string()) << std::endl;
    return kDone;
  }
  if (made.found > 0) {
    out << "  kept " << made.found << " of " << made.frames << " frames of an earlier run\n";
  }
  mapped.files = {task.files.film.string()};
  out << "  wrote " << oneLine(listed(mapped.files)) << std::endl;
  return kDone;
}

/// Makes a map or a film.
using RunMapTask = int(const MapTask& task, pipeline::MapOptions options, MappedScene& mapped,
                       std::ostream& out);

int runMapTasks(const std::vector<MapTask>& tasks, RunMapTask* runTask,
                const pipeline::MapOptions& options, std::vector<MappedScene>& mapped,
                std::ostream& out) {
  for (const MapTask& task : tasks) {
    system::createFolders(task.files.png().parent_path());
    store::requireWritable(task.outputs);
  }
  int status = kDone;
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    int outcome = kDone;
    try {
      outcome = runTask(tasks[i], options, mapped[i], out);
    } catch (const std::exception& error) {
      mapped[i].error = error.what();
      throw;
    }
    if (outcome >= kInterrupted) return outcome;
    status = std::max(status, outcome);
  }
  return status;
}

/// Prints one JSON object at the end, also after an error, which it reports.
int runMapTasksAsJson(const std::vector<MapTask>& tasks, RunMapTask* runTask,
                      const pipeline::MapOptions& options, std::vector<MappedScene>& mapped) {
  std::ostream nowhere(nullptr);
  const int status = guarded([&] { return runMapTasks(tasks, runTask, options, mapped, nowhere); });
  reportMapsAsJson(mapped, status >= kInterrupted, std::cout);
  return status;
}

int makeMaps(const MapArguments& arguments) {
  pipeline::MapOptions options;
  options.resume = arguments.resume;
  options.overwrite = arguments.overwrite;
  options.execution.threads = arguments.threads;
  if (!arguments.part.empty()) options.part = partOf(arguments.part);
  const std::vector<MapTask> tasks = readMapTasks(arguments, options);
  options.execution.stop = &catchInterrupts();
  std::vector<MappedScene> mapped;
  for (const MapTask& task : tasks) mapped.push_back({task.scene});
  RunMapTask* runTask = arguments.film ? runFilmTask : runMapTask;
  return reportIfUnmet(arguments.json ? runMapTasksAsJson(tasks, runTask, options, mapped)
                                      : runMapTasks(tasks, runTask, options, mapped, std::cout));
}

}  // namespace

void addMapCommand(CLI::App& program, Action& action) {
  auto [command, arguments] = addCommand(
      program, action, "map", "Draw pictures of which each pixel is a run of the motion", makeMaps);
  command.add_option("SCENE", arguments.scenes, "Scene files with [map]")->required();
  addOption(command, "-o,--output", "DIR", arguments.folder, "Folder for the results")
      ->capture_default_str();
  addOption(command, "--threads", "N", arguments.threads,
            "Threads to run on; by default one for each core. The results are the same")
      ->check(CLI::Range(1, 1024));
  command.add_flag("--resume", arguments.resume,
                   "Go on where a map stopped, and keep values of the same settings");
  command.add_flag("--film", arguments.film,
                   "Make the film that map.film describes, DIR/NAME.film.mp4, and nothing else");
  CLI::Option* overwrite =
      command.add_flag("--overwrite", arguments.overwrite,
                       "Discard tiles and values of other settings; without --resume, all tiles");
  addOption(command, "--part", "I/N", arguments.part,
            "Only the I-th of N parts, I from 1 to N: tiles alone, to be joined")
      ->excludes(overwrite)
      ->excludes("--film");
  command.add_flag("--json", arguments.json, "Print one JSON object: what was measured");
  arguments.sceneOptions.addTo(command, /*draws=*/false);
  arguments.sceneOptions.addChecksum(command);
  addRetryStatus(command);
  command.footer(R"(
Runs the scene's motion once for each pixel of [map]: the keys of its axes x and y have other values
in each column and row, and the colour shows what `measure` names.
Writes DIR/NAME.png with axes and legend, DIR/NAME.plain.png with one pixel a run, DIR/NAME.npy with the
values, DIR/NAME.json with the axes and, of at most 10000 runs, DIR/NAME.csv.
Whatever stops a map, it keeps the tiles that are done, in DIR/NAME.tiles; the same command with
--resume goes on, and its files are those of a map that never stopped.
With --part there are only tiles, which may be made on several machines at the same time; --resume
without --part joins them.

Examples:
  rotatebook map scenes/maps/map-delay.toml
  rotatebook map scenes/maps/map-half-turns.toml --set map.size=[1920,1080] --threads 16)");
}

}  // namespace rotatebook::cli
