// Reads and prints [study]: its keys, and the motion of each run.
#include <algorithm>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "base/document/problems.h"
#include "base/text.h"
#include "scene/keys/expectation_keys.h"
#include "scene/keys/keys.h"
#include "scene/names.h"
#include "scene/sections.h"
#include "scene/varied_motion.h"

namespace rotatebook::scene {
namespace {

using document::TomlNode;

constexpr const char* kDefaultX =
    "{ key = \"simulation.substeps\", values = [1, 2, 4, 8, 16, 32, 64, 128, 256, 512, 1024] }";
constexpr const char* kDefaultMeasure = "[\"order\"]";

/// Returns the location of a key of [study], or else of the section.
std::string placeOf(const Spec& spec, const std::string& key) {
  return spec.locations.of({"study." + key, "study"});
}

std::string curvesOfAllIntegrators(physics::Model model) {
  std::vector<std::string> names;
  for (const std::string_view name : integratorNames(model)) names.push_back(tomlString(name));
  return "{ key = \"simulation.integrator\", values = [" + joined(names) + "] }";
}

/// Returns [study] with what it leaves out: without a measure, the orders of all integrators.
TomlNode completed(const ValueReader& section, physics::Model model) {
  TomlNode whole = section.node();
  auto* table = std::get_if<TomlNode::Table>(&whole.value);
  if (table == nullptr) section.mismatch("a table");
  const auto state = [&](const char* key, const std::string& value) {
    const std::string& location = whole.location;
    if (section.find(key)) return;
    table->push_back({key, location, *document::parseTomlValue(value, location)});
  };
  const bool statesMeasure = section.find("measure").has_value();
  if (!statesMeasure && !physics::takesSteps(model)) {
    section.fail("the model " + tomlString(nameOf(kModels, model)) +
                 " takes no steps, whose order [study] finds without a measure; state x and "
                 "measure, or choose another model");
  }
  state("x", kDefaultX);
  if (!statesMeasure) state("curves", curvesOfAllIntegrators(model));
  state("measure", kDefaultMeasure);
  return whole;
}

void refuseManyRuns(const ValueReader& section, const StudySettings& study) {
  const std::size_t curves = study.curves ? study.curves->values.size() : 1;
  const std::size_t runs = study.x.values.size() * curves;
  if (runs <= kMaxRuns) return;
  section.fail("[study] has " + std::to_string(runs) + " runs; the limit is " +
               std::to_string(kMaxRuns));
}

/// Completes the axes. Throws InputError if they are of the same key.
void finishAxes(const ValueReader& section, const ValueReader& file, StudySettings& study) {
  finishAxis(*section.find("x"), file, study.x);
  if (!study.curves) return;
  finishAxis(*section.find("curves"), file, *study.curves);
  if (variedKey(*study.curves) == variedKey(study.x))
    section.find("curves", "key")->fail("study.curves.key is study.x.key, too; name another key");
}

/// Throws InputError if the study varies what none of its models has.
void refuseUnusedKeys(const Scene& scene) {
  std::vector<physics::Model> models;
  for (const StudyRun& run : scene.runs) models.push_back(run.motion.simulation.model);
  const StudySettings& study = *scene.study;
  refuseUnused(placeOf(scene, "x.key"), study.x.key, models, "runs");
  if (study.curves) refuseUnused(placeOf(scene, "curves.key"), study.curves->key, models, "runs");
}

/// Throws InputError if a study with an interval of its own varies the one that it replaces.
void refuseIntervals(const ValueReader& section, const StudySettings& study) {
  const auto interval = section.find("interval");
  if (!interval || !study.varies("simulation.time_per_frame")) return;
  interval->fail(
      "study.interval replaces simulation.time_per_frame, which the study varies; "
      "remove one of them");
}

/// Throws InputError if something is expected that isn't measured, or of an x that isn't of one.
void checkExpected(const ValueReader& section, const StudySettings& study) {
  kStudyExpectations.check(section, {&study.x, study.curves ? &*study.curves : nullptr});
  for (std::size_t i = 0; i < study.expected.size(); ++i) {
    const Measure measure = study.expected[i].measure;
    const ValueReader table = section.find("expect")->tables("")[i];
    if (std::ranges::count(study.measures, measure) == 0) {
      table.find("of")->fail(std::string(nameOf(measure)) + " isn't in study.measure");
    }
    const auto x = table.find("x");
    if (measure == Measure::Order && x) x->fail("order is of a whole curve; leave x out");
  }
}

/// Throws InputError if an order can't be found: without steps, or with the same ones twice.
void checkOrders(const Scene& scene) {
  if (std::ranges::count(scene.study->measures, Measure::Order) == 0) return;
  std::set<std::pair<std::string, double>> steps;
  for (const StudyRun& run : scene.runs) {
    const physics::SimulationSettings& simulation = run.motion.simulation;
    const std::string reason = reasonForAbsence(Measure::Order, simulation.model);
    if (!reason.empty())
      document::failAt(placeOf(scene, "measure"), "study.measure has order: " + reason);
    if (!steps.emplace(run.curve, simulation.steps().length()).second) {
      document::failAt(
          placeOf(scene, "x"),
          "order, which is measured unless study.measure says otherwise, is found from different "
          "steps, but study.x gives two runs the same; vary simulation.substeps or "
          "simulation.step, or state another measure");
    }
  }
}

/// Throws InputError if the study takes too many samples of a motion, or too few.
void checkSamples(const Scene& scene) {
  for (const StudyRun& run : scene.runs) {
    const std::int64_t samples = studiedSamples(scene, *scene.study, run.motion);
    if (samples < 2) {
      document::failAt(
          placeOf(scene, ""),
          "[study] takes a single sample of a motion, which shows none; raise study.duration or "
          "clip.duration");
    }
    if (samples <= kMaxFrames) continue;
    document::failAt(placeOf(scene, scene.study->duration ? "duration" : "interval"),
                     "the study takes " + std::to_string(samples) +
                         " samples of a motion; the limit is " + std::to_string(kMaxFrames) +
                         ": lower study.duration, or raise study.interval");
  }
}

}  // namespace

StudySettings readStudy(const ValueReader& stated, const ValueReader& file, const Spec& spec) {
  if (spec.hasPanels() || spec.grid) {
    stated.fail("[study] needs a single motion, but this scene has several, panels or a grid");
  }
  const TomlNode whole = completed(stated, spec.motion.simulation.model);
  const ValueReader section(whole, stated.name());
  StudySettings study;
  readKeys(section, studyKeys(), study);
  refuseIntervals(section, study);
  refuseManyRuns(section, study);
  checkExpected(section, study);
  finishAxes(section, file, study);
  return study;
}

std::vector<StudyRun> readRuns(const ValueReader& file, const Spec& spec) {
  const Axis& x = spec.study->x;
  const Axis* curves = spec.study->curves ? &*spec.study->curves : nullptr;
  std::vector<StudyRun> runs;
  readVaried(
      file, {curves, placeOf(spec, "curves.key")}, {&x, placeOf(spec, "x.key")},
      [&](std::size_t curve, std::size_t value, Motion motion) {
        runs.push_back({x.values[value].label, curves != nullptr ? curves->values[curve].label : "",
                        std::move(motion)});
      });
  return runs;
}

void checkRuns(const Scene& scene) {
  refuseUnusedKeys(scene);
  checkOrders(scene);
  checkSamples(scene);
}

std::string studyText(const Spec& spec, const Printed& printed) {
  return spec.study ? "\n[study]\n" + linesOf(studyKeys(), *spec.study, printed) : "";
}

}  // namespace rotatebook::scene
