#include <algorithm>
#include <iostream>
#include <optional>
#include <string>
#include <vector>

#include <fmt/ostream.h>

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
#include "cli/option_checks.h"
#include "cli/progress_line.h"
#include "cli/scene_options.h"
#include "pipeline/make_film.h"
#include "pipeline/make_map.h"
#include "pipeline/map_options.h"
#include "plot/map_plot.h"
#include "scene/names.h"
#include "scene/scene.h"
#include "store/study_files.h"
#include "study/map_files.h"
#include "study/map_result.h"
#include "system/atomic_file.h"

namespace rotatebook::cli {
namespace {

struct MapArguments {
  std::vector<std::string> scenes;
  SceneOptions sceneOptions;
  std::string folder = "out";
  std::string part;
  pipeline::MapOptions options;
  bool json = false;
  bool film = false;
};

/// A scene, the files of its map, and as much of its outcome as there is.
struct MapTask {
  scene::Scene scene;
  store::MapFiles files;
  std::vector<std::filesystem::path> outputs;  ///< All that is written.
  std::optional<study::MapFacts> facts{};
  std::vector<study::ExpectedOfMap> expected{};
  std::vector<std::string> written{};
  bool interrupted = false;
  std::string error{};
};

std::string factsLine(const study::MapFacts& facts) {
  constexpr int kDigits = 4;
  const auto countText = [](std::int64_t count, const char* what) {
    return count > 0 ? fmt::format("{} {}", count, what) : "";
  };
  const std::string values =
      facts.withValue() == 0
          ? "no run has a value"
          : fmt::format("values from {} to {}, mean {}", roundedText(facts.smallest, kDigits),
                        roundedText(facts.largest, kDigits), roundedText(facts.mean, kDigits));
  return fmt::format(
      "{} runs: {}", facts.runs,
      joined({values, countText(facts.never, "never"), countText(facts.diverged, "diverged"),
              countText(facts.refused, "refused")}));
}

std::string valueText(double value) {
  constexpr int kDigits = 5;
  const scene::Outcome outcome = study::outcomeOf(value);
  return outcome == scene::Outcome::Value ? roundedText(value, kDigits)
                                          : std::string(nameOf(scene::kOutcomes, outcome));
}

Json mapJson(const MapTask& task) {
  return {{"name", task.scene.name},
          {"title", task.scene.title},
          {"interrupted", task.interrupted},
          {"error", orNull(task.error)},
          {"files", task.written},
          {"facts", task.facts ? study::factsJson(*task.facts) : Json()},
          {"expectations", study::expectationsJson(task.expected, *task.scene.map)}};
}

std::vector<MapTask> readMapTasks(const MapArguments& arguments,
                                  const pipeline::MapOptions& options) {
  arguments.sceneOptions.refuseSize("write a map's own, --set map.size=[WIDTH, HEIGHT]");
  const auto [scenes, inputs] = readAllScenes(arguments.scenes, [&](const std::string& path) {
    scene::Scene scene = arguments.sceneOptions.read(path);
    requireMap(scene, path);
    plot::requireMapLetters(scene);
    return scene;
  });
  refuseSameNames(scenes);
  const bool film = arguments.film;
  std::vector<MapTask> tasks;
  for (const scene::Scene& scene : scenes) {
    const store::MapFiles files = store::mapFiles(arguments.folder, scene.name);
    tasks.push_back({scene, files, film ? std::vector{files.film} : allOf(files)});
    refuseLosses(film ? store::ResultKind::Film : store::ResultKind::Map, scene, arguments.folder,
                 inputs);
    (film ? pipeline::requireMayReplaceFilm : pipeline::requireMayReplaceMap)(scene, files,
                                                                              options);
  }
  return tasks;
}

/// Returns the outcome of `make`, which is given the options with a line of progress in `unit`.
template <typename Make>
auto withProgress(const MapTask& task, pipeline::MapOptions options, const char* unit,
                  const Make& make) {
  ProgressLine progress(task.scene.name, unit);
  options.execution.progress = progress.updater();
  return make(options);
}

/// Reports what there is of an interrupted map or film; returns the status.
int reportInterrupt(MapTask& task, const std::string& finished, const std::filesystem::path& folder,
                    std::ostream& out) {
  fmt::print(out, "  interrupted; {} are in {}; go on with --resume\n", finished, folder.string());
  task.interrupted = true;
  return interruptStatus();
}

void reportKept(const std::string& found, std::ostream& out) {
  fmt::print(out, "  kept {} of an earlier run\n", found);
}

void reportWritten(const MapTask& task, std::ostream& out) {
  fmt::print(out, "  wrote {}\n", oneLine(listed(task.written)));
}

/// Reports the values, the marks and the expectations.
void reportResult(MapTask& task, const study::MapResult& result, const study::MapRuns& runs,
                  std::ostream& out) {
  task.facts = factsOf(result);
  task.expected = expectedOf(result, *task.scene.map, runs);
  fmt::print(out, "  {}\n", factsLine(*task.facts));
  for (const auto& [mark, values] : result.marks) {
    fmt::print(out, "  {} at [{}, {}]: {}\n", mark.label, shortestText(mark.x),
               shortestText(mark.y), joinedOf(values, valueText));
  }
  for (const study::ExpectedOfMap& one : task.expected) {
    fmt::print(out, "  {}\n", reportLine(one.subject(), one.expectation.bounds, one.measured));
  }
}

int runMapTask(MapTask& task, const pipeline::MapOptions& options, std::ostream& out) {
  const study::MapRuns runs(task.scene);
  const system::AdvisoryLock lock(task.files.npy,
                                  options.part ? system::Lock::Shared : system::Lock::Exclusive);
  const pipeline::MadeMap made =
      withProgress(task, options, "tiles", [&](const pipeline::MapOptions& shown) {
        return pipeline::makeMap(task.scene, runs, task.files, shown);
      });
  const auto tiles = [&](std::size_t count) {
    return fmt::format("{} of {} tiles", count, made.tiles);
  };
  if (!made.isWhole) return reportInterrupt(task, tiles(made.finished), task.files.tiles, out);
  if (made.found > 0) reportKept(tiles(made.found), out);
  if (options.part) {
    fmt::print(out, "  part {} of {} is done: {}\n", options.part->number, options.part->count,
               countText(static_cast<std::int64_t>(made.tiles), "tile"));
    return kDone;
  }
  reportResult(task, made.result, runs, out);
  task.written =
      pipeline::writeMap(task.scene, runs, made.result, task.files, options.execution.threads);
  reportWritten(task, out);
  return statusOf(std::ranges::all_of(task.expected, &study::ExpectedOfMap::isMet));
}

int runFilmTask(MapTask& task, const pipeline::MapOptions& options, std::ostream& out) {
  const system::AdvisoryLock lock(task.files.film, system::Lock::Exclusive);
  const pipeline::MadeFilm made =
      withProgress(task, options, "frames", [&](const pipeline::MapOptions& shown) {
        return pipeline::makeFilm(task.scene, task.files, shown);
      });
  const auto frames = [&](std::size_t count) {
    return fmt::format("{} of {} frames", count, made.frames);
  };
  if (!made.isWhole)
    return reportInterrupt(task, frames(made.finished), task.files.filmFrames, out);
  if (made.wasDone) {
    fmt::print(out, "  already done: {}\n", oneLine(task.files.film.string()));
    return kDone;
  }
  if (made.found > 0) reportKept(frames(made.found), out);
  task.written = {task.files.film.string()};
  reportWritten(task, out);
  return kDone;
}

int makeMaps(const MapArguments& arguments) {
  pipeline::MapOptions options = arguments.options;
  if (!arguments.part.empty()) options.part = partOf(arguments.part);
  std::vector<MapTask> tasks = readMapTasks(arguments, options);
  options.execution.stop = &catchInterrupts();
  const auto run = [&](std::ostream& out) {
    for (const MapTask& task : tasks) {
      system::createFolders(task.files.png().parent_path());
      store::requireWritable(task.outputs);
    }
    return inTurn(tasks, [&](std::size_t i) {
      fmt::print(out, "{}: {}\n", tasks[i].scene.name, tasks[i].scene.title);
      return (arguments.film ? runFilmTask : runMapTask)(tasks[i], options, out);
    });
  };
  return reportIfUnmet(reportBatch(arguments.json, "maps", tasks, run, mapJson));
}

}  // namespace

void addMapCommand(CLI::App& program, Action& action) {
  auto [command, arguments] = addCommand(
      program, action, "map", "Draw pictures of which each pixel is a run of the motion", makeMaps);
  command.add_option("SCENE", arguments.scenes, "Scene files with [map]")->required();
  addOption(command, "-o,--output", "DIR", arguments.folder, "Folder for the results")
      ->capture_default_str();
  addOption(command, "--threads", "N", arguments.options.execution.threads,
            "Threads to run on; by default one for each core. The results are the same")
      ->check(wholeNumber(1, 1024));
  command.add_flag("--resume", arguments.options.resume,
                   "Go on where a map stopped, and keep values of the same settings");
  command.add_flag("--film", arguments.film,
                   "Make the film that map.film describes, DIR/NAME.film.mp4, and nothing else");
  CLI::Option* overwrite =
      command.add_flag("--overwrite", arguments.options.overwrite,
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
