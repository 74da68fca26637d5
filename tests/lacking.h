// Skips the tests that need what a machine may lack, such as terminals, and says why.
#pragma once

#include <cstdlib>
#include <string>

#include <gtest/gtest.h>

namespace rotatebook::testing {

/// Recognises a CI run (CI=true), whose machine must have all that the tests need.
inline bool inCi() {
  const char* ci = std::getenv("CI");
  return ci != nullptr && std::string(ci) == "true";
}

}  // namespace rotatebook::testing

/// Ends the test where `reason`, which says what the machine lacks, isn't empty: as failed in CI,
/// as skipped elsewhere. tests/page/browser/run has the same rule.
#define ROTATEBOOK_SKIP_IF_LACKING(reason)                     \
  if (const std::string lacking = (reason); lacking.empty()) { \
  } else if (rotatebook::testing::inCi()) {                    \
    FAIL() << lacking;                                         \
  } else                                                       \
    GTEST_SKIP() << lacking
