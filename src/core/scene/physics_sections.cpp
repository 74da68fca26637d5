// The sections [body], [simulation], [initial], [[nudge]] and [expect]: what moves, and what it
// must show.
#include <algorithm>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "base/document/problems.h"
#include "base/nearest_name.h"
#include "scene/body_section.h"
#include "scene/keys/expectation_keys.h"
#include "scene/keys/keys.h"
#include "scene/names.h"
#include "scene/placed_particles.h"
#include "scene/sections.h"

namespace rotatebook::scene {
namespace {

bool isTimePerFrame(const Key<physics::SimulationSettings>& key) {
  return key.name == "time_per_frame";
}

void finishSimulation(const ValueReader& section, physics::SimulationSettings& settings) {
  const auto step = section.find("step");
  if (step && section.find("substeps")) {
    step->fail("both simulation.step and simulation.substeps say how long a step is; keep one");
  }
  if (!section.find("integrator")) settings.integrator = defaultIntegrator(settings.model);
}

/// Refuses an integrator that no model has, and lists those of `model`.
void checkIntegratorName(const ValueReader& section, physics::Model model) {
  const auto value = section.find("integrator");
  const auto* name = value ? std::get_if<std::string>(&value->node().value) : nullptr;
  if (name == nullptr || std::ranges::count(namesOf(kIntegrators), *name) > 0) return;
  const auto names = integratorNames(model);
  const auto all = namesOf(kIntegrators);
  value->choice(names.empty() ? std::span<const std::string_view>(all) : names);
}

/// Returns the lines of all keys but time_per_frame, which panels share.
std::string simulationLines(const Motion& motion, const Printed& printed) {
  std::string lines;
  for (const auto& key : simulationKeys()) {
    if (!isTimePerFrame(key)) lines += lineOf(key, motion.simulation, printed);
  }
  return lines;
}

/// Returns the lines of the start; none for a recording, which has its own.
std::string initialLines(const Motion& motion, const Printed& printed) {
  if (motion.simulation.model == physics::Model::Recorded) return "";
  return linesOf(initialKeys(), motion.initial, printed);
}

/// Returns whether the section states a spin. Throws InputError if it states two.
bool hasSpin(const ValueReader& section, const std::string& name) {
  const bool hasVelocity = section.find("angular_velocity").has_value();
  const bool hasMomentum = section.find("angular_momentum").has_value();
  if (hasVelocity && hasMomentum) {
    section.fail(name + " has both angular_velocity and angular_momentum; keep one of them");
  }
  return hasVelocity || hasMomentum;
}

void checkSpin(const ValueReader& section, physics::InitialSpin& spin) {
  const bool isStated = hasSpin(section, "[initial]");
  const auto tilt = section.find("tilt");
  if (tilt && isStated && !spin.about) failAtValue(*tilt, [&] { spin.tilted(); });
}

physics::Nudge nudgeFrom(const ValueReader& table) {
  physics::Nudge nudge;
  readKeys(table, nudgeKeys(), nudge);
  if (!table.find("at")) table.fail("[[nudge]] needs at, its time in s");
  if (!hasSpin(table, "[[nudge]]")) {
    table.fail("[[nudge]] needs angular_velocity or angular_momentum, what it adds to the spin");
  }
  return nudge;
}

void readNudges(const ValueReader& value, Motion& motion) {
  const auto tables = value.tables("tables with the header [[nudge]]");
  if (tables.size() > kMaxNudges) {
    value.fail("a motion has up to " + std::to_string(kMaxNudges) + " nudges, not " +
               std::to_string(tables.size()));
  }
  motion.nudges.clear();
  document::Problems problems;
  for (const ValueReader& table : tables) {
    problems.note([&] { motion.nudges.push_back(nudgeFrom(table)); });
  }
  problems.throwIfAny();
  std::ranges::stable_sort(motion.nudges, {}, &physics::Nudge::at);
}

std::vector<std::string> nudgeTables(const Motion& motion, const Printed& printed) {
  std::vector<std::string> tables;
  for (const physics::Nudge& nudge : motion.nudges) {
    tables.push_back(linesOf(nudgeKeys(), nudge, printed));
  }
  return tables;
}

/// Returns the lines of the quantities, in the order in which they are first expected.
std::string expectLines(const Motion& motion, const Printed& printed) {
  const auto& expectations = motion.expectations;
  std::string lines;
  for (auto one = expectations.begin(); one != expectations.end(); ++one) {
    const auto isSame = [one](const auto& other) { return other.measure == one->measure; };
    if (std::any_of(expectations.begin(), one, isSame)) continue;
    lines += lineOf(expectKeys()[static_cast<std::size_t>(one->measure)], expectations, printed);
  }
  return lines;
}

}  // namespace

std::span<const Section<Motion>> motionSections() {
  static const std::vector<Section<Motion>> sections = [] {
    const auto simulation =
        section<Motion>("simulation", &Motion::simulation, simulationKeys(), finishSimulation);
    const auto initial = section<Motion>("initial", &Motion::initial, initialKeys(), checkSpin);
    const auto expect = section<Motion>("expect", &Motion::expectations, expectKeys());
    const auto readSimulation = [read = simulation.read](const ValueReader& value, Motion& motion) {
      document::Problems problems;
      problems.note([&] { read(value, motion); });
      problems.note([&] { checkIntegratorName(value, motion.simulation.model); });
      problems.throwIfAny();
    };
    return std::vector<Section<Motion>>{
        bodySection(),
        {simulation.name, readSimulation, simulationLines, simulation.rows},
        {initial.name, initial.read, initialLines, initial.rows},
        {"nudge", readNudges, {}, rowsOf("nudge.N.", nudgeKeys()), nudgeTables},
        {expect.name, expect.read, expectLines, expect.rows},
    };
  }();
  return sections;
}

std::string timePerFrameLine(const physics::SimulationSettings& settings, const Printed& printed) {
  return lineOf(*std::ranges::find_if(simulationKeys(), isTimePerFrame), settings, printed);
}

void requireSpin(const ValueReader& section) {
  for (const auto& kind : kSpinKinds) {
    if (section.find(kind.name)) return;
  }
  section.fail("[initial] needs angular_velocity or angular_momentum");
}

void checkIntegrator(const ValueReader& section, const physics::SimulationSettings& settings) {
  const auto integrator = section.find("integrator");
  if (!integrator || physics::isFor(settings.model, settings.integrator)) return;
  const std::string chosen =
      integrator->name() + " = " + tomlString(nameOf(kIntegrators, settings.integrator));
  const std::string model = tomlString(nameOf(kModels, settings.model));
  if (!physics::takesSteps(settings.model)) {
    integrator->fail(chosen + ", but the model " + model + " takes no steps; leave it out");
  }
  integrator->fail(chosen + ", but the model " + model + " has " +
                   quotedList(integratorNames(settings.model), "and"));
}

void checkDissipation(const ValueReader& section, const physics::SimulationSettings& settings) {
  const physics::Model model = settings.model;
  const physics::Integrator integrator = settings.integrator;
  const auto dissipation = section.find("dissipation");
  if (!dissipation || settings.dissipation == 0 || takesDissipation(model, integrator)) return;
  const std::string chosen =
      dissipation->name() + " = " + tomlNumber(settings.dissipation) + ", but the ";
  std::vector<std::string_view> names;
  for (const std::string_view name : integratorNames(model)) {
    const auto one = std::ranges::find(kIntegrators, name, &Named<physics::Integrator>::name);
    if (takesDissipation(model, one->value)) names.push_back(name);
  }
  if (names.empty()) {
    dissipation->fail(chosen + "model " + tomlString(nameOf(kModels, model)) +
                      " takes none; leave it 0, or choose \"matrix\" or \"quaternion\"");
  }
  dissipation->fail(chosen + "integrator " + tomlString(nameOf(kIntegrators, integrator)) +
                    " takes none; choose " + quotedList(names, "or"));
}

void checkRecorded(const ValueReader& motion, const ValueReader& own,
                   const physics::SimulationSettings& settings) {
  if (settings.recorded.file.empty()) {
    motion.find("simulation", "model")
        ->fail("the model \"recorded\" needs simulation.file, a table of the motion (CSV)");
  }
  if (const auto initial = own.find("initial")) {
    initial->fail("[initial]: a recorded motion starts as its recording does; leave it out");
  }
}

void checkMotion(const ValueReader& file, const physics::SimulationSettings& settings) {
  const auto initial = file.find("initial");
  if (settings.model == physics::Model::Recorded) {
    checkRecorded(file, file, settings);
  } else {
    if (!initial) file.fail("[initial] is missing; it needs angular_velocity or angular_momentum");
    requireSpin(*initial);
  }
  if (const auto body = file.find("body")) checkParticlesBody(*body, settings);
  if (const auto simulation = file.find("simulation")) {
    checkIntegrator(*simulation, settings);
    checkDissipation(*simulation, settings);
  }
}

}  // namespace rotatebook::scene
