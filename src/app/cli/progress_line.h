// A command's progress: a bar on a terminal, plain lines elsewhere. Inside the room only.
#pragma once

#include <chrono>
#include <cstdint>
#include <deque>
#include <functional>
#include <string>
#include <string_view>

namespace rotatebook::cli {

/// Returns "[####....]  42 %  126/300 frames, 38.1 frames/s, 5 s left". `rate` is in units a
/// second, 0 while it isn't known; `unit` is their plural.
std::string progressText(std::int64_t done, std::int64_t total, double rate,
                         std::string_view unit = "frames");

/// Has no progress shown from now on.
void hideProgress();

/// Prints progress to the standard error, with the rate of the last seconds.
class ProgressLine {
 public:
  /// `unit` is the plural of what is counted.
  explicit ProgressLine(std::string_view label, std::string unit = "frames");
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;
  /// Ends the line of the bar.
  ~ProgressLine();

  void update(std::int64_t done, std::int64_t total);
  /// Returns a function that calls update(), for what counts runs; valid as long as this object.
  std::function<void(std::size_t done, std::size_t total)> updater();
  /// Erases the bar until the next update(), so that other lines can be printed.
  void clear();

 private:
  using Clock = std::chrono::steady_clock;
  struct Update {
    Clock::time_point time;
    std::int64_t done;
  };

  double rateAfter(const Update& now);

  std::string label_;
  std::string unit_;
  bool terminal_;
  bool lineOpen_ = false;
  std::deque<Update> updates_;
  Clock::time_point lastPrint_;
};

}  // namespace rotatebook::cli
