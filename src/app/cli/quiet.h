// Reports that --quiet holds back. Inside the room only.
#pragma once

#include <sstream>
#include <streambuf>

namespace rotatebook::cli {

/// Returns whether reports are held back now; no progress is shown then.
bool isQuiet();

/// Holds back what is printed to std::clog and, unless it is the command's result, to std::cout.
class HeldReports {
 public:
  explicit HeldReports(bool outputIsResult);
  HeldReports(const HeldReports&) = delete;
  HeldReports& operator=(const HeldReports&) = delete;
  /// Prints to the standard error what was held, as the reason of a failure is in it.
  ~HeldReports();

  /// Forgets what was held.
  void discard() { held_.str({}); }

 private:
  std::ostringstream held_;
  std::streambuf* log_;
  std::streambuf* output_ = nullptr;
};

}  // namespace rotatebook::cli
