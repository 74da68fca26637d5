#include "cli/info_command.h"

#include <array>
#include <cmath>
#include <iostream>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include <Eigen/Geometry>
#include <fmt/core.h>

#include "base/error.h"
#include "base/json.h"
#include "base/number_text.h"
#include "base/text.h"
#include "base/units.h"
#include "cli/commands.h"
#include "cli/exit_code.h"
#include "cli/scene_options.h"
#include "cli/spin_report.h"
#include "scene/body_numbers.h"
#include "scene/scene_text.h"
#include "system/read_file.h"

namespace rotatebook::cli {
namespace {

using Eigen::Vector3d;

/// Returns the vector for people: components that are only rounding, beside `scale`, are 0.
std::string bodyVectorText(const Vector3d& vector, double scale, int digits) {
  return fmt::format("({})", joinedOf(vector, [&](double number) {
                       return roundedText(std::fabs(number) < 1e-12 * scale ? 0 : number, digits);
                     }));
}

/// Returns "x" or "(0.8, 0.6, 0)", for a unit vector.
std::string axisText(const Vector3d& axis) {
  constexpr double kRounding = 1e-12;
  for (int i = 0; i < 3; ++i)
    if (std::fabs(axis[i]) > 1 - kRounding) return {"xyz"[i]};
  return bodyVectorText(axis, 1, 4);
}

std::string momentsText(const scene::SortedAxes& sorted) {
  return joinedOf(std::array{0, 1, 2}, [&](int i) {
    return fmt::format("{}{} about {}", roundedText(sorted.moments[i], 6), i == 0 ? " kg m^2" : "",
                       axisText(sorted.axes.col(i)));
  });
}

std::string pairText(const std::array<std::size_t, 2>& triangles) {
  return fmt::format("triangles {} and {}", triangles[0] + 1, triangles[1] + 1);
}

/// Returns what there is to say about the surface.
std::string surfaceText(const std::optional<scene::BodySurface>& surface) {
  if (!surface) return "the book, a cuboid";
  const std::string shells =
      surface->shells == 1
          ? "one closed surface"
          : fmt::format(
                "{} closed surfaces, which add up: also where they overlap; one that faces "
                "inward takes away",
                surface->shells);
  std::vector<std::string> notes = surface->notes;
  if (surface->crossing) {
    notes.push_back(pairText(*surface->crossing) +
                    " cross each other; what a surface encloses twice counts twice");
  }
  if (surface->overlap) {
    notes.push_back(
        pairText(*surface->overlap) +
        " meet at an edge around which something is enclosed twice, or taken away where "
        "nothing is; it counts so");
  }
  std::string text = fmt::format("{} triangles, {}", surface->triangles, shells);
  for (const std::string& note : notes) text += "\n  note        " + note;
  return text;
}

}  // namespace

void reportBody(const scene::BodyNumbers& numbers, std::ostream& output) {
  const auto& body = numbers.properties;
  const scene::SortedAxes sorted = scene::sortedAxesOf(body);
  output << fmt::format(
      "  body        {}\n  volume      {} m^3\n  mass        {} kg\n  centre      {} m\n"
      "  inertia     about the centre [kg m^2]\n",
      surfaceText(numbers.surface), roundedText(body.volume, 6), roundedText(body.mass, 6),
      bodyVectorText(body.centre, std::cbrt(body.volume), 6));
  for (int row = 0; row < 3; ++row)
    output << "              " << bodyVectorText(body.inertia.row(row), sorted.moments[2], 6)
           << '\n';
  output << "  moments     " << momentsText(sorted) << '\n';
  if (sorted.growth > 1e-6) {
    output << fmt::format(
        "  middle axis a spin of w about it is unstable: deviations grow as e^({} w t)\n",
        roundedText(sorted.growth, 4));
  } else {
    output << "  middle axis two moments are equal, or nearly so: no spin is unstable\n";
  }
}

Json bodyJson(const scene::BodyNumbers& numbers) {
  using scene::BodySurface;
  const auto& body = numbers.properties;
  const scene::SortedAxes sorted = scene::sortedAxesOf(body);
  const auto count = [&](std::size_t BodySurface::*member) {
    return numbers.surface ? Json((*numbers.surface).*member) : Json();
  };
  const auto pair = [&](auto BodySurface::*member) {
    const bool isThere = numbers.surface && (*numbers.surface).*member;
    const auto number = [](std::size_t triangle) { return triangle + 1; };
    return isThere ? arrayOf(*((*numbers.surface).*member), number) : Json();
  };
  return {{"volume_m3", body.volume},
          {"mass_kg", body.mass},
          {"centre_m", vectorJson(body.centre)},
          {"inertia_kg_m2", matrixJson(body.inertia)},
          {"moments_kg_m2", vectorJson(sorted.moments)},
          {"axes", matrixJson(sorted.axes.transpose())},
          {"triangles", count(&BodySurface::triangles)},
          {"shells", count(&BodySurface::shells)},
          {"crossing", pair(&BodySurface::crossing)},
          {"overlap", pair(&BodySurface::overlap)},
          {"notes", numbers.surface ? numbers.surface->notes : std::vector<std::string>{}},
          {"closed", true}};
}

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
  std::cout << oneLine(head) << '\n';
  for (const Info& info : infos) {
    if (!info.label.empty()) std::cout << info.label << ":\n";
    reportBody(info.body, std::cout);
    if (info.spin) reportSpin(*info.spin, std::cout);
  }
}

Json infoJson(const Info& info) {
  return {{"label", orNull(info.label)},
          {"body", bodyJson(info.body)},
          {"spin", info.spin ? spinJson(*info.spin) : Json()}};
}

void printJson(const std::string& name, const std::string& title, const std::vector<Info>& infos) {
  std::cout << jsonText({{"name", name},
                         {"title", orNull(title)},
                         {"motions", arrayOf(infos, infoJson)}})
            << '\n';
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
