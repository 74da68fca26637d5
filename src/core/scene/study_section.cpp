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

/// Adds the motions of a curve to `runs`.
void addCurve(const VariedMotions& motions, const VariedKey& x, const std::string& curve,
              const StudySettings& study, std::vector<StudyRun>& runs) {
  document::Problems problems;
  for (const StatedValue& value : x.values) {
    problems.note([&] {
      physics::MotionSettings motion = motions.with(value);
      sampleAsAsked(study, motion);
      runs.push_back({value.value.label, curve, std::move(motion)});
    });
  }
  problems.throwIfAny();
}

void refuseManyRuns(const ValueReader& section, const StudySettings& study) {
  const std::size_t curves = study.curves ? study.curves->values.size() : 1;
  const std::size_t runs = study.x.values.size() * curves;
  if (runs <= kMaxRuns) return;
  section.fail("[study] has " + std::to_string(runs) + " runs; the limit is " +
               std::to_string(kMaxRuns));
}

std::vector<StudyRun> makeRuns(const ValueReader& section, const ValueReader& file,
                               const Scene& scene, Shared& shared) {
  std::vector<StudyRun> runs;
  const VariedKey x = variedKeyFrom(*section.find("x"), file);
  const TomlNode sections = motionPart(file);
  const auto curves = section.find("curves");
  if (!curves) {
    addCurve({sections, shared, x, &scene.motions.front()}, x, "", *scene.study, runs);
    return runs;
  }
  const VariedKey second = variedKeyFrom(*curves, file);
  if (second.path == x.path) {
    second.key.fail(second.key.name() + " is study.x.key, too; name another key");
  }
  document::Problems problems;
  for (const StatedValue& value : second.values) {
    problems.note([&] {
      TomlNode varied = sections;
      put(varied, second, value);
      addCurve({varied, shared, x}, x, value.value.label, *scene.study, runs);
    });
  }
  problems.throwIfAny();
  return runs;
}

/// Throws InputError if the study varies what none of its models has.
void refuseUnusedKeys(const ValueReader& section, const StudySettings& study,
                      const std::vector<StudyRun>& runs) {
  std::vector<physics::Model> models;
  for (const StudyRun& run : runs) models.push_back(run.motion.simulation.model);
  refuseUnused(*section.find("x", "key"), study.x.key, models, "runs");
  if (study.curves) refuseUnused(*section.find("curves", "key"), study.curves->key, models, "runs");
}

/// Throws InputError if a study with an interval of its own varies the one that it replaces.
void refuseIntervals(const ValueReader& section, const StudySettings& study) {
  constexpr std::string_view kInterval = "simulation.time_per_frame";
  const auto interval = section.find("interval");
  if (!interval) return;
  if (study.x.key != kInterval && !(study.curves && study.curves->key == kInterval)) return;
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
void checkOrders(const ValueReader& section, const StudySettings& study,
                 const std::vector<StudyRun>& runs) {
  if (std::ranges::count(study.measures, Measure::Order) == 0) return;
  std::set<std::pair<std::string, double>> steps;
  for (const StudyRun& run : runs) {
    const physics::SimulationSettings& simulation = run.motion.simulation;
    const std::string reason = reasonForAbsence(Measure::Order, simulation.model);
    if (!reason.empty()) section.find("measure")->fail("study.measure has order: " + reason);
    if (!steps.emplace(run.curve, simulation.steps().length()).second) {
      section.find("x")->fail(
          "order, which is measured unless study.measure says otherwise, is found from different "
          "steps, but study.x gives two runs the same; vary simulation.substeps or "
          "simulation.step, or state another measure");
    }
  }
}

/// Throws InputError if the study takes too many samples of a motion, or too few.
void checkSamples(const ValueReader& section, const Scene& scene,
                  const std::vector<StudyRun>& runs) {
  for (const StudyRun& run : runs) {
    const std::int64_t samples = studiedSamples(scene, *scene.study, run.motion);
    if (samples < 2) {
      section.fail(
          "[study] takes a single sample of a motion, which shows none; raise study.duration or "
          "clip.duration");
    }
    if (samples <= kMaxFrames) continue;
    section.find(scene.study->duration ? "duration" : "interval")
        ->fail("the study takes " + std::to_string(samples) +
               " samples of a motion; the limit is " + std::to_string(kMaxFrames) +
               ": lower study.duration, or raise study.interval");
  }
}

}  // namespace

StudySettings readStudy(const ValueReader& stated, const Spec& spec) {
  if (!spec.panels.empty() || spec.grid) {
    stated.fail("[study] needs a single motion, but this scene has several, panels or a grid");
  }
  const TomlNode whole = completed(stated, spec.motion.simulation.model);
  const ValueReader section(whole, stated.name());
  StudySettings study;
  readKeys(section, studyKeys(), study);
  refuseIntervals(section, study);
  refuseManyRuns(section, study);
  checkExpected(section, study);
  return study;
}

std::vector<StudyRun> runsOf(const Scene& scene, const ValueReader& file, Shared& shared) {
  const ValueReader stated = *file.find("study");
  const TomlNode whole = completed(stated, scene.motion.simulation.model);
  const ValueReader section(whole, stated.name());
  std::vector<StudyRun> runs = makeRuns(section, file, scene, shared);
  refuseUnusedKeys(section, *scene.study, runs);
  checkOrders(section, *scene.study, runs);
  checkSamples(section, scene, runs);
  return runs;
}

std::string studyText(const Spec& spec) {
  if (!spec.study) return "";
  return "\n[study]\n" + linesOf(studyKeys(), *spec.study);
}

}  // namespace rotatebook::scene
