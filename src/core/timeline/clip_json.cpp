#include "timeline/clip_json.h"

#include <cmath>
#include <cstdint>
#include <set>

#include "base/json.h"
#include "base/number_text.h"
#include "base/text.h"
#include "scene/names.h"
#include "timeline/clip_events.h"
#include "timeline/notes.h"

namespace rotatebook::timeline {
namespace {

using physics::Sample;

// More wouldn't show in a plot of any size.
constexpr int kPlotDigits = 6;

std::string numberOrNull(double number) {
  return std::isfinite(number) ? roundedText(number, kPlotDigits) : "null";
}

/// Returns an array of one number for each sample, without spaces, as there are thousands.
template <typename Value>
std::string numbers(const physics::Trajectory& trajectory, const Value& value) {
  std::vector<std::string> texts;
  for (const Sample& sample : trajectory.samples) texts.push_back(numberOrNull(value(sample)));
  return "[" + joined(texts, ",") + "]";
}

std::string timesOf(const scene::Scene& scene, std::int64_t frames) {
  std::vector<std::string> texts;
  for (std::int64_t frame = 0; frame < frames; ++frame)
    texts.push_back(numberOrNull(timeAt(scene, static_cast<double>(frame))));
  return "[" + joined(texts, ",") + "]";
}

std::string curvesJson(const scene::Panel& panel, const physics::Trajectory& trajectory) {
  const double start = trajectory.samples.front().total();
  const auto ratio = [&](double (*energy)(const Sample&)) {
    return numbers(trajectory, [=](const Sample& sample) { return energy(sample) / start; });
  };
  return JsonObject()
      .addString("label", panel.label)
      .addBool("springs", panel.simulation.model == physics::Model::Particles)
      .add("kinetic", ratio([](const Sample& sample) { return sample.kinetic; }))
      .add("potential", ratio([](const Sample& sample) { return sample.potential; }))
      .add("total", ratio([](const Sample& sample) { return sample.total(); }))
      .add("tilt", numbers(trajectory, [](const Sample& sample) { return sample.tiltDeg; }))
      .add("error", numbers(trajectory, [](const Sample& sample) { return sample.errorDeg; }))
      .text();
}

/// Returns the motions that are plotted: a whole grid would have hundreds.
std::set<std::size_t> plottedIn(const scene::Scene& scene, std::size_t motions) {
  std::set<std::size_t> plotted;
  const std::size_t last = motions - 1;
  if (scene.grid) {
    const std::size_t columns = scene.grid->columnCount();
    return {0, columns - 1, last + 1 - columns, last};
  }
  for (std::size_t i = 0; i < motions; ++i) plotted.insert(i);
  return plotted;
}

std::string plotsJson(const scene::Scene& scene, const ClipMotion& motion) {
  const std::vector<scene::Panel>& panels = scene.motions;
  JsonObject plots;
  plots.addNumber("interval", motion.trajectories().front().interval);
  if (!hasEvenTimes(scene)) plots.add("times", timesOf(scene, motion.frameCount()));
  return plots
      .add("motions", jsonArrayOf(plottedIn(scene, panels.size()),
                                  [&](std::size_t i) {
                                    return curvesJson(panels[i], motion.trajectories()[i]);
                                  }))
      .text();
}

std::string eventJson(const ClipEvent& event) {
  return JsonObject()
      .addInteger("frame", event.frame)
      .addNumber("time_s", event.time)
      .addStringOrNull("label", event.label)
      .addString("words", event.words)
      .text();
}

std::string energyJson(const MotionSummary& summary) {
  return JsonObject()
      .addNumber("lowest", summary.lowestEnergy)
      .addNumber("highest", summary.highestEnergy)
      .text();
}

}  // namespace

std::string expectationJson(const scene::ExpectationResult& result) {
  const scene::Expectation& expectation = result.expectation;
  return JsonObject()
      .addString("quantity", nameOf(expectation.measure))
      .addNumber("from_s", expectation.from)
      .addNumber("to_s", expectation.to)
      .addNumberOrNull("min", expectation.min)
      .addNumberOrNull("max", expectation.max)
      .addNumberOrNull("rises_to", expectation.risesTo)
      .addNumberOrNull("falls_to", expectation.fallsTo)
      .addNumber("lowest", result.lowest)
      .addNumber("highest", result.highest)
      .addBool("met", result.met)
      .addNumberOrNull("ends_early_s", result.endsEarly)
      .text();
}

std::string motionJson(const MotionSummary& summary) {
  const auto& simulation = summary.motion.simulation;
  std::vector<std::string> notes = notesOn(summary.motion);
  notes.insert(notes.end(), summary.notes.begin(), summary.notes.end());
  return JsonObject()
      .addStringOrNull("label", summary.motion.label)
      .addString("model", nameOf(scene::kModels, simulation.model))
      .addStringOrNull("integrator", physics::takesSteps(simulation.model)
                                         ? nameOf(scene::kIntegrators, simulation.integrator)
                                         : std::string_view())
      .addInteger("half_turns", static_cast<std::int64_t>(summary.flips.size()))
      .add("flips_s", jsonArrayOf(summary.flips, shortestText))
      .add("energy_ratio", energyJson(summary))
      .addNumberOrNull("error_deg", summary.errorDeg)
      .addNumberOrNull("visible_from_s", summary.visibleFrom)
      .addNumberOrNull("diverged_at_s", summary.divergedAt)
      .addBool("diverges_unexpectedly", summary.divergesUnexpectedly)
      .addBool("judged", summary.isJudged)
      .addBool("met", summary.met())
      .add("expectations", jsonArrayOf(summary.expectations, expectationJson))
      .add("notes", jsonArrayOf(notes, jsonString))
      .text();
}

std::string clipJson(const scene::Scene& scene, const ClipMotion& motion,
                     const std::vector<MotionSummary>& summaries, const ClipChecksums& checksums) {
  const FrameRate rate = scene.clip.frameRate;
  return resultOf("clip")
      .addString("name", scene.name)
      .addString("title", scene.title)
      .addString("scene_xxh128", checksums.scene)
      .addString("motion_xxh128", checksums.motion)
      .add("rate", jsonArray({std::to_string(rate.numerator), std::to_string(rate.denominator)}))
      .addInteger("frames", motion.frameCount())
      .add("motions", jsonArrayOf(summaries, motionJson))
      .add("events", jsonArrayOf(eventsOf(scene, motion), eventJson))
      .add("plots", plotsJson(scene, motion))
      .text();
}

}  // namespace rotatebook::timeline
