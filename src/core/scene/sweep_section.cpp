// Reads a sweep, a study over any key: its keys, and the motion of each run.
#include <algorithm>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include "base/nearest_name.h"
#include "document/problems.h"
#include "scene/keys/keys.h"
#include "scene/names.h"
#include "scene/sections.h"
#include "scene/varied_motion.h"

namespace rotatebook::scene {
namespace {

using document::TomlNode;

void addCurve(const TomlNode& sections, const VariedKey& over, const std::string& curve,
              Scene& scene) {
  const std::string path = over.key.text(kLongestPath);
  const VariedMotions motions(sections, scene.simulation, over, path);
  document::Problems problems;
  for (const StatedValue& value : over.values) {
    problems.note([&] {
      physics::MotionSettings motion = motions.with(value);
      sampleAsAsked(*scene.study, motion);
      scene.study->sweep->runs.push_back({value.value.label, curve, std::move(motion)});
    });
  }
  problems.throwIfAny();
}

void refuseManyRuns(const ValueReader& section, const Sweep& sweep) {
  const std::size_t curves = sweep.curves ? sweep.curves->values.size() : 1;
  const std::size_t runs = sweep.over.values.size() * curves;
  if (runs <= kMaxRuns) return;
  section.fail("[study] has " + std::to_string(runs) + " runs; the limit is " +
               std::to_string(kMaxRuns));
}

void makeRuns(const ValueReader& section, const ValueReader& file, Scene& scene) {
  refuseManyRuns(section, *scene.study->sweep);
  const VariedKey over = variedKeyFrom(section);
  const TomlNode sections = motionPart(file);
  const auto curves = section.find("curves");
  if (!curves) return addCurve(sections, over, "", scene);
  const VariedKey second = variedKeyFrom(*curves);
  if (second.key.text(kLongestPath) == over.key.text(kLongestPath)) {
    second.key.fail(second.key.name() + " is study.over, too; name another key");
  }
  document::Problems problems;
  for (const StatedValue& value : second.values) {
    problems.note([&] {
      TomlNode varied = sections;
      put(varied, second.key.text(kLongestPath), second, value);
      addCurve(varied, over, value.value.label, scene);
    });
  }
  problems.throwIfAny();
}

/// Throws InputError if the study varies what none of its models has.
void refuseUnusedKeys(const ValueReader& section, const Sweep& sweep) {
  std::vector<physics::Model> models;
  for (const SweepRun& run : sweep.runs) models.push_back(run.motion.simulation.model);
  refuseUnused(*section.find("over"), sweep.over.key, models, "runs");
  if (sweep.curves)
    refuseUnused(*section.find("curves", "over"), sweep.curves->key, models, "runs");
}

/// Throws InputError if a study with an interval of its own varies the one that it replaces.
void refuseIntervals(const ValueReader& section, const Sweep& sweep) {
  constexpr std::string_view kInterval = "simulation.time_per_frame";
  const auto interval = section.find("interval");
  if (!interval) return;
  if (sweep.over.key != kInterval && !(sweep.curves && sweep.curves->key == kInterval)) return;
  interval->fail(
      "study.interval replaces simulation.time_per_frame, which the study varies; "
      "remove one of them");
}

void requireLabel(const ValueReader& value, const std::string& label,
                  const std::vector<SweepValue>& values) {
  std::vector<std::string_view> labels;
  for (const SweepValue& one : values) labels.push_back(one.label);
  if (std::ranges::count(labels, label) > 0) return;
  const bool isWord = std::holds_alternative<std::string>(value.node().value);
  value.fail(value.name() + " = " + label + " is no value of the study" +
             (isWord ? didYouMean(label, labels) : ""));
}

/// Throws InputError if something is expected that isn't measured, or of runs that aren't made.
void checkExpected(const ValueReader& tables, const Sweep& sweep) {
  std::size_t i = 0;
  for (const ValueReader& table : tables.tables("")) {
    const SweepExpectation& one = sweep.expected[i++];
    if (std::ranges::count(sweep.measures, one.measure) == 0) {
      table.find("measure")->fail(std::string(nameOf(one.measure)) + " isn't in study.measure");
    }
    if (one.at) requireLabel(*table.find("at"), *one.at, sweep.over.values);
    if (!one.curve) continue;
    const ValueReader curve = *table.find("curve");
    if (!sweep.curves) curve.fail(curve.name() + " needs study.curves");
    requireLabel(curve, *one.curve, sweep.curves->values);
  }
}

void refuseOthers(const ValueReader& section) {
  for (const Key<Scene>& key : studyKeys()) {
    const auto value = section.find(key.name);
    if (!value) continue;
    value->fail("[study] has both over and " + std::string(key.name) +
                "; it varies either that key, or integrators and steps, or tilts");
  }
}

}  // namespace

void readSweep(const ValueReader& section, const ValueReader& file, Scene& scene) {
  refuseOthers(section);
  Sweep& sweep = scene.study.emplace().sweep.emplace();
  Keys<Scene> keys = samplingKeys();
  std::ranges::copy(sweepKeys(), std::back_inserter(keys));
  readKeys(section, keys, scene);
  for (const char* key : {"values", "measure"}) {
    if (!section.find(key)) section.fail("[study] has over, so it needs " + std::string(key));
  }
  refuseIntervals(section, sweep);
  makeRuns(section, file, scene);
  refuseUnusedKeys(section, sweep);
  if (!sweep.expected.empty()) checkExpected(*section.find("expect"), sweep);
}

}  // namespace rotatebook::scene
