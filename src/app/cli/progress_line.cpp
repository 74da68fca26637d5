#include "cli/progress_line.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <unistd.h>
#include <utility>

#include <fmt/ostream.h>

#include "base/json.h"
#include "base/text.h"
#include "cli/terminal.h"
#include "cli/text_width.h"

namespace rotatebook::cli {
namespace {

using std::chrono::duration;
using std::chrono::milliseconds;
using std::chrono::seconds;

constexpr std::size_t kBarWidth = 16, kBarEnds = 3;
constexpr std::size_t kColumnsOfCell = 4;  // The bar has a quarter of a narrow line.
constexpr auto kRateWindow = seconds(4);
constexpr auto kTerminalInterval = milliseconds(100);
constexpr auto kPlainInterval = seconds(5);
constexpr auto kJsonInterval = seconds(1);

ProgressStyle style = ProgressStyle::Bar;

double secondsLeft(std::int64_t done, std::int64_t total, double rate) {
  return static_cast<double>(total - done) / rate;
}

std::string bar(std::int64_t done, std::int64_t total, std::size_t width) {
  const auto filled = static_cast<std::size_t>(static_cast<std::int64_t>(width) * done /
                                               std::max<std::int64_t>(total, 1));
  return fmt::format("[{}{}] ", std::string(filled, '#'), std::string(width - filled, '.'));
}

}  // namespace

std::string progressText(std::int64_t done, std::int64_t total, double rate, std::string_view unit,
                         std::size_t columns) {
  const double percent =
      100.0 * static_cast<double>(done) / static_cast<double>(std::max<std::int64_t>(total, 1));
  const std::string share = fmt::format("{:3.0f} %", percent);
  const std::string count = fmt::format("  {}/{} {}", done, total, unit);
  std::string pace, left;
  if (rate > 0) {
    pace = fmt::format(", {:.1f} {}/s", rate, unit);
    left = fmt::format(", {:.0f} s left", std::ceil(secondsLeft(done, total, rate)));
  }
  // The bar's length is that of the line, not of the words, which change
  const std::size_t cells = std::min(kBarWidth, columns / kColumnsOfCell);
  std::string text = share + count + pace + left;
  for (const std::string& shorter : {share + count + left, share + left}) {
    if (text.size() + cells + kBarEnds > columns) text = shorter;
  }
  if (text.size() > columns) return share.substr(0, columns);
  if (text.size() + kBarEnds >= columns) return text;
  return bar(done, total, std::min(cells, columns - kBarEnds - text.size())) + text;
}

std::string progressJson(std::string_view label, std::int64_t done, std::int64_t total, double rate,
                         std::string_view unit) {
  constexpr int kDigits = 4;
  Json object{{"progress", label}, {"done", done},     {"total", total},
              {"unit", unit},      {"per_s", nullptr}, {"left_s", nullptr}};
  if (rate > 0) {
    object["per_s"] = roundedJson(rate, kDigits);
    object["left_s"] = roundedJson(secondsLeft(done, total, rate), kDigits);
  }
  return jsonText(object);
}

void setProgressStyle(ProgressStyle wanted) {
  style = wanted;
}

ProgressLine::ProgressLine(std::string_view label, std::string unit)
    : label_(oneLine(label)),
      unit_(std::move(unit)),
      terminal_(terminalColumns(STDERR_FILENO) > 0),
      lastPrint_(Clock::now()) {}

ProgressLine::~ProgressLine() {
  if (lineOpen_) std::cerr << '\n';
}

double ProgressLine::rateAfter(const Update& now) {
  updates_.push_back(now);
  while (updates_.size() > 2 && now.time - updates_.front().time > kRateWindow)
    updates_.pop_front();
  const double elapsed = duration<double>(now.time - updates_.front().time).count();
  return elapsed > 0 ? static_cast<double>(now.done - updates_.front().done) / elapsed : 0;
}

std::function<void(std::size_t done, std::size_t total)> ProgressLine::updater() {
  return [this](std::size_t done, std::size_t total) {
    update(static_cast<std::int64_t>(done), static_cast<std::int64_t>(total));
  };
}

void ProgressLine::clear() {
  if (lineOpen_) std::cerr << "\r\x1b[K";
  lineOpen_ = false;
}

void ProgressLine::update(std::int64_t done, std::int64_t total) {
  if (style == ProgressStyle::None) return;
  const Clock::time_point now = Clock::now();
  const double rate = rateAfter({now, done});
  const bool isJson = style == ProgressStyle::Json, isEnd = done == total;
  const milliseconds interval = isJson      ? kJsonInterval
                                : terminal_ ? kTerminalInterval
                                            : kPlainInterval;
  const bool isDue = now - lastPrint_ >= interval;
  if (!isDue && !(isEnd && !ended_ && (terminal_ || isJson))) return;
  lastPrint_ = now;
  ended_ = isEnd;
  if (isJson) {
    std::cerr << progressJson(label_, done, total, rate, unit_) + '\n';
  } else if (terminal_) {
    // A line that wraps couldn't be overwritten
    const std::size_t columns = std::max<std::size_t>(terminalColumns(STDERR_FILENO), 2) - 1;
    const std::string label = cutTo(label_, columns / 3) + "  ";
    const std::string text =
        progressText(done, total, rate, unit_, columns - std::min(columns, columnsOf(label)));
    fmt::print(std::cerr, "\r{}{}\x1b[K", label, text);
    lineOpen_ = true;
  } else {
    fmt::print(std::cerr, "{}  {}\n", label_, progressText(done, total, rate, unit_));
  }
}

}  // namespace rotatebook::cli
