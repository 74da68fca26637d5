// Reads a sweep, a study of any key: its keys, and the motion of each run.
#include <algorithm>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include "document/problems.h"
#include "scene/keys/expectation_keys.h"
#include "scene/keys/keys.h"
#include "scene/names.h"
#include "scene/sections.h"
#include "scene/varied_motion.h"

namespace rotatebook::scene {
namespace {

using document::TomlNode;

void addCurve(const TomlNode& sections, const VariedKey& x, const std::string& curve,
              Scene& scene) {
  const VariedMotions motions(sections, scene.simulation, x);
  document::Problems problems;
  for (const StatedValue& value : x.values) {
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
  const std::size_t runs = sweep.x.values.size() * curves;
  if (runs <= kMaxRuns) return;
  section.fail("[study] has " + std::to_string(runs) + " runs; the limit is " +
               std::to_string(kMaxRuns));
}

void makeRuns(const ValueReader& section, const ValueReader& file, Scene& scene) {
  refuseManyRuns(section, *scene.study->sweep);
  const VariedKey x = variedKeyFrom(*section.find("x"), file);
  const TomlNode sections = motionPart(file);
  const auto curves = section.find("curves");
  if (!curves) return addCurve(sections, x, "", scene);
  const VariedKey second = variedKeyFrom(*curves, file);
  if (second.path == x.path) {
    second.key.fail(second.key.name() + " is study.x.key, too; name another key");
  }
  document::Problems problems;
  for (const StatedValue& value : second.values) {
    problems.note([&] {
      TomlNode varied = sections;
      put(varied, second, value);
      addCurve(varied, x, value.value.label, scene);
    });
  }
  problems.throwIfAny();
}

/// Throws InputError if the study varies what none of its models has.
void refuseUnusedKeys(const ValueReader& section, const Sweep& sweep) {
  std::vector<physics::Model> models;
  for (const SweepRun& run : sweep.runs) models.push_back(run.motion.simulation.model);
  refuseUnused(*section.find("x", "key"), sweep.x.key, models, "runs");
  if (sweep.curves) refuseUnused(*section.find("curves", "key"), sweep.curves->key, models, "runs");
}

/// Throws InputError if a study with an interval of its own varies the one that it replaces.
void refuseIntervals(const ValueReader& section, const Sweep& sweep) {
  constexpr std::string_view kInterval = "simulation.time_per_frame";
  const auto interval = section.find("interval");
  if (!interval) return;
  if (sweep.x.key != kInterval && !(sweep.curves && sweep.curves->key == kInterval)) return;
  interval->fail(
      "study.interval replaces simulation.time_per_frame, which the study varies; "
      "remove one of them");
}

/// Throws InputError if something is expected that isn't measured.
void refuseUnmeasured(const ValueReader& section, const Sweep& sweep) {
  for (std::size_t i = 0; i < sweep.expected.size(); ++i) {
    const Measure measure = sweep.expected[i].measure;
    if (std::ranges::count(sweep.measures, measure) > 0) continue;
    section.find("expect")->tables("")[i].find("of")->fail(std::string(nameOf(measure)) +
                                                           " isn't in study.measure");
  }
}

void refuseOthers(const ValueReader& section) {
  for (const Key<Scene>& key : studyKeys()) {
    const auto value = section.find(key.name);
    if (!value) continue;
    value->fail("[study] has both x and " + std::string(key.name) +
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
  if (!section.find("measure")) section.fail("[study] has x, so it needs measure");
  refuseIntervals(section, sweep);
  makeRuns(section, file, scene);
  refuseUnusedKeys(section, sweep);
  refuseUnmeasured(section, sweep);
  kStudyExpectations.check(section, {&sweep.x, sweep.curves ? &*sweep.curves : nullptr});
}

}  // namespace rotatebook::scene
