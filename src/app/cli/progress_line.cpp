#include "cli/progress_line.h"

#include <algorithm>
#include <cstddef>
#include <iostream>
#include <sys/ioctl.h>
#include <unistd.h>
#include <utility>

#include <fmt/core.h>

#include "base/text.h"

namespace rotatebook::cli {
namespace {

using std::chrono::duration;
using std::chrono::milliseconds;
using std::chrono::seconds;

constexpr int kBarWidth = 16;
constexpr std::size_t kUsualColumns = 80;
constexpr auto kRateWindow = seconds(4);
constexpr auto kTerminalInterval = milliseconds(100);
constexpr auto kPlainInterval = seconds(5);

bool isHidden = false;

std::string bar(std::int64_t done, std::int64_t total) {
  const auto filled = static_cast<std::size_t>(kBarWidth * done / std::max<std::int64_t>(total, 1));
  return '[' + std::string(filled, '#') + std::string(kBarWidth - filled, '.') + ']';
}

/// Returns the terminal's width: a line that wraps couldn't be overwritten.
std::size_t terminalColumns() {
  winsize size{};
  const bool known = ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 1;
  return known ? size.ws_col : kUsualColumns;
}

/// Joins label and text in at most `columns`; the label is cut first.
std::string fitted(const std::string& label, const std::string& text, std::size_t columns) {
  const std::size_t room = columns > text.size() + 2 ? columns - text.size() - 2 : 0;
  return (std::string(firstCharacters(label, room)) + "  " + text).substr(0, columns);
}

}  // namespace

std::string progressText(std::int64_t done, std::int64_t total, double rate,
                         std::string_view unit) {
  const double percent =
      100.0 * static_cast<double>(done) / static_cast<double>(std::max<std::int64_t>(total, 1));
  const std::string line =
      fmt::format("{} {:3.0f} %  {}/{} {}", bar(done, total), percent, done, total, unit);
  if (rate <= 0) return line;
  return fmt::format("{}, {:.1f} {}/s, {:.0f} s left", line, rate, unit,
                     static_cast<double>(total - done) / rate);
}

void hideProgress() {
  isHidden = true;
}

ProgressLine::ProgressLine(std::string_view label, std::string unit)
    : label_(oneLine(label)),
      unit_(std::move(unit)),
      terminal_(isatty(STDERR_FILENO) == 1),
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
  if (lineOpen_) std::cerr << "\r\x1b[K" << std::flush;
  lineOpen_ = false;
}

void ProgressLine::update(std::int64_t done, std::int64_t total) {
  if (isHidden) return;
  const Clock::time_point now = Clock::now();
  const double rate = rateAfter({now, done});
  const bool due = now - lastPrint_ >=
                   (terminal_ ? milliseconds(kTerminalInterval) : milliseconds(kPlainInterval));
  if (!due && !(terminal_ && done == total)) return;
  lastPrint_ = now;
  const std::string text = progressText(done, total, rate, unit_);
  if (terminal_) {
    std::cerr << '\r' << fitted(label_, text, terminalColumns() - 1) << "\x1b[K" << std::flush;
    lineOpen_ = true;
  } else {
    std::cerr << label_ << "  " << text << '\n';
  }
}

}  // namespace rotatebook::cli
