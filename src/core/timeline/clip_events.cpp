#include "timeline/clip_events.h"

#include <algorithm>

#include "physics/measure/measurement.h"

namespace rotatebook::timeline {
namespace {

using scene::Word;

/// The events of one motion, as they are found.
class Listener {
 public:
  Listener(const scene::Panel& panel, const physics::Trajectory& trajectory, std::int64_t frames,
           const scene::Words& words)
      : panel_(panel), trajectory_(trajectory), frames_(frames), words_(words) {}

  std::vector<ClipEvent> listen() {
    const auto& samples = trajectory_.samples;
    for (std::size_t i = 1; i < samples.size(); ++i) {
      addNudges(samples[i - 1].time, samples[i].time, i);
      // Twice within a frame is one event, with the count after it.
      if (samples[i].halfTurns == samples[i - 1].halfTurns) continue;
      add(i, physics::halfTurnTime(samples[i - 1], samples[i]),
          numbered(Word::Flip, samples[i].halfTurns));
    }
    if (trajectory_.divergedAt) add(samples.size(), *trajectory_.divergedAt, words_[Word::Burst]);
    return events_;
  }

 private:
  void addNudges(double after, double until, std::size_t frame) {
    int number = 0;
    for (const physics::Nudge& nudge : panel_.nudges) {
      ++number;
      if (nudge.at > after && nudge.at <= until)
        add(frame, nudge.at, numbered(Word::Nudge, number));
    }
  }
  std::string numbered(Word word, int number) const {
    return words_[word] + " " + std::to_string(number);
  }
  void add(std::size_t frame, double time, const std::string& what) {
    events_.push_back(
        {std::min(static_cast<std::int64_t>(frame), frames_ - 1), time, panel_.label, what});
  }

  const scene::Panel& panel_;
  const physics::Trajectory& trajectory_;
  std::int64_t frames_;
  const scene::Words& words_;
  std::vector<ClipEvent> events_;
};

}  // namespace

std::vector<ClipEvent> eventsOf(const scene::Scene& scene, const ClipMotion& motion) {
  std::vector<ClipEvent> events;
  if (scene.grid) return events;
  const std::vector<scene::Panel>& panels = scene.motions;
  for (std::size_t i = 0; i < panels.size(); ++i) {
    const std::vector<ClipEvent> own =
        Listener(panels[i], motion.trajectories()[i], motion.frameCount(), scene.overlay.words)
            .listen();
    events.insert(events.end(), own.begin(), own.end());
  }
  std::ranges::stable_sort(events, {}, &ClipEvent::frame);
  return events;
}

}  // namespace rotatebook::timeline
