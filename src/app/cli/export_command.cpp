#include <cstddef>
#include <filesystem>
#include <iostream>
#include <string>
#include <system_error>
#include <vector>

#include <fmt/ostream.h>

#include "base/error.h"
#include "base/json.h"
#include "base/number_text.h"
#include "base/text.h"
#include "cli/commands.h"
#include "cli/exit_code.h"
#include "cli/input_guard.h"
#include "cli/option_checks.h"
#include "cli/scene_options.h"
#include "picture/interchange/motion_file.h"
#include "system/atomic_file.h"
#include "system/read_file.h"

namespace rotatebook::cli {
namespace {

struct ExportArguments {
  std::string scene, output, panel;
  SceneOptions sceneOptions;
  interchange::KeyOptions keys;
  bool json = false;
};

/// Returns the index of the panel with that label, or else of that number, from 1; the first one's
/// if none is named.
std::size_t panelOf(const scene::Scene& scene, const std::string& name) {
  if (name.empty()) return 0;
  if (!scene.hasPanels())
    throw InputError(fmt::format("--panel {}: {} has no panels; leave it out", name, scene.name));
  const std::vector<scene::Panel>& panels = scene.motions;
  std::string labels;
  for (std::size_t i = 0; i < panels.size(); ++i) {
    if (panels[i].label == name) return i;
    labels += (i == 0 ? "" : ", ") + quotedText(panels[i].label);
  }
  for (std::size_t i = 0; i < panels.size(); ++i) {
    if (std::to_string(i + 1) == name) return i;
  }
  throw InputError(
      fmt::format("--panel {}: {} has no such panel; take one of {}, or a number from "
                  "1 to {}",
                  oneLine(name), scene.name, labels, panels.size()));
}

/// Throws InputError if there is something at `path` that no export left.
void requireAbsentOrExported(const std::filesystem::path& path) {
  if (!interchange::isMotionFile(system::readFileOrEmpty(path))) requireAbsent(path);
}

bool isUsdz(const std::string& output) {
  if (std::filesystem::path(output).extension() == ".usdz") return true;
  requireEnding(output, ".glb", "-o", "or .usdz");
  return false;
}

void report(const std::string& name, const std::string& output, const std::string& label,
            const interchange::MotionFile& file) {
  const std::string error =
      file.errorM ? fmt::format("{} mm off at a corner", roundedText(1000 * *file.errorM, 3))
                  : fmt::format("{} degrees off", roundedText(file.errorDeg, 2));
  fmt::print(std::cout, "{}: wrote {}, {} KB: {}{} keys in {} s, at most {} between them\n", name,
             oneLine(output), (file.bytes.size() + 999) / 1000,
             label.empty() ? "" : oneLine(label) + ", ", file.keys, roundedText(file.seconds, 4),
             error);
}

void reportAsJson(const std::string& name, const std::string& output, const std::string& label,
                  const interchange::MotionFile& file) {
  std::cout << jsonLine({{"name", name},
                         {"file", output},
                         {"bytes", file.bytes.size()},
                         {"panel", orNull(label)},
                         {"keys", file.keys},
                         {"seconds", file.seconds},
                         {"error_deg", file.errorDeg},
                         {"error_m", orNull(file.errorM)},
                         {"notes", file.notes}});
}

int exportScene(const ExportArguments& arguments) {
  const scene::Scene scene = arguments.sceneOptions.read(arguments.scene);
  const std::size_t panel = panelOf(scene, arguments.panel);
  if (arguments.output.empty()) refuseSameNames({scene});
  const std::string output = arguments.output.empty() ? scene.name + ".glb" : arguments.output;
  refuseInputs(output, inputsOf(arguments.scene, scene));
  const auto exported = isUsdz(output) ? interchange::motionUsdz : interchange::motionGlb;
  requireAbsentOrExported(output);
  const interchange::MotionFile file = exported(scene, panel, arguments.keys);
  std::error_code ignored;
  const bool replaces = arguments.output.empty() && std::filesystem::exists(output, ignored);
  system::writeFileAtomically(output, file.bytes);
  (arguments.json ? reportAsJson : report)(scene.name, output, scene.motions[panel].label, file);
  for (const std::string& note : file.notes) fmt::print(std::cerr, "note: {}\n", note);
  if (replaces) fmt::print(std::cerr, "note: replaced {}\n", oneLine(output));
  return kDone;
}

}  // namespace

void addExportCommand(CLI::App& program, Action& action) {
  constexpr int kMaxKeys = 1000;
  auto [command, arguments] =
      addCommand(program, action, "export",
                 "Write a motion as an animated GLB or USDZ, for other programs; needs no graphics",
                 exportScene);
  command.add_option("SCENE", arguments.scene, "Scene file")->required();
  addOption(command, "-o,--output", "FILE", arguments.output,
            "File to write, .glb or .usdz; by default NAME.glb, in the folder where you are");
  addOption(command, "--panel", "LABEL|NUMBER", arguments.panel,
            "Panel to write, by its label or counted from 1; by default the first");
  addOption(command, "--keys", "N", arguments.keys.keysPerSecond,
            "Keys a second of the video; by default 60, or as many more as a fast spin needs")
      ->check(wholeNumber(1, kMaxKeys));
  command.add_flag("--tangents", arguments.keys.tangents,
                   "CUBICSPLINE keys with exact tangents, in place of LINEAR ones");
  command.add_flag("--json", arguments.json, "Print one JSON object");
  arguments.sceneOptions.addTo(command, /*draws=*/false);
  command.footer(R"(
The file holds the body with its materials, its turning in the world by the video's clock, and the
scene's camera. With --tangents a few keys are enough, but some programs, as Blender, drop tangents.
A GLB has bodies that deform, too, by morphs of their corners; a USDZ, for phones, only rigid ones.

Examples:
  rotatebook export scenes/starter.toml
  rotatebook export scenes/starter.toml -o book.glb --keys 15 --tangents
  rotatebook export scenes/starter.toml -o book.usdz
  rotatebook export scenes/comparisons/axes.toml --panel 2)");
}

}  // namespace rotatebook::cli
