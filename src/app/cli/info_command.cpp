#include <iostream>
#include <optional>
#include <string>
#include <vector>

#include <fmt/ostream.h>

#include "base/error.h"
#include "base/json.h"
#include "base/number_text.h"
#include "base/text.h"
#include "base/units.h"
#include "cli/commands.h"
#include "cli/exit_code.h"
#include "cli/info_report.h"
#include "cli/scene_options.h"
#include "scene/body_numbers.h"
#include "scene/scene_text.h"
#include "system/read_file.h"

namespace rotatebook::cli {
namespace {

struct InfoArguments {
  std::string path;
  std::optional<double> density, mass;
  std::string unit = "m";
  bool json = false;
  SceneOptions scene;
};

double unitOf(const std::string& unit) {
  const auto metres = parseQuantity("1 " + unit, Dimension::Length);
  if (metres) return *metres;
  const auto units = unitsOf(Dimension::Length);
  throw InputError(fmt::format("--unit {}: not a unit of length; there are {}", oneLine(unit, 40),
                               joined({units.begin(), units.end()})));
}

void requirePositive(const char* option, const std::optional<double>& value) {
  if (value && !(*value > 0 && *value < 1e60))
    throw InputError(
        fmt::format("{} {}: must be above 0, and below 1e60", option, shortestText(*value)));
}

scene::BodyNumbers bodyOfMesh(const std::string& path, const InfoArguments& options) {
  if (options.density && options.mass)
    throw InputError("--density and --mass: one follows from the other; name one of them");
  requirePositive("--density", options.density);
  requirePositive("--mass", options.mass);
  return scene::bodyNumbersOf(path, system::readInput(path, scene::kLongestMesh),
                              {unitOf(options.unit), options.density, options.mass});
}

/// A motion of a scene, or a mesh alone.
struct Info {
  std::string label;  ///< Empty but for panels.
  scene::BodyNumbers body;
  std::optional<SpinNumbers> spin{};  ///< A mesh has none.
};

void print(const std::string& head, const std::vector<Info>& infos) {
  fmt::print(std::cout, "{}\n", oneLine(head));
  for (const Info& info : infos) {
    if (!info.label.empty()) fmt::print(std::cout, "{}:\n", info.label);
    printRows(rowsOn(info.body), std::cout);
    if (info.spin) printRows(rowsOn(*info.spin), std::cout);
  }
}

Json infoJson(const Info& info) {
  return {{"label", orNull(info.label)},
          {"body", jsonOf(rowsOn(info.body))},
          {"spin", info.spin ? jsonOf(rowsOn(*info.spin)) : Json()}};
}

void printJson(const std::string& name, const std::string& title, const std::vector<Info>& infos) {
  std::cout << jsonLine(
      {{"name", name}, {"title", orNull(title)}, {"motions", arrayOf(infos, infoJson)}});
}

void showScene(const InfoArguments& options) {
  const std::string& path = options.path;
  if (path != system::kStandardInput && std::filesystem::path(path).extension() != ".toml")
    throw InputError(path + ": neither a scene (.toml) nor a mesh (.obj, .stl, .ply or .glb)");
  if (options.density || options.mass || options.unit != "m")
    throw InputError(
        fmt::format("--density, --mass and --unit are a mesh's; {} has a body of its own",
                    system::nameOfInput(path)));
  const scene::Scene scene = options.scene.read(path);
  std::vector<Info> infos;
  for (const SpinNumbers& spin : spinNumbersOf(scene))
    infos.push_back({spin.motion.label, bodyNumbersOf(spin.motion), spin});
  options.json ? printJson(scene.name, scene.title, infos)
               : print(scene.name + ": " + scene.title, infos);
}

void showMesh(const InfoArguments& options) {
  const std::string& path = options.path;
  const std::vector<Info> infos{{"", bodyOfMesh(path, options)}};
  options.json ? printJson(path, "", infos) : print(path, infos);
}

int info(const InfoArguments& arguments) {
  scene::isMesh(arguments.path) ? showMesh(arguments) : showScene(arguments);
  return kDone;
}

}  // namespace

void addInfoCommand(CLI::App& program, Action& action) {
  auto [command, arguments] = addCommand(
      program, action, "info", "Print the numbers of a scene's body and spin, or of a mesh", info);
  command
      .add_option("SCENE|MESH", arguments.path, "Scene file, or a mesh: .obj, .stl, .ply or .glb")
      ->required();
  command.add_option("--density", arguments.density,
                     "Density of a mesh [kg/m^3]; 1000, that of water, without --mass");
  command.add_option("--mass", arguments.mass, "Mass of a mesh [kg], in place of a density");
  addOption(command, "--unit", "m|cm|mm|km|in", arguments.unit,
            "Unit of a mesh's coordinates: m, cm, mm, km or in")
      ->capture_default_str();
  command.add_flag("--json", arguments.json, "Print one JSON object");
  arguments.scene.addTo(command, /*draws=*/false);
  command.footer(R"(
Of a body: volume, mass, centre, inertia about it, principal moments. Of a scene's spin: growth rate,
flip interval, period, precession with its geometric part, distance to the separatrix, and the step that
explicit Euler needs. A scene with panels has the numbers of each. A mesh must be closed, and face
outward; a broken one is refused with the edge or triangle, and nothing is changed in silence.

Examples:
  rotatebook info scenes/starter.toml
  rotatebook info scenes/starter.toml --set initial.tilt="['5 deg', 'y']" --json
  rotatebook info part.stl --unit mm --density 2700)");
}

}  // namespace rotatebook::cli
