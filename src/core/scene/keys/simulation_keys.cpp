// The keys of [simulation]: the model, and the steps by which it is simulated.
#include <algorithm>
#include <limits>
#include <string>
#include <string_view>
#include <variant>

#include "base/nearest_name.h"
#include "base/parsed_number.h"
#include "base/text.h"
#include "scene/keys/keys.h"
#include "scene/keys/kinds.h"
#include "scene/keys/recorded_keys.h"
#include "scene/sections.h"

namespace rotatebook::scene {
namespace {

using document::kPositive;
using document::TomlNode;
using physics::SimulationSettings;

// Squares and inverses of these are finite, too.
constexpr NumberRange kFrameTimes{"a time from 1e-100 to 1e100 s", 1e-100, 1e100, Dimension::Time};
constexpr NumberRange kSteps{"a time from 1e-9 to 1e9 s", 1e-9, 1e9, Dimension::Time};
constexpr int kMaxInterval = 1'000'000'000;
constexpr const char* kExpectedEvery = "true, false or a table such as { every = 100 }";
constexpr NumberRange kFactors{"zero or a positive number", 0, std::numeric_limits<double>::max()};

void readIntegrator(const ValueReader& value, SimulationSettings& settings) {
  if (value.text(kLongestName) == nameOf(kModels, physics::Model::Exact)) {
    value.fail(value.name() + " can't be \"exact\": the closed form is a model of its own, " +
               "simulation.model = \"exact\", for rigid bodies; particles have none");
  }
  // checkIntegratorName() refuses other names: which there are depends on the model.
  const auto named =
      std::ranges::find(kIntegrators, value.text(kLongestName), &Named<physics::Integrator>::name);
  if (named != kIntegrators.end()) settings.integrator = named->value;
}

/// Returns the value with a comment that depends on the model; empty for a model without steps.
std::string integratorText(const SimulationSettings& settings) {
  const auto names = integratorNames(settings.model);
  if (names.empty()) return "";
  return quotedName(kIntegrators, settings.integrator) + "  # " + quotedList(names, "or");
}

int everyStepFrom(const ValueReader& value) {
  if (const bool* flag = std::get_if<bool>(&value.node().value)) return *flag ? 1 : 0;
  const auto* table = std::get_if<TomlNode::Table>(&value.node().value);
  if (!table || table->empty()) value.mismatch(kExpectedEvery);
  int every = 0;
  value.readTable(
      {{"every", [&every](const ValueReader& steps) { every = steps.integer(1, kMaxInterval); }}});
  return every;
}

std::string everyStepText(int every) {
  if (every > 1) return "{ every = " + std::to_string(every) + " }";
  return every == 1 ? "true" : "false";
}

void readEvery(const ValueReader& steps, std::string_view part, const ValueForm&, int& every) {
  if (part != "every") steps.mismatch(kExpectedEvery);
  every = steps.integer(1, kMaxInterval);
}

std::vector<KeyRow> everyRows() {
  return {rowOf("every", {.meaning = "steps from one correction to the next"},
                integerForm(1, kMaxInterval), "")};
}

/// Numbers of steps from one correction to the next; 0 for none.
template <auto kMember>
constexpr auto everyStep(std::string_view name, const KeyText& documentation) {
  return key<kMember, everyStepFrom, everyStepText, readEvery>(
      name,
      {.expected = kExpectedEvery,
       .hasWholeParts = true,
       .kinds = {.flag = true, .table = true},
       .members = everyRows},
      documentation);
}

void readTimePerFrame(const ValueReader& value, SimulationSettings& settings) {
  settings.timePerFrame = value.number(kFrameTimes);
  settings.substepped.reset();
}

std::string timePerFrameText(const SimulationSettings& settings) {
  return settings.substepped ? "" : tomlNumber(settings.timePerFrame);
}

void readSubsteps(const ValueReader& value, SimulationSettings& settings) {
  settings.substeps = value.integer(1, kMaxSubsteps);
  settings.step.reset();
}

std::string substepsText(const SimulationSettings& settings) {
  return settings.step ? "" : std::to_string(settings.substeps);
}

constexpr const char* kExpectedArrangement =
    "\"corners\", \"equimomental\", \"vertices\" or \"grid:N\", with N from 2 to 200";
constexpr std::string_view kGrid = "grid:";

int cellsFrom(const ValueReader& value, std::string_view text) {
  constexpr int kMinCells = 2, kMaxCells = 200;
  const auto cells = parsedNumber<int>(text);
  if (!cells || *cells < kMinCells || *cells > kMaxCells) value.mismatch(kExpectedArrangement);
  return *cells;
}

physics::ParticleSettings arrangementFrom(const ValueReader& value) {
  const auto* text = std::get_if<std::string>(&value.node().value);
  if (text == nullptr) value.mismatch(kExpectedArrangement);
  if (text->starts_with(kGrid))
    return {physics::Arrangement::Grid,
            cellsFrom(value, std::string_view(*text).substr(kGrid.size()))};
  if (!nearestName(*text, namesOf(kArrangements))) value.mismatch(kExpectedArrangement);
  return {choiceFrom(value, kArrangements)};
}

std::string arrangementText(const physics::ParticleSettings& settings) {
  if (settings.arrangement != physics::Arrangement::Grid)
    return quotedName(kArrangements, settings.arrangement);
  return tomlString(std::string(kGrid) + std::to_string(settings.cells));
}

constexpr std::array kOwnKeys{
    choice<&SimulationSettings::model, kModels>("model", {.meaning = "see [models](motion.md)"}),
    keyOf<SimulationSettings, readIntegrator, integratorText>(
        "integrator", ownForm(kTextKind, "one of the model's integrators"),
        {.meaning = "see [integrators](motion.md#integrators)",
         .byDefault = "`\"rk4\"`; for particles `\"euler\"`",
         .models = kOfStepwise}),
    everyStep<&SimulationSettings::normalizeEvery>(
        "normalize",
        {.comment = "undo the integrator's drift after each step, or after each n-th",
         .meaning = "undo the integrator's drift, see [normalising](motion.md#normalising)",
         .models = kOfStepwise}),
    everyStep<&SimulationSettings::normalizeEnergyEvery>(
        "normalize_energy", {.meaning = "scale the velocities to the energy at the start",
                             .byDefault = "as `normalize`",
                             .models = kOfParticles}),
    everyStep<&SimulationSettings::removeDriftEvery>(
        "remove_drift", {.meaning = "bring the centre of mass to rest at the origin",
                         .byDefault = "as `normalize`",
                         .models = kOfParticles}),
    number<&SimulationSettings::damping>("damping", kFactors,
                                         {.comment = "particles: fraction of critical damping",
                                          .meaning = "of each spring, as a fraction of 2√(km)",
                                          .models = kOfParticles}),
    number<&SimulationSettings::stiffness>("stiffness", kPositive,
                                           {.comment = "particles: N/m, of each spring",
                                            .meaning = "of each spring",
                                            .unit = "N/m",
                                            .models = kOfParticles}),
    number<&SimulationSettings::dissipation>(
        "dissipation", kFactors,
        {.comment = "matrix and quaternion: kg m^2 s, of a damper inside",
         .meaning = "rate of a loss of energy, see [a sink of energy](motion.md#a-sink-of-energy)",
         .unit = "kg m² s",
         .models = kOfRigidSteps}),
    own<&SimulationSettings::particles, arrangementFrom, arrangementText>(
        "particles", kTextKind, kExpectedArrangement,
        {.comment = "particles: where they are",
         .meaning = "where they are, see [bodies](bodies.md#particles)",
         .models = kOfParticles}),
    keyOf<SimulationSettings, readTimePerFrame, timePerFrameText>(
        "time_per_frame", formOf(ValueForm::Type::Number, kFrameTimes),
        {.comment = "s simulated for each frame of video",
         .meaning = "simulated time from a frame to the next, in place of `clip.speed`",
         .byDefault = "as `clip.speed` says"}),
    keyOf<SimulationSettings, readSubsteps, substepsText>(
        "substeps", integerForm(1, kMaxSubsteps),
        {.comment = "integration steps in 1/60 s of motion, or in time_per_frame if it is stated",
         .meaning = "integration steps in 1/60 s of motion, or in `time_per_frame` if it is stated",
         .models = kOfStepwise}),
    number<&SimulationSettings::step>(
        "step", kSteps,
        {.comment = "s, length of an integration step",
         .meaning = "length of an integration step, in place of `substeps`",
         .byDefault = "as `substeps` says",
         .models = kOfStepwise}),
};

}  // namespace

Keys<SimulationSettings> simulationKeys() {
  static const auto keys = [] {
    std::vector<Key<SimulationSettings>> all(kOwnKeys.begin(), kOwnKeys.end());
    all.insert(all.end(), recordedKeys().begin(), recordedKeys().end());
    return all;
  }();
  return keys;
}

}  // namespace rotatebook::scene
