#include "timeline/web_vtt.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "base/number_text.h"

namespace rotatebook::timeline {
namespace {

// [s]
constexpr double kLongest = 3, kShortest = 0.8, kGap = 0.05;

/// A text and when it is shown, in time of the video.
struct TimedText {
  double from, to;  // [s]
  std::string text;
};

/// Returns at least `digits` digits.
std::string padded(std::int64_t number, std::size_t digits) {
  const std::string text = std::to_string(number);
  return std::string(digits - std::min(digits, text.size()), '0') + text;
}

/// Returns "00:00:04.067".
std::string momentOf(double seconds) {
  const std::int64_t ms = std::llround(seconds * 1000);
  return padded(ms / 3'600'000, 2) + ":" + padded(ms / 60'000 % 60, 2) + ":" +
         padded(ms / 1000 % 60, 2) + "." + padded(ms % 1000, 3);
}

/// WebVTT takes markup and entities in a cue's text, and ends it at an empty line.
std::string cueText(const std::string& words) {
  std::string text;
  for (const char letter : words) {
    if (letter == '\n' && (text.empty() || text.back() == '\n')) continue;
    text += letter == '&'    ? "&amp;"
            : letter == '<'  ? "&lt;"
            : letter == '>'  ? "&gt;"
            : letter == '\r' ? ""
                             : std::string(1, letter);
  }
  return text;
}

std::vector<TimedText> captionsOf(const scene::Scene& scene, std::int64_t frames) {
  std::vector<TimedText> captions;
  if (scene.cues.empty()) return captions;
  const double period = scene.clip.frameRate.period();
  const auto begin = [&](std::int64_t frame, const std::string& text) {
    const double time = static_cast<double>(frame) * period;
    if (!captions.empty()) captions.back().to = time;
    captions.push_back({time, static_cast<double>(frames) * period, text});
  };
  begin(0, scene.caption);
  for (const scene::ShownCue& shown : scene.shownCues) {
    const auto& text = scene.cues[shown.cue].text;
    if (text && shown.frame < frames) begin(shown.frame, *text);
  }
  std::erase_if(captions,
                [](const TimedText& one) { return one.text.empty() || one.from == one.to; });
  return captions;
}

std::vector<TimedText> timed(const scene::Scene& scene, const std::vector<ClipEvent>& events,
                             std::int64_t frames) {
  const double period = scene.clip.frameRate.period();
  const double end = static_cast<double>(frames) * period;
  std::vector<TimedText> texts;
  for (std::size_t i = 0; i < events.size(); ++i) {
    const double start = static_cast<double>(events[i].frame) * period;
    const double next =
        i + 1 < events.size() ? static_cast<double>(events[i + 1].frame) * period : end;
    const double last = std::clamp(next - kGap, start + kShortest, start + kLongest);
    texts.push_back({start, std::min(last, end), eventText(events[i], scene.overlay.words)});
  }
  return texts;
}

}  // namespace

std::string eventText(const ClipEvent& event, const scene::Words& words) {
  const double hundredths = std::round(event.time * 100);
  const std::string digits = padded(std::llround(hundredths), 3);
  const std::string time =
      digits.substr(0, digits.size() - 2) + words.decimalMark + digits.substr(digits.size() - 2);
  return time + " s: " + (event.label.empty() ? "" : event.label + ": ") + event.words;
}

std::string webVtt(const scene::Scene& scene, const std::vector<ClipEvent>& events,
                   std::int64_t frames) {
  std::vector<TimedText> all = captionsOf(scene, frames);
  const std::vector<TimedText> measured = timed(scene, events, frames);
  all.insert(all.end(), measured.begin(), measured.end());
  std::ranges::stable_sort(all, {}, &TimedText::from);
  std::string text = std::string(kVttHead) + "\n";
  // The pictures' own words stand at the bottom.
  for (const TimedText& one : all) {
    text += "\n" + momentOf(one.from) + " --> " + momentOf(one.to) + " line:0\n" +
            cueText(one.text) + "\n";
  }
  return text;
}

}  // namespace rotatebook::timeline
