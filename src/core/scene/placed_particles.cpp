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
#include "meshes/mesh_readers.h"
#include "physics/particle_places.h"
#include "physics/spring_analysis.h"
#include "scene/keys/keys.h"
#include "scene/limits.h"
#include "scene/names.h"
#include "scene/solid_numbers.h"
#include "scene/solid_particles.h"
#include "scene/spin_axis.h"
#include "scene/step_limit.h"

namespace rotatebook::scene {
namespace {

using document::ValueReader;
using physics::Arrangement;
using physics::MassSpringSystem;
using physics::SimulationSettings;

/// Returns whether a value of [body] says that the body is a box.
bool saysBox(const document::TomlNode& node) {
  const auto* shape = std::get_if<std::string>(&node.value);
  return shape != nullptr && (*shape == "book" || *shape == "box" || *shape == "cards");
}

/// Throws InputError at simulation.particles with its value before `problem`.
[[noreturn]] void failAtParticles(const Motion& motion, const std::string& problem) {
  constexpr std::string_view kName = "particles";
  const auto& key = *std::ranges::find(simulationKeys(), kName, &Key<SimulationSettings>::name);
  const std::string name = "simulation." + std::string(kName);
  document::failAt(motion.locations.of({name}),
                   name + " = " + key.text(motion.simulation) + " " + problem);
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
  if (const int pieces = physics::countPieces(system); pieces > 1)
    return "they are in " + std::to_string(pieces) + " pieces";
  return "more than six motions leave the springs as they are";
}

/// Returns a grid whose springs hold the body, as a scene states it; empty if there is none.
std::string gridThatHolds(const Motion& motion) {
  constexpr int kFirst = 4, kLast = 200;
  for (int cells = kFirst; cells <= kLast; cells += (cells + 3) / 4) {
    try {
      if (physics::holdShape(particlesOnGrid(motion, cells)))
        return "\"grid:" + std::to_string(cells) + "\"";
    } catch (const InputError&) {
      return "";  // finer ones have even more
    }
  }
  return "";
}

std::string remedyFor(Arrangement arrangement, const Motion& motion) {
  if (arrangement == Arrangement::Equimomental)
    return "a plane body has its equimomental particles in its plane";
  const std::string grid = gridThatHolds(motion);
  return "take " + (grid.empty() ? "" : grid + " or ") + "\"equimomental\"";
}

void requireShape(const MassSpringSystem& system, const Motion& motion) {
  if (physics::holdShape(system)) return;
  const std::string reason = system.places.empty()
                                 ? "has no point inside the body"
                                 : "makes " + countText(std::ssize(system.places), "particle") +
                                       " and " + countText(std::ssize(system.springs), "spring") +
                                       ", which don't hold the shape: " + looseness(system);
  failAtParticles(motion,
                  reason + "; " + remedyFor(motion.simulation.particles.arrangement, motion));
}

void requireStableStep(const Motion& motion, const MassSpringSystem& system) {
  const SimulationSettings& simulation = motion.simulation;
  const double step = simulation.steps().length();
  const double longest = physics::largestStableStep(motion, system);
  if (step <= longest) return;
  const std::string integrator(nameOf(kIntegrators, simulation.integrator));
  const std::string place = motion.locations.of(
      {simulation.step ? "simulation.step" : "simulation.substeps", "simulation.particles"});
  if (longest == 0) {
    document::failAt(place, "no step is stable with the integrator \"" + integrator +
                                "\" and these particles; take \"verlet\", or simulation.damping");
  }
  const auto milliseconds = [](double seconds) { return roundedText(1e3 * seconds, 3) + " ms"; };
  document::failAt(place, "steps of " + milliseconds(step) +
                              " are too long for these particles: the longest "
                              "that is stable with \"" +
                              integrator + "\" is " + milliseconds(longest) + "; take " +
                              shorterSteps(simulation, longest) + "softer springs");
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
                "simulation.particles = \"equimomental\", \"vertices\" or \"grid:N\", or choose "
                "another model");
  }
  const auto inertia = section.find("inertia");
  if (!inertia || arrangement == Arrangement::Equimomental) return;
  inertia->fail(inertia->name() +
                " is for rigid models, but the model is \"particles\", whose inertia follows from "
                "their positions; leave it out, or set simulation.particles = \"equimomental\"");
}

void placeParticles(Motion& motion) {
  motion.particles = {};
  const Arrangement arrangement = motion.simulation.particles.arrangement;
  const bool areCorners = arrangement == Arrangement::Corners;
  if (motion.simulation.model != physics::Model::Particles || areCorners) return;
  if (lacksSurface(motion)) return;
  MassSpringSystem system;
  try {
    system = systemOf(motion);
  } catch (const InputError& error) {
    failAtParticles(motion, error.what());
  }
  requireShape(system, motion);
  requireStableStep(motion, system);
  if (!physics::areEight(arrangement))
    motion.particles = physics::placed(std::move(system), motion.body.mass);
}

void placeInMesh(Motion& motion, const ReadNamedFile& readNamedFile) {
  MeshFile& mesh = motion.solid.mesh;
  takeMeshFile(readNamedFile(mesh.name, kLongestMesh), mesh);
  motion.particles = physics::placed(systemOf(motion), motion.body.mass);
  if (motion.initial.about) turnSpinToAxis(motion);
}

}  // namespace rotatebook::scene
