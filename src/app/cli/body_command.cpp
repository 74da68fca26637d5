#include <iostream>
#include <memory>
#include <optional>
#include <string>

#include "base/error.h"
#include "base/number_text.h"
#include "base/text.h"
#include "base/units.h"
#include "body/closed_mesh.h"
#include "body/mass_properties.h"
#include "body/mesh_readers.h"
#include "body/self_crossing.h"
#include "body/shells.h"
#include "cli/commands.h"
#include "cli/exit_code.h"
#include "cli/scene_options.h"
#include "physics/motion_start.h"
#include "picture/named_file.h"
#include "report/body_report.h"
#include "scene/scene_text.h"
#include "scene/solid_numbers.h"
#include "system/read_file.h"

namespace rotatebook::cli {
namespace {

constexpr double kWater = 1000;  // [kg/m^3]

struct BodyOptions {
  std::optional<double> density, mass;
  std::string unit = "m";
  bool json = false;
  SceneOptions scene;
};

double unitOf(const std::string& unit) {
  const auto metres = parseQuantity("1 " + unit, Dimension::Length);
  if (metres) return *metres;
  throw InputError("--unit " + oneLine(unit, 40) + ": not a unit of length; there are " +
                   joinedOf(unitsOf(Dimension::Length),
                            [](std::string_view name) { return std::string(name); }));
}

void requirePositive(const char* option, const std::optional<double>& value) {
  if (value && !(*value > 0 && *value < 1e60))
    throw InputError(std::string(option) + " " + shortestText(*value) +
                     ": must be above 0, and below 1e60");
}

report::BodySurface surfaceOf(const body::ClosedMesh& file) {
  const body::Shells shells = body::shellsOf(file.mesh);
  const auto inFile = [&](auto pair) {
    if (pair) pair = {file.closing.numberOf((*pair)[0]), file.closing.numberOf((*pair)[1])};
    return pair;
  };
  return {file.mesh.triangles.size(), shells.count, inFile(body::findSelfCrossing(file.mesh)),
          inFile(shells.overlap), file.closing.notes};
}

report::Bodies bodyOfMesh(const std::string& path, const BodyOptions& options) {
  if (options.density && options.mass)
    throw InputError("--density and --mass: one follows from the other; name one of them");
  requirePositive("--density", options.density);
  requirePositive("--mass", options.mass);
  const double unit = unitOf(options.unit);
  body::ClosedMesh file = body::readMesh(path, system::readInput(path, scene::kLongestMesh));
  try {
    body::TriangleMesh& mesh = file.mesh;
    for (Eigen::Vector3d& point : mesh.points) point *= unit;
    double density = options.density.value_or(kWater);
    if (options.mass) density = *options.mass / body::massPropertiesOf(mesh, 1).volume;
    const body::MassProperties properties = body::massPropertiesOf(mesh, density);
    rigid::checkInertia(properties.inertia);
    return {path, {{path, properties, surfaceOf(file)}}};
  } catch (const InputError& error) {
    throw InputError(oneLine(path, 200) + ": " + error.what());
  }
}

report::BodyNumbers bodyOfBook(const scene::Panel& motion) {
  const rigid::PrincipalAxes inertia = physics::modelInertia(motion);
  const Eigen::Matrix3d& axes = inertia.bodyFromPrincipal;
  return {"",
          {motion.body.size.prod(),
           motion.body.mass,
           {0, 0, 0},
           axes * inertia.moments.asDiagonal() * axes.transpose()}};
}

/// The scene has the mesh's numbers, but for its centre.
report::BodyNumbers bodyOfMeshFile(const scene::Scene& scene, const scene::Solid& solid) {
  const body::ClosedMesh file = body::readMesh(
      solid.mesh.name, picture::readNamedFile(scene.folder, solid.mesh.name, scene::kLongestMesh,
                                              scene.allowOutside));
  report::BodyNumbers numbers{"", scene::numbersOf(solid).properties, surfaceOf(file)};
  numbers.properties.centre = body::massPropertiesOf(file.mesh, 1).centre * solid.mesh.unit;
  return numbers;
}

report::BodyNumbers bodyOfParts(const scene::Solid& solid) {
  report::BodySurface surface;
  for (const scene::BodyPart& part : solid.parts) {
    const body::TriangleMesh mesh = scene::placed(part).surface;
    surface.triangles += mesh.triangles.size();
    surface.shells += body::shellsOf(mesh).count;
  }
  return {"", scene::numbersOf(solid).properties, surface};
}

report::Bodies bodiesOfScene(const std::string& path, const BodyOptions& options) {
  if (std::filesystem::path(path).extension() != ".toml")
    throw InputError(path + ": neither a scene (.toml) nor a mesh (.obj, .stl, .ply or .glb)");
  if (options.density || options.mass || options.unit != "m")
    throw InputError("--density, --mass and --unit are a mesh's; " + path +
                     " has a body of its own");
  const scene::Scene scene = options.scene.read(path);
  report::Bodies bodies{scene.name, {}};
  for (const scene::Panel& motion : scene::motionsOf(scene)) {
    const scene::Solid& solid = motion.solid;
    bodies.bodies.push_back(solid.isBook()        ? bodyOfBook(motion)
                            : solid.parts.empty() ? bodyOfMeshFile(scene, solid)
                                                  : bodyOfParts(solid));
    bodies.bodies.back().name = motion.label.empty() ? scene.name : motion.label;
  }
  return bodies;
}

}  // namespace

void addBodyCommand(CLI::App& program, Action& action) {
  auto path = std::make_shared<std::string>();
  auto options = std::make_shared<BodyOptions>();
  CLI::App* command =
      program.add_subcommand("body", "Print the mass, centre and inertia of a body");
  command->add_option("SCENE|MESH", *path, "Scene file, or a mesh: .obj, .stl, .ply or .glb")
      ->required();
  command->add_option("--density", options->density,
                      "Density of a mesh [kg/m^3]; 1000, that of water, without --mass");
  command->add_option("--mass", options->mass, "Mass of a mesh [kg], in place of a density");
  command->add_option("--unit", options->unit, "Unit of a mesh's coordinates: m, cm, mm, km or in")
      ->capture_default_str();
  command->add_flag("--json", options->json, "Print one JSON object");
  options->scene.addTo(*command, /*draws=*/false);
  command->footer(R"(
The mesh must be closed, and face outward; a broken one is refused with the edge or triangle, and
nothing is changed in silence; triangles that cross each other are named. Moments are about the
centre of mass. A scene with panels has a body for each.

Examples:
  rotatebook body part.stl --unit mm --density 2700
  rotatebook body scenes/starter.toml --json)");
  command->callback([path, options, &action] {
    action = [path, options] {
      const bool isMesh = body::isMeshName(*path);
      const auto bodies = isMesh ? bodyOfMesh(*path, *options) : bodiesOfScene(*path, *options);
      (options->json ? report::reportBodiesAsJson : report::reportBodies)(bodies, std::cout);
      return kDone;
    };
  });
}

}  // namespace rotatebook::cli
