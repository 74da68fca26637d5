// A command's progress: a bar on a terminal, plain lines elsewhere. Inside the room only.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <string>
#include <string_view>

namespace rotatebook::cli {

/// Returns "[####....]  42 %  126/300 frames, 38.1 frames/s, 5 s left". `rate` is in units a
/// second, 0 while it isn't known; `unit` is their plural. In fewer `columns` the rate goes,
/// then the count; the bar is shorter, cell by cell, to none before the time left goes.
std::string progressText(std::int64_t done, std::int64_t total, double rate,
                         std::string_view unit = "frames", std::size_t columns = 1000);

/// Returns the same as a JSON object, without a line end: "progress", which is `label`, "done",
/// "total", "unit"; "per_s" and "left_s" are null while they aren't known.
std::string progressJson(std::string_view label, std::int64_t done, std::int64_t total, double rate,
                         std::string_view unit);

enum class ProgressStyle { Bar, Json, None };

/// Has progress shown so from now on: as a bar, or plain lines elsewhere than on a terminal; as
/// lines of JSON; or not at all.
void setProgressStyle(ProgressStyle style);

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
  bool ended_ = false;  ///< The last line said that all is done.
  std::deque<Update> updates_;
  Clock::time_point lastPrint_;
};

}  // namespace rotatebook::cli
