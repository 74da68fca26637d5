#include "cli/quiet.h"

#include <iostream>

namespace rotatebook::cli {
namespace {

bool isHeld = false;

}  // namespace

bool isQuiet() {
  return isHeld;
}

HeldReports::HeldReports(bool outputIsResult) : log_(std::clog.rdbuf(held_.rdbuf())) {
  if (!outputIsResult) output_ = std::cout.rdbuf(held_.rdbuf());
  isHeld = true;
}

HeldReports::~HeldReports() {
  isHeld = false;
  std::clog.rdbuf(log_);
  if (output_ != nullptr) std::cout.rdbuf(output_);
  std::cerr << held_.str() << std::flush;
}

}  // namespace rotatebook::cli
