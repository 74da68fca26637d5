#include "page/captions.h"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>

namespace rotatebook::page {
namespace {

// [s]
constexpr double kLongest = 3, kShortest = 0.8, kGap = 0.05;

// The pictures' own words stand at the bottom.
constexpr const char* kAtTheTop = " line:0";

/// Returns "00:00:04.067".
std::string clockText(double seconds) {
  const auto ms = std::llround(seconds * 1000);
  return fmt::format("{:02}:{:02}:{:02}.{:03}", ms / 3'600'000, ms / 60'000 % 60, ms / 1000 % 60,
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

std::string headOf(double time) {
  return fmt::format("{:.2f} s: ", time);
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
    text += fmt::format("\n{} --> {}{}\n{}\n", clockText(first), clockText(last), kAtTheTop,
                        cueText(events[i].words));
  }
  return text;
}

}  // namespace rotatebook::page
