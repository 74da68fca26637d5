#include <algorithm>
#include <filesystem>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

#include <fmt/ostream.h>

#include "base/error.h"
#include "base/text.h"
#include "cli/clip_options.h"
#include "cli/commands.h"
#include "cli/device_options.h"
#include "cli/exit_code.h"
#include "cli/input_guard.h"
#include "cli/option_checks.h"
#include "cli/planning.h"
#include "cli/scene_options.h"
#include "farm/farm_report.h"
#include "farm/plan_folder.h"
#include "farm/plan_texts.h"
#include "farm/status.h"
#include "farm/submission.h"
#include "picture/preflight.h"
#include "plot/map_plot.h"
#include "store/footprint.h"
#include "store/scene_file.h"
#include "system/atomic_file.h"

namespace rotatebook::cli {
namespace {

namespace fs = std::filesystem;

struct SubmitArguments {
  std::string work;
  std::vector<std::string> scenes;
  SceneOptions sceneOptions;
  DeviceOptions deviceOptions;
  std::string folder = "out";
  std::vector<std::string> formats;
  bool noMp4 = false;
  bool noPng = false;
  bool slurm = false;
  std::string plan;
  bool dryRun = false;
  std::int64_t chunk = 0;
  int cores = 1;
  farm::JobOptions job;
  std::vector<const CLI::Option*> ofRender{};  ///< Options that mean nothing to other work.
};

farm::Work workOf(const SubmitArguments& arguments) {
  if (const auto work = farm::parseWork(arguments.work)) return *work;
  throw InputError(quotedText(arguments.work) +
                   ": unknown work; write submit render, submit map or submit study");
}

void requireEngine(const SubmitArguments& arguments) {
  if (arguments.slurm == arguments.plan.empty()) return;
  throw InputError(arguments.slurm ? "--slurm and --plan exclude each other"
                                   : "submit to what? Give --slurm, or --plan list or parallel, "
                                     "which print the tasks for others");
}

void refuseWithoutEffect(const SubmitArguments& arguments, farm::Work work) {
  if (work == farm::Work::Render) return;
  for (const CLI::Option* option : arguments.ofRender) {
    if (option->count() == 0) continue;
    throw InputError(fmt::format("{} is for submit render; submit {} draws no clip: leave it out",
                                 option->get_name(), nameOf(work)));
  }
  if (work != farm::Work::Study || arguments.chunk == 0) return;
  throw InputError("--chunk: a study is one task; leave it out");
}

store::ResultKind kindOf(farm::Work work) {
  if (work == farm::Work::Render) return store::ResultKind::Clip;
  return work == farm::Work::Map ? store::ResultKind::Map : store::ResultKind::Study;
}

/// Reads all scenes, and finds now what each task would find.
std::vector<SceneOfFile> readScenes(const SubmitArguments& arguments, const PlanWishes& wishes) {
  const farm::Work work = wishes.work;
  std::vector<SceneOfFile> read;
  const auto [scenes, inputs] = readAllScenes(arguments.scenes, [&](const std::string& path) {
    scene::Scene scene = arguments.sceneOptions.read(path);
    if (work == farm::Work::Render) {
      picture::preflight(scene);
      refuseOpaque(scene, videoFormatsOf(arguments.formats, arguments.noMp4));
    }
    if (work == farm::Work::Map) {
      requireMap(scene, path);
      plot::requireMapLetters(scene);
    }
    read.push_back({path, scene});
    return scene;
  });
  refuseSameNames(scenes);
  store::Footprint plan;
  addPlanTo(plan, farm::planFiles(wishes.folder, work));
  refuseInputs(plan, inputs);
  for (const scene::Scene& scene : scenes) {
    refuseLosses(kindOf(work), scene, wishes.folder, inputs, wishes.formats);
  }
  return read;
}

/// Returns the options of the command that every task has, too.
std::vector<std::string> argumentsOfTasks(const SubmitArguments& arguments, farm::Work work) {
  std::vector<std::string> words = arguments.sceneOptions.words();
  if (work != farm::Work::Render) return words;
  arguments.deviceOptions.parsed();  // Throws for a mistake in them.
  std::ranges::move(arguments.deviceOptions.words(), std::back_inserter(words));
  return words;
}

PlanWishes wishesOf(const SubmitArguments& arguments, farm::Work work) {
  PlanWishes wishes{.work = work,
                    .folder = fs::absolute(arguments.folder).lexically_normal(),
                    .cores = arguments.cores,
                    .arguments = argumentsOfTasks(arguments, work)};
  if (work != farm::Work::Render) return wishes;
  wishes.formats = videoFormatsOf(arguments.formats, arguments.noMp4);
  std::vector<std::string> names;
  for (const video::VideoFormat format : wishes.formats) names.emplace_back(nameOf(format));
  wishes.joinArguments = names.empty() ? std::vector<std::string>{"--no-mp4"}
                                       : std::vector<std::string>{"--format", joined(names, ",")};
  if (arguments.noPng) wishes.joinArguments.emplace_back(farm::kNoPng);
  return wishes;
}

/// Divides a plan by these efforts: clips that are short, or have no PNGs to join, stay whole.
void divide(farm::Plan& plan, const std::vector<farm::Effort>& efforts,
            const SubmitArguments& arguments, const farm::Slots& slots) {
  if (plan.work == farm::Work::Render) {
    const farm::DividedClips clips =
        farm::divideClips(efforts, arguments.chunk, slots, !arguments.noPng);
    for (std::size_t i = 0; i < efforts.size(); ++i) {
      plan.scenes[i].parts = clips.parts[i];
      plan.scenes[i].startsTask = clips.startsTask[i];
    }
    return;
  }
  const std::vector<std::int64_t> parts = arguments.chunk > 0
                                              ? farm::partsOfChunk(efforts, arguments.chunk, slots)
                                              : farm::partsOf(efforts, slots);
  for (std::size_t i = 0; i < parts.size(); ++i) plan.scenes[i].parts = parts[i];
}

/// Divides a plan by what is measured here, or by --chunk.
void divide(farm::Plan& plan, const std::vector<SceneOfFile>& scenes,
            const SubmitArguments& arguments, const farm::Slots& slots) {
  std::vector<farm::Effort> efforts = unmeasuredEfforts(plan);
  try {
    if (arguments.chunk == 0)
      efforts = measureEfforts(plan, scenes, arguments.deviceOptions.parsed());
  } catch (const MachineError& error) {
    throw MachineError(
        fmt::format("can't measure how fast a task is: {}; say how many {} each is "
                    "to have with --chunk",
                    error.what(), farm::unitsOf(plan.work)));
  }
  divide(plan, efforts, arguments, slots);
}

/// Returns the plan to go on with, or a new one, divided.
farm::StoredPlan preparedPlan(const SubmitArguments& arguments, const PlanWishes& wishes,
                              const farm::PlanFiles& files, const farm::Slots& slots) {
  const std::vector<SceneOfFile> scenes = readScenes(arguments, wishes);
  farm::Plan plan = planOf(scenes, wishes);
  const auto earlier = farm::continued(plan, files);
  if (earlier && arguments.chunk == 0) return *earlier;
  divide(plan, scenes, arguments, slots);
  if (!earlier || earlier->plan == plan) return earlier.value_or(farm::StoredPlan{plan});
  farm::requireNoneQueued(*earlier, plan);
  return {plan};
}

int printPlan(const SubmitArguments& arguments, const PlanWishes& wishes,
              const farm::PlanFiles& files) {
  const farm::PlanFormat& format = farm::planFormat(arguments.plan);
  const farm::StoredPlan stored = preparedPlan(arguments, wishes, files, {});
  if (!arguments.dryRun) {
    system::createFolders(files.folder);
    farm::storePlan(files, stored);
  }
  if (farm::isMade(stored.plan, files)) {
    std::clog << "nothing is missing\n";
  } else {
    std::cout << format.text(stored.plan, farm::missingTasks(stored.plan, files));
  }
  return kDone;
}

int printScripts(const farm::StoredPlan& stored, const farm::PlanFiles& files,
                 const SubmitArguments& arguments, const farm::ClusterLimits& limits) {
  std::vector<std::int64_t> missing;
  for (const farm::Task& task : farm::missingTasks(stored.plan, files))
    missing.push_back(task.number);
  const auto print = [&](const fs::path& path, const std::string& text) {
    fmt::print(std::cout, "==> {} <==\n{}\n", oneLine(path.string()), text);
  };
  const auto script = [&](const std::vector<std::int64_t>& tasks) {
    return jobScript(stored.plan, files, tasks, arguments.job, limits.requeues75);
  };
  print(files.tasks, farm::listText(stored.plan, farm::tasksOf(stored.plan)));
  if (!missing.empty()) print(files.partScript, script(missing));
  if (!joinedScenesOf(stored.plan).empty()) print(files.joinScript, script({}));
  return kDone;
}

int submitToSlurm(const SubmitArguments& arguments, const PlanWishes& wishes,
                  const farm::PlanFiles& files) {
  const farm::ClusterLimits limits = farm::readLimits();
  const farm::Slots slots{farm::countProcessors(arguments.job.partition) / arguments.cores,
                          limits.maxTasks()};
  const farm::StoredPlan stored = preparedPlan(arguments, wishes, files, slots);
  if (arguments.dryRun) return printScripts(stored, files, arguments, limits);
  const farm::Submission submission = farm::submit(stored, files, arguments.job, limits);
  farm::reportSubmission(stored.plan, submission, std::cout);
  return kDone;
}

int submit(const SubmitArguments& arguments) {
  const farm::Work work = workOf(arguments);
  requireEngine(arguments);
  refuseWithoutEffect(arguments, work);
  const PlanWishes wishes = wishesOf(arguments, work);
  const farm::PlanFiles files = farm::planFiles(wishes.folder, work);
  return arguments.slurm ? submitToSlurm(arguments, wishes, files)
                         : printPlan(arguments, wishes, files);
}

constexpr const char* kSubmitFooter = R"(
Divides the work into tasks of some minutes, by the time that a few frames take here, or by --chunk,
and sends them to Slurm as one array job, and a job that joins their results in DIR, which all
machines see. Tasks that are killed are tried again, and go on. The same command once more sends only
what is missing. What is sent is in DIR/farm, as text; 'rotatebook status DIR' shows what becomes of it.
A study is one task. A task takes several clips if they are short, or have no PNGs; these aren't
joined. --plan prints the tasks, for machines without Slurm.

Examples:
  rotatebook submit render my.toml -o /shared/clips --slurm --partition cpu --time 1:00:00
  rotatebook submit map scenes/maps/*.toml -o /shared/maps --slurm --sbatch=--qos=low
  rotatebook submit render my.toml --plan parallel > farm.sh
  rotatebook submit render clips/*.toml --no-png --plan list)";

void addJobOptions(CLI::App& command, SubmitArguments& arguments, CLI::Option* slurm) {
  constexpr const char* kSlurm = "Slurm";
  farm::JobOptions& job = arguments.job;
  const auto add = [&](const char* name, std::string& value, const char* help, const char* type) {
    addOption(command, name, type, value, help, kSlurm)->needs(slurm);
  };
  add("--partition", job.partition, "Partition of the jobs", "NAME");
  add("--account", job.account, "Account that they are charged to", "NAME");
  add("--time", job.time, "Longest time of a task, e.g. 30:00", "TIME");
  add("--constraint", job.constraint, "Features that their nodes must have", "LIST");
  repeated(addOption(command, "--sbatch", "OPTION", job.others,
                     "Another option of sbatch, e.g. --sbatch=--qos=low; may be repeated", kSlurm))
      ->needs(slurm);
}

}  // namespace

void addSubmitCommand(CLI::App& program, Action& action) {
  auto [command, arguments] =
      addCommand(program, action, "submit",
                 "Have many machines render, map or study: by Slurm or others", submit);
  command.add_option("WORK", arguments.work, "render, map or study")->required();
  command.add_option("SCENE", arguments.scenes, "Scene files")->required()->check(notStandardInput);
  addOption(command, "-o,--output", "DIR", arguments.folder, "Folder for the results")
      ->capture_default_str();
  CLI::Option* slurm =
      command.add_flag("--slurm", arguments.slurm, "Send the tasks to the cluster that is here");
  addOption(command, "--plan", "list|parallel", arguments.plan,
            "Print the tasks instead, as list or parallel");
  command.add_flag("--dry-run", arguments.dryRun,
                   "Print what would be sent; write and send nothing");
  addOption(command, "--chunk", "N", arguments.chunk,
            "Frames or tiles of a task; by default measured")
      ->check(wholeNumber(1, 1'000'000'000));
  addOption(command, "--cores", "N", arguments.cores, "Cores of a task")
      ->check(wholeNumber(1, farm::kMaxCores))
      ->capture_default_str();
  addFormats(command, arguments.formats);
  command.add_flag("--no-mp4", arguments.noMp4, "Write no MP4")->group("Clip");
  command.add_flag(farm::kNoPng, arguments.noPng, "Write no PNG frames: a task takes whole clips")
      ->group("Clip");
  addJobOptions(command, arguments, slurm);
  arguments.sceneOptions.addTo(command);
  arguments.deviceOptions.addTo(command);
  for (const char* name :
       {"--format", "--no-mp4", farm::kNoPng, "--size", "--device", "--require-hardware"})
    arguments.ofRender.push_back(command.get_option(name));
  command.footer(kSubmitFooter);
}

namespace {

struct StatusArguments {
  std::string folder = "out";
  bool json = false;
};

int showStatus(const StatusArguments& arguments) {
  const std::vector<farm::PlanState> states = farm::statesBelow(arguments.folder);
  (arguments.json ? farm::reportStatesAsJson : farm::reportStates)(states, std::cout);
  return statusOf(std::ranges::none_of(states, &farm::PlanState::hasFailed));
}

}  // namespace

void addStatusCommand(CLI::App& program, Action& action) {
  auto [command, arguments] = addCommand(program, action, "status",
                                         "Show what has become of what was submitted", showStatus);
  command.add_option("DIR", arguments.folder, "Folder of the results")
      ->capture_default_str()
      ->check(notStandardInput);
  command.add_flag("--json", arguments.json, "Print one JSON object: scenes, tasks and jobs");
  command.footer(R"(
Shows what is done, which machine runs what, what failed, and about when it ends: from the results
in DIR, what 'rotatebook submit' left in DIR/farm, and Slurm's queue. Changes nothing.
Exit status: 0, or 1 if something failed.

Example:
  rotatebook status out)");
}

}  // namespace rotatebook::cli
