// Several scenes in turn: the error of each, the worst status, and one JSON object on all. What
// becomes of a scene is a struct with the members `interrupted` and `error`, a message that is
// empty if there was none. Inside the room only.
#pragma once

#include <algorithm>
#include <cstddef>
#include <exception>
#include <iostream>
#include <string>
#include <vector>

#include "base/json.h"
#include "cli/exit_code.h"

namespace rotatebook::cli {

/// Returns the result of `work` on a scene; `outcome` has the message of an error that is thrown.
template <typename Outcome, typename Work>
auto noted(Outcome& outcome, const Work& work) {
  try {
    return work();
  } catch (const std::exception& error) {
    outcome.error = error.what();
    throw;
  }
}

/// Does `work`, which takes an index, on each scene, up to one that is interrupted; returns the
/// worst status.
template <typename Outcome, typename Work>
int inTurn(std::vector<Outcome>& outcomes, const Work& work) {
  int worst = kDone;
  for (std::size_t i = 0; i < outcomes.size(); ++i) {
    const int status = noted(outcomes[i], [&] { return work(i); });
    if (status >= kInterrupted) return status;
    worst = std::max(worst, status);
  }
  return worst;
}

/// Returns all as one JSON object; `interrupted` says that scenes were left out or undone.
template <typename Outcome, typename AsJson>
Json batchJson(const char* key, const std::vector<Outcome>& outcomes, const AsJson& asJson,
               bool interrupted) {
  return {{"interrupted", interrupted}, {key, arrayOf(outcomes, asJson)}};
}

/// Returns the status of `work`, which prints its reports to the stream that it is given; as JSON,
/// prints one object at the end instead, also after an error, which it reports.
template <typename Outcome, typename Work, typename AsJson>
int reportBatch(bool json, const char* key, std::vector<Outcome>& outcomes, const Work& work,
                const AsJson& asJson) {
  if (!json) return work(std::cout);
  std::ostream nowhere(nullptr);
  const int status = guarded([&] { return work(nowhere); });
  std::cout << jsonLine(batchJson(key, outcomes, asJson, status >= kInterrupted));
  return status;
}

}  // namespace rotatebook::cli
