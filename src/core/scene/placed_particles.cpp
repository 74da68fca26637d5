#include "scene/placed_particles.h"

#include <array>
#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <variant>

#include "base/error.h"
#include "base/number_text.h"
#include "base/text.h"
#include "body/mesh_readers.h"
#include "physics/particle_places.h"
#include "physics/spring_analysis.h"
#include "scene/names.h"
#include "scene/sections.h"
#include "scene/solid_numbers.h"
#include "scene/solid_particles.h"
#include "scene/spin_axis.h"

namespace rotatebook::scene {
namespace {

using physics::Arrangement;
using physics::MassSpringSystem;

/// Returns whether a value of [body] says that the body is a box.
bool saysBox(const document::TomlNode& node) {
  const auto* shape = std::get_if<std::string>(&node.value);
  return shape != nullptr && (*shape == "book" || *shape == "box" || *shape == "cards");
}

ValueReader stated(const ValueReader& file, std::string_view key) {
  return file.find("simulation", key).value_or(file);
}

MassSpringSystem systemOf(const Motion& motion) {
  const physics::ParticleSettings& settings = motion.simulation.particles;
  switch (settings.arrangement) {
    case Arrangement::Vertices:
      return particlesAtVertices(motion);
    case Arrangement::Grid:
      return particlesOnGrid(motion, settings.cells);
    case Arrangement::Corners:
    case Arrangement::Equimomental:
      break;
  }
  return physics::particlesOf(motion);
}

std::string looseness(const MassSpringSystem& system) {
  constexpr std::size_t kFew = 100;
  if (const int pieces = physics::countPieces(system); pieces > 1)
    return "the particles are in " + std::to_string(pieces) + " pieces that no springs join";
  if (system.places.size() > kFew) return "there are more than six zero modes";
  return "there are " + std::to_string(physics::countZeroModes(system)) +
         " zero modes, not the six of a rigid body";
}

void requireShape(const ValueReader& place, const MassSpringSystem& system,
                  Arrangement arrangement) {
  if (physics::holdShape(system)) return;
  const char* remedy = arrangement == Arrangement::Grid ? "make the grid finer"
                       : arrangement == Arrangement::Equimomental
                           ? "a plane body has its equimomental particles in its plane"
                           : "take \"equimomental\" or a grid";
  place.fail(place.name() + " = " + describe(place.node()) + ": the " +
             std::to_string(system.springs.size()) + " springs between " +
             std::to_string(system.places.size()) +
             " particles don't hold the shape: " + looseness(system) + "; " + remedy);
}

void requireStableStep(const ValueReader& file, const Motion& motion,
                       const MassSpringSystem& system) {
  const physics::SimulationSettings& simulation = motion.simulation;
  const double step = simulation.timePerFrame / simulation.substeps;
  const double longest = physics::largestStableStep(motion, system);
  if (step <= longest) return;
  const std::string integrator(nameOf(kIntegrators, simulation.integrator));
  const ValueReader place = file.find("simulation", "substeps").value_or(stated(file, "particles"));
  if (longest == 0) {
    place.fail("no step is stable with the integrator \"" + integrator +
               "\" and these particles; take \"verlet\", or simulation.damping");
  }
  const auto milliseconds = [](double seconds) { return roundedText(1e3 * seconds, 3) + " ms"; };
  place.fail("steps of " + milliseconds(step) +
             " are too long for these particles: the longest "
             "that is stable with \"" +
             integrator + "\" is " + milliseconds(longest) + "; take simulation.substeps = " +
             std::to_string(std::llround(std::ceil(simulation.timePerFrame / longest))) +
             " or more, or softer springs");
}

}  // namespace

void checkParticlesBody(const ValueReader& section, const physics::SimulationSettings& settings) {
  if (settings.model != physics::Model::Particles) return;
  const Arrangement arrangement = settings.particles.arrangement;
  for (const char* key : {"shape", "mesh", "part"}) {
    const auto value = section.find(key);
    if (!value || saysBox(value->node()) || arrangement != Arrangement::Corners) continue;
    value->fail(value->name() +
                " isn't a box, at whose corners the model \"particles\" has its particles; set "
                "simulation.particles = \"equimomental\", \"vertices\" or \"grid:12\", or choose "
                "another model");
  }
  const auto inertia = section.find("inertia");
  if (!inertia || arrangement == Arrangement::Equimomental) return;
  inertia->fail(inertia->name() +
                " is for rigid models, but the model is \"particles\", whose inertia follows from "
                "their positions; leave it out, or set simulation.particles = \"equimomental\"");
}

void placeParticles(const ValueReader& file, Motion& motion) {
  motion.particles.system.reset();
  const Arrangement arrangement = motion.simulation.particles.arrangement;
  const bool areCorners = arrangement == Arrangement::Corners;
  if (motion.simulation.model != physics::Model::Particles || areCorners) return;
  if (lacksSurface(motion)) return;
  const ValueReader place = stated(file, "particles");
  MassSpringSystem system;
  try {
    system = systemOf(motion);
  } catch (const InputError& error) {
    place.fail(place.name() + " = " + describe(place.node()) + " " + error.what());
  }
  requireShape(place, system, arrangement);
  requireStableStep(file, motion, system);
  if (!physics::areEight(arrangement))
    motion.particles.system = std::make_shared<const MassSpringSystem>(std::move(system));
}

void placeInMesh(Motion& motion, const ReadNamedFile& readNamedFile) {
  MeshFile& mesh = motion.solid.mesh;
  body::TriangleMesh surface = body::readMesh(mesh.name, readNamedFile(mesh.name, kLongestMesh));
  MeshFile file = meshFileOf(mesh.name, surface);
  file.unit = mesh.unit;
  if (file != mesh)
    throw InputError("the file " + quotedText(mesh.name) + " has changed: it is another body");
  mesh.surface = std::make_shared<const body::TriangleMesh>(std::move(surface));
  motion.particles.system = std::make_shared<const MassSpringSystem>(systemOf(motion));
  if (motion.initial.about) turnSpinToAxis(motion);
}

}  // namespace rotatebook::scene
