// Reports on the inertia that a toss told, as text and as JSON, and the scene that shows it.
#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "recording/read_options.h"
#include "recording/toss.h"

namespace rotatebook::report {

/// Prints the flight, the ratios of the moments with their intervals, and the fit's residual;
/// `name` is the recording's.
void reportToss(const recording::TossFit& fit, const std::string& name, std::ostream& out);
/// Prints the same as one JSON object.
void reportTossAsJson(const recording::TossFit& fit, const std::string& name, std::ostream& out);

/// Prints a line for each throw of a recording: its time and spin, and its ratios or why it is
/// refused.
void reportThrows(const std::vector<recording::Throw>& throws, const std::string& name,
                  std::ostream& out);
/// Prints the same as one JSON object.
void reportThrowsAsJson(const std::vector<recording::Throw>& throws, const std::string& name,
                        std::ostream& out);

/// Returns a scene of the toss: the recording beside the exact motion from its fitted start, at a
/// tenth of its speed. `file` is the recording's path from the scene's folder, `options` what the
/// command line stated about it.
std::string tossScene(const recording::TossFit& fit, const std::string& file,
                      const recording::ReadOptions& options);

}  // namespace rotatebook::report
