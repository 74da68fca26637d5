#include "cli/verdict_report.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string_view>

#include <fmt/ostream.h>

#include "base/json.h"
#include "base/number_text.h"
#include "base/text.h"
#include "page/html.h"
#include "timeline/judge.h"
#include "timeline/motion_summary.h"

namespace rotatebook::cli {
namespace {

using timeline::Verdict;

std::string shortNumber(double value) {
  return roundedText(value, 4);
}

std::string_view regimeText(rigid::Regime regime) {
  constexpr std::array<std::string_view, 3> kTexts{"the axis of the smallest moment", "no axis",
                                                   "the axis of the largest moment"};
  return kTexts[static_cast<std::size_t>(static_cast<int>(regime) + 1)];
}

std::string percentOf(double part) {
  return roundedText(100 * part, 2) + " %";
}

/// Returns "energy +47.5 % at most, +3 % at the end".
std::string driftText(const char* name, double largest, double end) {
  const auto signedText = [](double drift) {
    return (drift > 0 ? "+" : "") + roundedText(100 * drift, 3);
  };
  return fmt::format("{} {} % at most, {} % at the end", name, signedText(largest),
                     signedText(end));
}

BoundResult bounded(const char* name, double measured, double bound) {
  const bool met = std::fabs(measured) <= bound;
  return {name, fmt::format("at most {}; measured {}", shortestText(bound), shortNumber(measured)),
          met};
}

/// Returns `text` for XML: its marks as entities, control characters as blanks.
std::string escapedXml(std::string_view text) {
  std::string plain = validUtf8(text);
  std::ranges::replace_if(
      plain, [](unsigned char letter) { return letter < ' '; }, ' ');
  return page::escaped(plain).text;
}

std::string caseText(const std::string& motion, const BoundResult& one) {
  const std::string head = fmt::format(R"(    <testcase classname="{}" name="{}")",
                                       escapedXml(motion), escapedXml(one.name));
  if (one.met) return head + "/>\n";
  return fmt::format("{}>\n      <failure message=\"{}\"/>\n    </testcase>\n", head,
                     escapedXml(one.text));
}

std::string regimesText(const Verdict& verdict) {
  const std::string_view start = regimeText(verdict.start), end = regimeText(verdict.end);
  if (start == end) return fmt::format("the angular momentum circles {}", start);
  return fmt::format("the angular momentum circles {} at first, {} at the end", start, end);
}

std::string_view sourceText(recording::SpinSource source) {
  constexpr std::array<std::string_view, 3> kTexts{"given", "slopes", "gyroscope"};
  return kTexts[static_cast<std::size_t>(source)];
}

/// Returns a line on the angular velocities where they aren't exact; empty where they are.
std::string spinsLine(const Verdict& verdict) {
  constexpr double kShown = 0.01, kNoise = 1e-4;
  std::vector<std::string> parts;
  if (verdict.spins.source == recording::SpinSource::Slopes) {
    parts.push_back("the angular velocities are slopes of the attitudes alone, good to " +
                    percentOf(verdict.spins.uncertainty));
  }
  const bool isSaid = verdict.errs == timeline::Errs::RatesAreOff;
  if (!isSaid && (verdict.spins.fit.isOff() || verdict.spins.difference > kShown))
    parts.push_back("the angular velocities " + timeline::ratesText(verdict.spins));
  if (verdict.scatter > kNoise) parts.push_back("noise of " + percentOf(verdict.scatter));
  if (verdict.fittedBy)
    parts.push_back("the start is fitted, its spin changed by " + percentOf(*verdict.fittedBy));
  return parts.empty() ? "" : fmt::format("  {}\n", joined(parts, "; "));
}

Json boundJson(const BoundResult& one) {
  return {{"name", one.name}, {"text", one.text}, {"met", one.met}};
}

Json verdictJson(const JudgedMotion& motion, const VerdictBounds& bounds) {
  const Verdict& verdict = motion.verdict;
  if (!motion.mistake.empty()) {
    return {{"name", motion.name},
            {"mistake", motion.mistake},
            {"notes", motion.notes},
            {"bounds", Json::array()}};
  }
  return {{"name", motion.name},
          {"samples", static_cast<std::int64_t>(verdict.samples)},
          {"duration_s", verdict.duration},
          {"error_deg", verdict.errorDeg},
          {"end_error_deg", verdict.endErrorDeg},
          {"visible_from_s", orNull(verdict.visibleFrom)},
          {"energy_drift", verdict.energyDrift},
          {"end_energy_drift", verdict.endEnergyDrift},
          {"L_drift", verdict.momentumDrift},
          {"end_L_drift", verdict.endMomentumDrift},
          {"L_turn_deg", verdict.momentumTurnDeg},
          {"half_turns", verdict.halfTurns},
          {"half_turns_due", verdict.halfTurnsDue},
          {"regime", static_cast<int>(verdict.start)},
          {"end_regime", static_cast<int>(verdict.end)},
          {"method", timeline::methodThat(verdict)},
          {"spins", sourceText(verdict.spins.source)},
          {"spin_uncertainty", verdict.spins.uncertainty},
          {"rates_difference", verdict.spins.difference},
          {"rates_factor", verdict.spins.fit.factor},
          {"rates_bias", vectorJson(verdict.spins.fit.bias)},
          {"rates_turn_deg", vectorJson(verdict.spins.fit.turn * (180 / std::numbers::pi))},
          {"scatter", verdict.scatter},
          {"start_fitted_by", orNull(verdict.fittedBy)},
          {"flaws", verdict.flaws},
          {"notes", motion.notes},
          {"bounds", arrayOf(resultsOf(verdict, bounds), boundJson)}};
}

}  // namespace

JudgedMotion judgedMotion(const std::string& name, const physics::MotionSettings& motion,
                          const physics::Trajectory& trajectory) {
  JudgedMotion judged{.name = name, .verdict = timeline::judge(motion, trajectory)};
  if (!timeline::isJudged(judged.verdict)) judged.mistake = timeline::methodThat(judged.verdict);
  const auto& recorded = motion.simulation.recorded.motion;
  if (motion.simulation.model == physics::Model::Recorded) judged.notes = recorded->notes();
  return judged;
}

std::vector<BoundResult> resultsOf(const Verdict& verdict, const VerdictBounds& bounds) {
  std::vector<BoundResult> results;
  const auto add = [&](const char* name, double measured, const std::optional<double>& bound) {
    if (bound) results.push_back(bounded(name, measured, *bound));
  };
  add("error_deg", verdict.errorDeg, bounds.errorDeg);
  add("energy_drift", verdict.energyDrift, bounds.energyDrift);
  add("L_drift", verdict.momentumDrift, bounds.momentumDrift);
  if (bounds.halfTurns) {
    results.push_back({"half_turns",
                       fmt::format("{} due; measured {}", verdict.halfTurnsDue, verdict.halfTurns),
                       verdict.halfTurns == verdict.halfTurnsDue});
  }
  return results;
}

bool allMet(const std::vector<JudgedMotion>& motions, const VerdictBounds& bounds) {
  return std::ranges::all_of(motions, [&](const JudgedMotion& motion) {
    return motion.mistake.empty() &&
           std::ranges::all_of(resultsOf(motion.verdict, bounds), &BoundResult::met);
  });
}

void reportVerdicts(const std::vector<JudgedMotion>& motions, const VerdictBounds& bounds,
                    std::ostream& out) {
  for (const auto& [name, verdict, mistake, notes] : motions) {
    if (!mistake.empty()) {
      fmt::print(out, "{}: not judged: {}\n", oneLine(name), mistake);
      continue;
    }
    fmt::print(out, "{}: {}\n  error {} degrees after {} s, at most {}", oneLine(name),
               timeline::methodThat(verdict), shortNumber(verdict.endErrorDeg),
               shortNumber(verdict.duration), shortNumber(verdict.errorDeg));
    if (verdict.visibleFrom) {
      fmt::print(out, ", more than {} from {} s on", shortNumber(timeline::kVisibleErrorDeg),
                 shortNumber(*verdict.visibleFrom));
    }
    fmt::print(out, "\n  {}; {}; L turned by up to {} degrees\n{}  {} of {} flips; {}\n",
               driftText("energy", verdict.energyDrift, verdict.endEnergyDrift),
               driftText("|L|", verdict.momentumDrift, verdict.endMomentumDrift),
               shortNumber(verdict.momentumTurnDeg), spinsLine(verdict), verdict.halfTurns,
               verdict.halfTurnsDue, regimesText(verdict));
    for (const BoundResult& one : resultsOf(verdict, bounds))
      fmt::print(out, "  {}{}: expected {}\n", one.met ? "met      " : "not met  ", one.name,
                 one.text);
  }
}

void reportVerdictsAsJson(const std::vector<JudgedMotion>& motions, const VerdictBounds& bounds,
                          std::ostream& out) {
  const auto asJson = [&](const auto& one) { return verdictJson(one, bounds); };
  out << jsonLine({{"met", allMet(motions, bounds)}, {"motions", arrayOf(motions, asJson)}});
}

std::string junitOf(const std::vector<JudgedMotion>& motions, const VerdictBounds& bounds) {
  std::string text(kJunitBeginning);
  for (const auto& [name, verdict, mistake, notes] : motions) {
    std::vector<BoundResult> results = resultsOf(verdict, bounds);
    if (!mistake.empty()) results = {{"recording", mistake, false}};
    if (results.empty()) results.push_back({"judged", "", true});
    text +=
        fmt::format("  <testsuite name=\"{}\" tests=\"{}\" failures=\"{}\">\n", escapedXml(name),
                    results.size(), std::ranges::count(results, false, &BoundResult::met));
    for (const BoundResult& one : results) text += caseText(name, one);
    text +=
        fmt::format("    <system-out>{}</system-out>\n  </testsuite>\n",
                    escapedXml(mistake.empty() ? timeline::methodThat(verdict) : "isn't judged"));
  }
  return text + "</testsuites>\n";
}

}  // namespace rotatebook::cli
