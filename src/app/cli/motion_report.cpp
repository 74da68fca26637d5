#include "cli/motion_report.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>

#include <fmt/ostream.h>

#include "base/json.h"
#include "base/number_text.h"
#include "base/text.h"
#include "scene/expectation_text.h"
#include "scene/names.h"
#include "timeline/clip_json.h"
#include "timeline/notes.h"

namespace rotatebook::cli {
namespace {

using timeline::MotionSummary;

constexpr double kHalfTurnDeg = 180;
constexpr double kVisibleChange = 1e-3;  // of the energy

/// Returns `value` >= 0 rounded up to so many significant digits: "2e-9".
std::string roundedUp(double value, int digits) {
  if (value == 0) return "0";
  const double unit = std::pow(10, std::floor(std::log10(value)) + 1 - digits);
  std::string text = roundedText(std::ceil(value / unit) * unit, digits);
  if (const auto zero = text.find("e-0"); zero != text.npos) text.erase(zero + 2, 1);
  return text;
}

/// Rounds to hundredths of a second, from 100 s on to seconds.
std::string secondsText(double time) {
  const double digits = time < 100 ? 100 : 1;
  return shortestText(std::round(time * digits) / digits);
}

/// Returns "3 flips, at 2.43, 6.82, 11.2 s"; of many the first ones.
std::string flipsText(const MotionSummary& summary) {
  constexpr std::size_t kMaxListed = 8;
  const std::string text = countText(std::ssize(summary.flips), "flip");
  if (summary.flips.empty()) return text;
  const auto shown = std::span(summary.flips).first(std::min(summary.flips.size(), kMaxListed));
  return fmt::format("{}, at {}{} s", text, joinedOf(shown, secondsText),
                     shown.size() < summary.flips.size() ? " ..." : "");
}

}  // namespace

std::string distanceText(const MotionSummary& summary) {
  if (!summary.errorDeg) return "the exact motion itself, in closed form";
  const double farthest = *summary.errorDeg;
  const char* exact = summary.motion.simulation.dissipates()
                          ? "the exact motion without dissipation"
                          : "the exact motion";
  if (farthest < 1) {
    return fmt::format("within {} of {}", countText(roundedUp(farthest, 1), "degree"), exact);
  }
  const std::string text = fmt::format("up to {} degrees from {}",
                                       roundedUp(std::min(farthest, kHalfTurnDeg), 3), exact);
  if (!summary.visibleFrom) return text;
  return fmt::format("{}; more than {} from {} s on", text,
                     shortestText(timeline::kVisibleErrorDeg), secondsText(*summary.visibleFrom));
}

std::string energyText(const MotionSummary& summary) {
  const double lowest = summary.lowestEnergy, highest = summary.highestEnergy;
  const double change = std::max(1 - lowest, highest - 1);
  if (change == 0) return "energy kept exactly";
  if (change < kVisibleChange) return "energy kept to " + roundedUp(change, 1);
  return fmt::format("energy {} to {} of its start", roundedText(lowest, 4),
                     roundedText(highest, 4));
}

namespace {

/// Prints all notes, or the first of a grid's, as the others are much the same.
void printNotes(const scene::Scene& scene, const std::vector<std::string>& notes,
                std::ostream& out) {
  constexpr std::size_t kMaxOfGrid = 3;
  const std::size_t shown = scene.grid ? std::min(notes.size(), kMaxOfGrid) : notes.size();
  for (std::size_t i = 0; i < shown; ++i) fmt::print(out, "note: {}\n", notes[i]);
  if (shown == notes.size()) return;
  fmt::print(out, "note: {}: {} more notes on other books of the grid; --json has all\n",
             scene.name, notes.size() - shown);
}

}  // namespace

void reportNotes(const scene::Scene& scene, std::ostream& out) {
  reportNotes(scene, timeline::notesOn(scene), out);
}

void reportNotes(const scene::Scene& scene, std::vector<std::string> notes, std::ostream& out) {
  for (std::string& note : notes) note = scene.name + ": " + note;
  printNotes(scene, notes, out);
}

void reportNotes(const scene::Scene& scene, const std::vector<MotionSummary>& motions,
                 std::ostream& out) {
  std::vector<std::string> notes;
  for (const MotionSummary& summary : motions) {
    for (const std::string& note : summary.notes) {
      notes.push_back(joined({scene.name, summary.motion.label}) + ": " + note);
    }
  }
  printNotes(scene, notes, out);
}

namespace {

/// Prints a line about the motions of a grid, and what is expected of some.
void reportGrid(const std::vector<MotionSummary>& motions, std::ostream& out) {
  const auto flipsOf = [](const MotionSummary& summary) { return summary.flips.size(); };
  const auto [fewest, most] = std::ranges::minmax(motions, {}, flipsOf);
  const auto diverged = std::ranges::count_if(
      motions, [](const MotionSummary& summary) { return summary.divergedAt.has_value(); });
  fmt::print(out, "  {} motions: {} to {}; {} diverged\n", motions.size(), fewest.flips.size(),
             countText(std::ssize(most.flips), "flip"),
             diverged > 0 ? std::to_string(diverged) : "none");
  for (const MotionSummary& summary : motions) {
    if (summary.expectations.empty()) continue;
    fmt::print(out, "  {}:\n", summary.motion.label);
    reportExpectations(summary, out);
  }
}

}  // namespace

void reportMotions(const std::vector<MotionSummary>& motions, std::ostream& out) {
  constexpr std::size_t kMaxListed = 6;
  if (!motions.empty() && !motions.front().isJudged) {
    out << "  expectations are left out (--no-expect)\n";
  }
  if (motions.size() > kMaxListed) return reportGrid(motions, out);
  for (const MotionSummary& summary : motions) {
    if (!summary.motion.label.empty()) fmt::print(out, "  {}:\n", summary.motion.label);
    fmt::print(out, "  {}; {}; {}\n", flipsText(summary), energyText(summary),
               distanceText(summary));
    reportExpectations(summary, out);
  }
}

Json motionsJson(const std::vector<MotionSummary>& motions) {
  return arrayOf(motions, timeline::motionJson);
}

void reportSimulationAsJson(const scene::Scene& scene, const std::vector<WrittenTable>& tables,
                            const std::vector<MotionSummary>& motions, std::ostream& out) {
  Json written = Json::array();
  for (const WrittenTable& table : tables) {
    written.push_back({{"path", table.path.string()}, {"rows", table.rows}});
  }
  out << jsonLine({{"name", scene.name},
                   {"title", scene.title},
                   {"tables", written},
                   {"motions", motionsJson(motions)}});
}

namespace {

std::string lineOf(bool met, const std::string& subject, const std::string& expected,
                   const std::string& measured) {
  return fmt::format("{:<9}{}: expected {}; measured {}", met ? "met" : "not met", subject,
                     expected, measured);
}

}  // namespace

std::string reportLine(const scene::ExpectationResult& result) {
  const scene::Expectation& expectation = result.expectation;
  return lineOf(result.met, std::string(nameOf(expectation.measure)) + windowText(expectation),
                expectedText(expectation), measuredText(result));
}

std::string reportLine(const std::string& subject, const scene::Bounds& bounds, double measured) {
  const scene::Expectation expectation{.min = bounds.min, .max = bounds.max};
  return lineOf(bounds.hold(measured), subject, expectedText(expectation),
                measuredText(measured, expectation));
}

void reportExpectations(const timeline::MotionSummary& summary, std::ostream& out) {
  if (summary.divergedAt) {
    fmt::print(out, "  {}the motion diverges at {} s, after {} frames\n",
               summary.divergesUnexpectedly ? "not met  no divergence is expected; " : "",
               shortestText(std::round(*summary.divergedAt * 1e4) / 1e4), summary.frames);
  }
  for (const scene::ExpectationResult& result : summary.expectations) {
    fmt::print(out, "  {}\n", reportLine(result));
  }
}

}  // namespace rotatebook::cli
