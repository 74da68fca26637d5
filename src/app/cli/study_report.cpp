#include "cli/study_report.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>

#include <fmt/core.h>

#include "base/json.h"
#include "base/number_text.h"
#include "base/text.h"
#include "cli/motion_report.h"
#include "scene/expectation_text.h"
#include "scene/names.h"

namespace rotatebook::cli {
namespace {

using scene::Measure;
using scene::StudySettings;
using study::RunEnd;
using study::StudyRow;

constexpr std::array<std::pair<RunEnd::Kind, const char*>, 3> kFailures{
    {{RunEnd::Kind::Diverged, "diverged"},
     {RunEnd::Kind::NoConvergence, "found no solution for their steps"},
     {RunEnd::Kind::StepTooLong, "had steps too long for their series"}}};

bool isOfOrdersAlone(const StudySettings& study) {
  return study.measures == std::vector<Measure>{Measure::Order};
}

std::string orderLine(const study::CurveOrder& order) {
  const study::OrderFit& fit = order.fit;
  const std::string curve = order.curve.empty() ? "" : fmt::format("{:<16} ", order.curve);
  if (std::isnan(fit.order)) {
    return fmt::format("{}no order: {} usable runs, {} needed", curve, fit.runs, study::kMinRuns);
  }
  return fmt::format("{}order {:5.2f} from {:2} runs, steps of {:.3g} to {:.3g} s", curve,
                     fit.order, fit.runs, fit.shortest, fit.longest);
}

/// Returns "euler: 3 of 11 runs diverged"; empty if no run ended like that.
std::string failureLine(const study::Study& result, const std::string& curve, RunEnd::Kind kind,
                        const char* outcome) {
  const auto runs = std::ranges::count(result.rows, curve, &StudyRow::curve);
  const auto failed = std::ranges::count_if(
      result.rows, [&](const StudyRow& row) { return row.curve == curve && row.end.kind == kind; });
  if (failed == 0) return "";
  return fmt::format("  {}{} of {} runs {}\n", curve.empty() ? "" : curve + ": ", failed, runs,
                     outcome);
}

/// Returns "matrix, 10: diverges_at 4.5, half_turns 2; diverged at 4.5 s".
std::string runLine(const StudyRow& row, const StudySettings& study) {
  std::vector<std::string> numbers;
  for (std::size_t i = 0; i < study.measures.size(); ++i) {
    const double value = row.measured[i];
    const std::string text = std::isnan(value)   ? "–"
                             : std::isinf(value) ? "not within " + roundedText(row.length, 4) + " s"
                                                 : roundedText(value, 4);
    const bool isError = study.measures[i] == Measure::Order;
    numbers.push_back(
        fmt::format("{} {}", isError ? "error_deg" : nameOf(study.measures[i]), text));
  }
  const std::string end = row.end.kind == RunEnd::Kind::Whole ? "" : "; " + row.end.text();
  return fmt::format("{}: {}{}", joined({row.curve, row.value}), joined(numbers), end);
}

std::string expectedJson(const study::StudyExpectation& expected) {
  return scene::boundsJson(expected.subject(), rowOf(expected.expectation.measure).meaning,
                           expected.expectation.bounds(), expected.measured);
}

std::string orderJson(const study::CurveOrder& order) {
  const study::OrderFit& fit = order.fit;
  const bool known = !std::isnan(fit.order);
  return JsonObject()
      .addString("curve", order.curve)
      .addNumber("order", fit.order)
      .addInteger("runs", fit.runs)
      .addNumber("shortest_h_s", known ? fit.shortest : fit.order)
      .addNumber("longest_h_s", known ? fit.longest : fit.order)
      .text();
}

std::string runJson(const StudyRow& row, const StudySettings& study) {
  JsonObject object;
  object.addString("value", row.value).addString("curve", row.curve);
  for (std::size_t i = 0; i < study.measures.size(); ++i) {
    if (study.measures[i] == Measure::Order) {
      object.addNumber("h_s", row.step)
          .addNumber("error_deg", row.measured[i])
          .addNumber("ns_per_step", row.nsPerStep);
    } else {
      object.addNumber(std::string(nameOf(study.measures[i])), row.measured[i]);
    }
  }
  return object.addString("status", row.end.text()).text();
}

}  // namespace

std::string studyJson(const StudiedScene& studied) {
  const StudySettings& study = *studied.scene.study;
  const study::Study result = studied.result.value_or(study::Study{});
  return resultOf("study")
      .addString("name", studied.scene.name)
      .addString("title", studied.scene.title)
      .addString("scene_xxh128", studied.checksum)
      .addString("x", study.x.key)
      .addString("curves", study.curves ? study.curves->key : "")
      .addBool("interrupted", studied.interrupted)
      .addStringOrNull("error", studied.error)
      .add("files", jsonArrayOf(studied.written, jsonString))
      .add("runs", jsonArrayOf(result.rows, [&](const auto& row) { return runJson(row, study); }))
      .add("orders", jsonArrayOf(result.orders, orderJson))
      .add("expectations", jsonArrayOf(expectedOf(result, study), expectedJson))
      .text();
}

bool reportStudy(const study::Study& result, const StudySettings& study, std::ostream& out) {
  for (const study::CurveOrder& order : result.orders) out << "  " << orderLine(order) << '\n';
  if (isOfOrdersAlone(study)) {
    for (const study::CurveOrder& order : result.orders) {
      for (const auto& [kind, outcome] : kFailures)
        out << failureLine(result, order.curve, kind, outcome);
    }
  } else {
    for (const StudyRow& row : result.rows) out << "  " << runLine(row, study) << '\n';
  }
  bool met = true;
  for (const study::StudyExpectation& one : expectedOf(result, study)) {
    out << "  " << reportLine(one.subject(), one.expectation.bounds(), one.measured) << '\n';
    met &= one.isMet();
  }
  return met;
}

}  // namespace rotatebook::cli
