#include "timeline/clip_json.h"

#include <cstdint>
#include <set>

#include "base/json.h"
#include "base/text.h"
#include "scene/names.h"
#include "timeline/clip_events.h"
#include "timeline/notes.h"

namespace rotatebook::timeline {
namespace {

using physics::Sample;

// More wouldn't show in a plot of any size.
constexpr int kPlotDigits = 6;

/// Returns an array of one number for each sample.
template <typename Value>
Json numbers(const physics::Trajectory& trajectory, const Value& value) {
  return arrayOf(trajectory.samples,
                 [&](const Sample& sample) { return roundedJson(value(sample), kPlotDigits); });
}

Json timesOf(const scene::Scene& scene, std::int64_t frames) {
  Json times = Json::array();
  for (std::int64_t frame = 0; frame < frames; ++frame)
    times.push_back(roundedJson(timeAt(scene, static_cast<double>(frame)), kPlotDigits));
  return times;
}

Json curvesJson(const scene::Panel& panel, const physics::Trajectory& trajectory) {
  const double start = trajectory.samples.front().total();
  const auto ratio = [&](double (*energy)(const Sample&)) {
    return numbers(trajectory, [=](const Sample& sample) { return energy(sample) / start; });
  };
  return {{"label", panel.label},
          {"springs", panel.simulation.model == physics::Model::Particles},
          {"kinetic", ratio([](const Sample& sample) { return sample.kinetic; })},
          {"potential", ratio([](const Sample& sample) { return sample.potential; })},
          {"total", ratio([](const Sample& sample) { return sample.total(); })},
          {"tilt", numbers(trajectory, [](const Sample& sample) { return sample.tiltDeg; })},
          {"error", numbers(trajectory, [](const Sample& sample) { return sample.errorDeg; })}};
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

Json plotsJson(const scene::Scene& scene, const ClipMotion& motion) {
  const std::vector<scene::Panel>& panels = scene.motions;
  Json plots;
  plots["interval"] = motion.trajectories().front().interval;
  if (!hasEvenTimes(scene)) plots["times"] = timesOf(scene, motion.frameCount());
  plots["motions"] = arrayOf(plottedIn(scene, panels.size()), [&](std::size_t i) {
    return curvesJson(panels[i], motion.trajectories()[i]);
  });
  return plots;
}

Json eventJson(const ClipEvent& event) {
  return {{"frame", event.frame},
          {"time_s", event.time},
          {"label", orNull(event.label)},
          {"words", event.words}};
}

Json energyJson(const MotionSummary& summary) {
  return {{"lowest", summary.lowestEnergy}, {"highest", summary.highestEnergy}};
}

}  // namespace

Json expectationJson(const scene::ExpectationResult& result) {
  const scene::Expectation& expectation = result.expectation;
  return {{"quantity", nameOf(expectation.measure)},
          {"from_s", expectation.from},
          {"to_s", expectation.to},
          {"min", orNull(expectation.min)},
          {"max", orNull(expectation.max)},
          {"rises_to", orNull(expectation.risesTo)},
          {"falls_to", orNull(expectation.fallsTo)},
          {"lowest", result.lowest},
          {"highest", result.highest},
          {"met", result.met},
          {"ends_early_s", orNull(result.endsEarly)}};
}

Json motionJson(const MotionSummary& summary) {
  const auto& simulation = summary.motion.simulation;
  std::vector<std::string> notes = notesOn(summary.motion);
  notes.insert(notes.end(), summary.notes.begin(), summary.notes.end());
  return {{"label", orNull(summary.motion.label)},
          {"model", nameOf(scene::kModels, simulation.model)},
          {"integrator", orNull(physics::takesSteps(simulation.model)
                                    ? nameOf(scene::kIntegrators, simulation.integrator)
                                    : std::string_view())},
          {"half_turns", summary.flips.size()},
          {"flips_s", summary.flips},
          {"energy_ratio", energyJson(summary)},
          {"error_deg", orNull(summary.errorDeg)},
          {"visible_from_s", orNull(summary.visibleFrom)},
          {"diverged_at_s", orNull(summary.divergedAt)},
          {"diverges_unexpectedly", summary.divergesUnexpectedly},
          {"judged", summary.isJudged},
          {"met", summary.met()},
          {"expectations", arrayOf(summary.expectations, expectationJson)},
          {"notes", notes}};
}

Json clipJson(const scene::Scene& scene, const ClipMotion& motion,
              const std::vector<MotionSummary>& summaries, const ClipChecksums& checksums) {
  const FrameRate rate = scene.clip.frameRate;
  return {{"result", "clip"},
          {"name", scene.name},
          {"title", scene.title},
          {"scene_xxh128", checksums.scene},
          {"motion_xxh128", checksums.motion},
          {"rate", Json::array({rate.numerator, rate.denominator})},
          {"frames", motion.frameCount()},
          {"motions", arrayOf(summaries, motionJson)},
          {"events", arrayOf(eventsOf(scene, motion), eventJson)},
          {"plots", plotsJson(scene, motion)}};
}

}  // namespace rotatebook::timeline
