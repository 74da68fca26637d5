// `rotatebook watch`: a still that follows a scene while it is edited.
#include <atomic>
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <iostream>
#include <map>
#include <optional>
#include <string>
#include <sys/stat.h>
#include <thread>
#include <tuple>
#include <utility>
#include <vector>

#include <fmt/ostream.h>

#include "base/error.h"
#include "base/text.h"
#include "cli/commands.h"
#include "cli/device_options.h"
#include "cli/exit_code.h"
#include "cli/input_guard.h"
#include "cli/interrupt.h"
#include "cli/live_follower.h"
#include "cli/option_checks.h"
#include "cli/scene_options.h"
#include "picture/still.h"
#include "store/scene_file.h"

namespace rotatebook::cli {
namespace {

struct WatchArguments {
  std::string scene;
  SceneOptions sceneOptions;
  DeviceOptions deviceOptions;
  std::optional<double> time;
  std::string output, live;
  const CLI::Option* asksLive = nullptr;  ///< --live, with `live` or empty.
};

/// A version of a file, unlike that of one which replaces it; nothing if there is no file.
using Version = std::optional<std::tuple<dev_t, ino_t, off_t, time_t, long>>;

/// The versions of files, looked at again and again: folders on networks tell of no changes.
class WatchedFiles {
 public:
  /// Watches the scene, from before it is read.
  explicit WatchedFiles(const std::string& scene) { versions_[scene] = versionOf(scene); }

  /// Watches these files alone: those it watched before from the version that it saw, since a later
  /// one may not have been read, others from the present one on.
  void setFiles(const std::vector<Input>& inputs) {
    std::map<std::filesystem::path, Version> versions;
    for (const Input& input : inputs) {
      const auto seen = versions_.find(input.path);
      versions[input.path] = seen == versions_.end() ? versionOf(input.path) : seen->second;
    }
    versions_ = std::move(versions);
  }

  /// Waits until a file changes, and then until none is being written; returns early if `stop`.
  void waitForChange(const std::atomic<bool>& stop) {
    const auto look = [&] {
      std::this_thread::sleep_for(kPause);
      bool hasChanged = false;
      for (auto& [path, version] : versions_) {
        const Version now = versionOf(path);
        hasChanged |= now != version;
        version = now;
      }
      return hasChanged;
    };
    while (!stop && !look()) continue;
    while (!stop && look()) continue;
  }

 private:
  static constexpr std::chrono::milliseconds kPause{50};

  static Version versionOf(const std::filesystem::path& path) {
    struct stat found {};
    if (stat(path.c_str(), &found) != 0) return std::nullopt;
    return std::tuple(found.st_dev, found.st_ino, found.st_size, found.st_ctim.tv_sec,
                      found.st_ctim.tv_nsec);
  }

  std::map<std::filesystem::path, Version> versions_;
};

/// The pictures of a scene that is watched.
struct Shown {
  std::string still;
  std::optional<LiveFollower> live;
};

/// Returns them once nothing is in their way. Throws InputError.
Shown shownOf(const WatchArguments& arguments) {
  const std::filesystem::path scene(arguments.scene);
  const std::string name = scene.stem().string();
  Shown shown{arguments.output.empty() ? name + ".png" : arguments.output, std::nullopt};
  requirePictureOutput(shown.still, {{scene, "the scene itself"}});
  if (arguments.asksLive->count() == 0) return shown;
  const std::filesystem::path book =
      arguments.live.empty() ? installedBook() : std::filesystem::path(arguments.live);
  shown.live.emplace(book, std::filesystem::path(shown.still).parent_path(), name);
  fmt::print(std::cout, "{}: open {} in a browser\n", name, oneLine(shown.live->page().string()));
  return shown;
}

/// Reads the scene and draws it anew. Throws InputError; leaves the last picture then.
void drawAnew(const WatchArguments& arguments, const Shown& shown, WatchedFiles& files) {
  const scene::Scene scene = arguments.sceneOptions.read(arguments.scene);
  const std::vector<Input> inputs = inputsOf(arguments.scene, scene);
  files.setFiles(inputs);
  requirePictureOutput(shown.still, inputs);
  if (shown.live) shown.live->play(scene, arguments.scene);
  const std::int64_t frame =
      picture::renderStill(scene, arguments.time, shown.still, arguments.deviceOptions.choice());
  fmt::print(std::cout, "{}: wrote frame {} to {}\n", scene.name, frame, oneLine(shown.still));
}

int watchScene(const WatchArguments& arguments) {
  store::requireScene(arguments.scene);
  const Shown shown = shownOf(arguments);
  const std::atomic<bool>& stop = catchInterrupts();
  WatchedFiles files(arguments.scene);
  while (!stop) {
    try {
      drawAnew(arguments, shown, files);
    } catch (const InputError& error) {
      printError(error.what());
      if (shown.live) shown.live->say(error.what());
    }
    files.waitForChange(stop);
  }
  return interruptStatus();
}

}  // namespace

void addWatchCommand(CLI::App& program, Action& action) {
  auto [command, arguments] = addCommand(
      program, action, "watch",
      "Draw a still, and play the live book, anew whenever a scene is saved", watchScene);
  command.add_option("SCENE", arguments.scene, "Scene file")->required()->check(notStandardInput);
  addOption(command, "-o,--output", "FILE", arguments.output,
            "PNG to write; by default NAME.png in the folder where you are");
  addOption(command, "--time", "SECONDS", arguments.time,
            "Time in the video, whose nearest frame is drawn; by default the poster's");
  arguments.asksLive =
      addOption(
          command, "--live", "PLAY.html", arguments.live,
          "Play the scene in NAME.live.html beside the still, too, by the live book that make "
          "play makes; by default that which is installed with the program")
          ->expected(0, 1);
  arguments.sceneOptions.addTo(command);
  arguments.deviceOptions.addTo(command);
  command.footer(R"(
The files that the scene names are watched, too. A mistake is printed, and the last picture stays
until it is corrected. With --live, NAME.live.html in a browser plays what was saved, too, from the
moment and the side that it shows. Ctrl-C ends it, with the exit status 130.

Example:
  rotatebook watch my.toml)");
}

}  // namespace rotatebook::cli
