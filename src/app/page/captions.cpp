#include "page/captions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string_view>

#include "base/number_text.h"

namespace rotatebook::page {
namespace {

// [s]
constexpr double kLongest = 3, kShortest = 0.8, kGap = 0.05;

// The pictures' own words stand at the bottom.
constexpr const char* kAtTheTop = " line:0";

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

template <typename... Values>
std::string printed(const char* format, Values... values) {
  std::array<char, 64> text;
  std::snprintf(text.data(), text.size(), format, values...);
  return text.data();
}

/// The events of one motion, as they are found.
class Listener {
 public:
  Listener(const Motion& motion, std::int64_t frames)
      : motion_(motion),
        label_(motion.panel.label.empty() ? "" : motion.panel.label + ": "),
        frames_(frames) {}

  std::vector<Event> listen() {
    const auto& samples = motion_.trajectory.samples;
    for (std::size_t i = 1; i < samples.size(); ++i) {
      addNudges(samples[i - 1].time, samples[i].time, i);
      // Twice within a frame is one event, with the count after it.
      if (samples[i].halfTurns == samples[i - 1].halfTurns) continue;
      add(i, samples[i].time, "turned over, " + ordinal(samples[i].halfTurns) + " time");
    }
    if (motion_.trajectory.divergedAt) {
      add(samples.size(), *motion_.trajectory.divergedAt, "flew apart");
    } else if (samples.back().halfTurns == 0) {
      add(samples.size() - 1, samples.back().time, "hasn’t turned over");
    }
    return events_;
  }

 private:
  void addNudges(double after, double until, std::size_t frame) {
    for (const physics::Nudge& nudge : motion_.panel.nudges) {
      if (nudge.at > after && nudge.at <= until) add(frame, nudge.at, "nudged");
    }
  }
  void add(std::size_t frame, double time, const std::string& what) {
    events_.push_back({std::min(static_cast<std::int64_t>(frame), frames_ - 1),
                       printed("%.2f s: ", time) + label_ + what});
  }

  const Motion& motion_;
  std::string label_;
  std::int64_t frames_;
  std::vector<Event> events_;
};

/// Returns "00:00:04.067".
std::string clockText(double seconds) {
  const auto ms = static_cast<long long>(std::llround(seconds * 1000));
  return printed("%02lld:%02lld:%02lld.%03lld", ms / 3'600'000, ms / 60'000 % 60, ms / 1000 % 60,
                 ms % 1000);
}

/// WebVTT takes markup and entities in a cue's text, and ends it at an empty line.
std::string cueText(const std::string& words) {
  std::string text;
  for (const char letter : words) {
    text += letter == '&'   ? "&amp;"
            : letter == '<' ? "&lt;"
            : letter == '>' ? "&gt;"
                            : std::string(1, letter);
  }
  return text;
}

}  // namespace

std::vector<Event> eventsOf(const std::vector<Motion>& motions, std::int64_t frames) {
  std::vector<Event> events;
  for (const Motion& motion : motions) {
    const std::vector<Event> own = Listener(motion, frames).listen();
    events.insert(events.end(), own.begin(), own.end());
  }
  std::ranges::stable_sort(events, {}, &Event::frame);
  return events;
}

std::string webVtt(const std::vector<Event>& events, const FrameRate& rate, std::int64_t frames) {
  const double end = static_cast<double>(frames) * rate.period();
  std::string text = "WEBVTT\n";
  for (std::size_t i = 0; i < events.size(); ++i) {
    const double start = static_cast<double>(events[i].frame) * rate.period();
    const double next =
        i + 1 < events.size() ? static_cast<double>(events[i + 1].frame) * rate.period() : end;
    double last = std::clamp(next - kGap, start + kShortest, start + kLongest);
    // Events at the end are shown before it, as there is no time after it.
    const double first = std::min(start, std::max(0.0, end - kShortest));
    last = std::min(last, end);
    text += "\n" + clockText(first) + " --> " + clockText(last) + kAtTheTop + "\n" +
            cueText(events[i].words) + "\n";
  }
  return text;
}

}  // namespace rotatebook::page
