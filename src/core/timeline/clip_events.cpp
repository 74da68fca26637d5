#include "timeline/clip_events.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace rotatebook::timeline {
namespace {

constexpr std::array<std::string_view, 10> kOrdinals{
    "first", "second", "third", "fourth", "fifth", "sixth", "seventh", "eighth", "ninth", "tenth"};

/// Returns "third", or "11th", "22nd".
std::string ordinal(int count) {
  const auto index = static_cast<std::size_t>(count - 1);
  if (index < kOrdinals.size()) return std::string(kOrdinals[index]);
  const int last = count / 10 % 10 == 1 ? 0 : count % 10;
  const char* ending = last == 1 ? "st" : last == 2 ? "nd" : last == 3 ? "rd" : "th";
  return std::to_string(count) + ending;
}

/// The events of one motion, as they are found.
class Listener {
 public:
  Listener(const scene::Panel& panel, const physics::Trajectory& trajectory, std::int64_t frames)
      : panel_(panel), trajectory_(trajectory), frames_(frames) {}

  std::vector<ClipEvent> listen() {
    const auto& samples = trajectory_.samples;
    for (std::size_t i = 1; i < samples.size(); ++i) {
      addNudges(samples[i - 1].time, samples[i].time, i);
      // Twice within a frame is one event, with the count after it.
      if (samples[i].halfTurns == samples[i - 1].halfTurns) continue;
      add(i, samples[i].time, "turned over, " + ordinal(samples[i].halfTurns) + " time");
    }
    if (trajectory_.divergedAt) {
      add(samples.size(), *trajectory_.divergedAt, "flew apart");
    } else if (samples.back().halfTurns == 0) {
      add(samples.size() - 1, samples.back().time, "hasn’t turned over");
    }
    return events_;
  }

 private:
  void addNudges(double after, double until, std::size_t frame) {
    for (const physics::Nudge& nudge : panel_.nudges) {
      if (nudge.at > after && nudge.at <= until) add(frame, nudge.at, "nudged");
    }
  }
  void add(std::size_t frame, double time, const std::string& what) {
    events_.push_back(
        {std::min(static_cast<std::int64_t>(frame), frames_ - 1), time, panel_.label, what});
  }

  const scene::Panel& panel_;
  const physics::Trajectory& trajectory_;
  std::int64_t frames_;
  std::vector<ClipEvent> events_;
};

}  // namespace

std::vector<ClipEvent> eventsOf(const scene::Scene& scene, const ClipMotion& motion) {
  std::vector<ClipEvent> events;
  const std::vector<scene::Panel>& panels = scene.motions;
  for (std::size_t i = 0; i < panels.size(); ++i) {
    const std::vector<ClipEvent> own =
        Listener(panels[i], motion.trajectories()[i], motion.frameCount()).listen();
    events.insert(events.end(), own.begin(), own.end());
  }
  std::ranges::stable_sort(events, {}, &ClipEvent::frame);
  return events;
}

}  // namespace rotatebook::timeline
