#include "report/study_report.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <type_traits>

#include "base/json.h"
#include "base/number_text.h"
#include "base/text.h"
#include "report/expectation_report.h"
#include "report/formatted.h"
#include "scene/names.h"

namespace rotatebook::report {
namespace {

using study::PrecisionRow;
using study::RunEnd;

std::string name(physics::Integrator integrator) {
  return std::string(scene::nameOf(scene::kIntegrators, integrator));
}

std::string orderLine(const study::IntegratorOrder& order) {
  const study::OrderFit& fit = order.fit;
  std::string line = formatted("%-16s ", name(order.integrator).c_str());
  if (std::isnan(fit.order)) {
    return line + "no order: " + std::to_string(fit.runs) + " usable runs, " +
           std::to_string(study::kMinRuns) + " needed";
  }
  return line + formatted("order %5.2f from %2d runs, steps of %.3g to %.3g s", fit.order, fit.runs,
                          fit.shortest, fit.longest);
}

/// Returns "euler: 3 of 11 runs diverged"; empty if no run ended like that.
std::string failureLine(const study::PrecisionStudy& result, physics::Integrator integrator,
                        RunEnd::Kind kind, const char* outcome) {
  const auto runs = std::ranges::count(result.rows, integrator, &PrecisionRow::integrator);
  const auto failed = std::ranges::count_if(result.rows, [&](const PrecisionRow& row) {
    return row.integrator == integrator && row.end.kind == kind;
  });
  if (failed == 0) return "";
  return "  " + name(integrator) + ": " + std::to_string(failed) + " of " + std::to_string(runs) +
         " runs " + outcome + "\n";
}

double orderOf(const study::PrecisionStudy& result, physics::Integrator integrator) {
  const auto found =
      std::ranges::find(result.orders, integrator, &study::IntegratorOrder::integrator);
  return found->fit.order;
}

std::string tiltLine(const study::TiltRow& row) {
  const std::string start = formatted("tilt %-7.3g ", row.tilt);
  if (row.end.kind != RunEnd::Kind::Whole) return start + row.end.text();
  return start + formatted("%3d flips, one every %.5g s; the law says %.5g s", row.flips,
                           row.interval, row.law);
}

/// A number that is expected of a study.
struct Expected {
  std::string quantity;
  std::string integrator;  ///< Empty but in a study of integrators.
  std::string meaning;     ///< Of the quantity, in plain words.
  scene::Bounds bounds;
  double measured = 0;
};

std::vector<Expected> expectedOf(const study::PrecisionStudy& result,
                                 const scene::StudySettings& study) {
  std::vector<Expected> all;
  for (const auto& [integrator, bounds] : study.orders) {
    all.push_back({"order", name(integrator), "power of the step by which the error shrinks",
                   bounds, orderOf(result, integrator)});
  }
  return all;
}

std::vector<Expected> expectedOf(const study::TiltStudy& result,
                                 const scene::StudySettings& study) {
  if (!study.flipLaw) return {};
  return {{"flip_law", "",
           "largest deviation from the interval that the law gives, as a share of it",
           *study.flipLaw, result.greatestDeviation()}};
}

std::vector<Expected> expectedOf(const study::SweepStudy& result,
                                 const scene::StudySettings& study) {
  std::vector<Expected> all;
  for (const study::ExpectedOfRun& one : study::expectedOf(result, *study.sweep)) {
    all.push_back({one.subject(), "", std::string(rowOf(one.expectation.measure).meaning),
                   one.expectation.bounds(), one.measured});
  }
  return all;
}

/// Returns "matrix, 10: diverges_at 4.5, half_turns 2; diverged at 4.5 s".
std::string sweepLine(const study::SweepRow& row, const scene::Sweep& sweep) {
  std::vector<std::string> numbers;
  for (std::size_t i = 0; i < sweep.measures.size(); ++i) {
    const double value = row.measured[i];
    const std::string text = std::isnan(value)   ? "–"
                             : std::isinf(value) ? "not within " + roundedText(row.length, 4) + " s"
                                                 : roundedText(value, 4);
    numbers.push_back(std::string(scene::nameOf(sweep.measures[i])) + " " + text);
  }
  const std::string end = row.end.kind == RunEnd::Kind::Whole ? "" : "; " + row.end.text();
  return joined({row.curve, row.value}) + ": " + joined(numbers) + end;
}

/// Prints a line for each; returns whether all are met.
bool reportExpected(const std::vector<Expected>& all, std::ostream& out) {
  bool met = true;
  for (const auto& [quantity, integrator, meaning, bounds, measured] : all) {
    const std::string subject = integrator.empty() ? quantity : quantity + " of " + integrator;
    out << "  " << reportLine(subject, bounds, measured) << '\n';
    met &= bounds.hold(measured);
  }
  return met;
}

std::string expectedJson(const Expected& expected) {
  JsonObject object;
  object.addString("quantity", expected.quantity)
      .addStringOrNull("integrator", expected.integrator)
      .addString("meaning", expected.meaning)
      .addNumberOrNull("min", expected.bounds.min)
      .addNumberOrNull("max", expected.bounds.max);
  if (std::isinf(expected.measured))
    object.addString("measured", "inf");
  else
    object.addNumber("measured", expected.measured);
  return object.addBool("met", expected.bounds.hold(expected.measured)).text();
}

std::string orderJson(const study::IntegratorOrder& order) {
  const study::OrderFit& fit = order.fit;
  const bool known = !std::isnan(fit.order);
  return JsonObject()
      .addString("integrator", name(order.integrator))
      .addNumber("order", fit.order)
      .addInteger("runs", fit.runs)
      .addNumber("shortest_h_s", known ? fit.shortest : fit.order)
      .addNumber("longest_h_s", known ? fit.longest : fit.order)
      .text();
}

std::string tiltJson(const study::TiltRow& row) {
  return JsonObject()
      .addNumber("tilt_rad", row.tilt)
      .addInteger("flips", row.flips)
      .addNumber("interval_s", row.interval)
      .addNumber("law_s", row.law)
      .addNumber("ratio", row.ratio())
      .text();
}

std::string failureJson(const PrecisionRow& row) {
  return JsonObject()
      .addString("integrator", name(row.integrator))
      .addNumber("h_s", row.h)
      .addString("status", row.end.text())
      .text();
}

std::string failureJson(const study::TiltRow& row) {
  return JsonObject().addNumber("tilt_rad", row.tilt).addString("status", row.end.text()).text();
}

std::string failureJson(const study::SweepRow& row) {
  return JsonObject()
      .addString("value", row.value)
      .addString("curve", row.curve)
      .addString("status", row.end.text())
      .text();
}

std::string sweepJson(const study::SweepRow& row, const scene::Sweep& sweep) {
  JsonObject object;
  object.addString("value", row.value).addString("curve", row.curve);
  for (std::size_t i = 0; i < sweep.measures.size(); ++i) {
    object.addNumber(std::string(scene::nameOf(sweep.measures[i])), row.measured[i]);
  }
  return object.text();
}

template <typename Row>
std::string failuresJson(const std::vector<Row>& rows) {
  std::vector<std::string> failures;
  for (const Row& row : rows) {
    if (row.end.kind != RunEnd::Kind::Whole) failures.push_back(failureJson(row));
  }
  return jsonArray(failures);
}

template <typename Study>
void addStudy(const Study& result, const scene::StudySettings& study, JsonObject& object) {
  std::string orders = "[]", tilts = "[]", sweep = "[]";
  if constexpr (std::is_same_v<Study, study::PrecisionStudy>) {
    orders = jsonArrayOf(result.orders, orderJson);
  } else if constexpr (std::is_same_v<Study, study::TiltStudy>) {
    tilts = jsonArrayOf(result.rows, tiltJson);
  } else {
    sweep = jsonArrayOf(result.rows,
                        [&](const study::SweepRow& row) { return sweepJson(row, *study.sweep); });
  }
  object.addInteger("runs", static_cast<std::int64_t>(result.rows.size()))
      .add("failures", failuresJson(result.rows))
      .add("orders", orders)
      .add("tilts", tilts)
      .add("sweep", sweep)
      .add("expectations", jsonArrayOf(expectedOf(result, study), expectedJson));
}

std::string kindOf(const scene::StudySettings& study) {
  if (study.sweep) return "sweep";
  return study.isOfTilts() ? "tilts" : "integrators";
}

}  // namespace

std::string studyJson(const StudiedScene& studied) {
  JsonObject object;
  object.addString("name", studied.scene.name)
      .addString("title", studied.scene.title)
      .addString("scene_xxh128", studied.checksum)
      .addString("kind", kindOf(studied.study))
      .addBool("interrupted", studied.interrupted)
      .addStringOrNull("error", studied.error)
      .add("files", jsonArrayOf(studied.files, jsonString));
  if (const auto* result = std::get_if<study::TiltStudy>(&studied.result)) {
    addStudy(*result, studied.study, object);
  } else if (const auto* sweep = std::get_if<study::SweepStudy>(&studied.result)) {
    addStudy(*sweep, studied.study, object);
  } else if (const auto* other = std::get_if<study::PrecisionStudy>(&studied.result)) {
    addStudy(*other, studied.study, object);
  } else {
    addStudy(study::PrecisionStudy(), scene::StudySettings(), object);
  }
  return object.text();
}

bool reportStudy(const study::PrecisionStudy& result, const scene::StudySettings& study,
                 std::ostream& out) {
  for (const study::IntegratorOrder& order : result.orders) out << "  " << orderLine(order) << '\n';
  for (const study::IntegratorOrder& order : result.orders) {
    out << failureLine(result, order.integrator, RunEnd::Kind::Diverged, "diverged")
        << failureLine(result, order.integrator, RunEnd::Kind::NoConvergence,
                       "found no solution for their steps")
        << failureLine(result, order.integrator, RunEnd::Kind::StepTooLong,
                       "had steps too long for their series");
  }
  return reportExpected(expectedOf(result, study), out);
}

bool reportStudy(const study::TiltStudy& result, const scene::StudySettings& study,
                 std::ostream& out) {
  for (const study::TiltRow& row : result.rows) out << "  " << tiltLine(row) << '\n';
  return reportExpected(expectedOf(result, study), out);
}

bool reportStudy(const study::SweepStudy& result, const scene::StudySettings& study,
                 std::ostream& out) {
  for (const study::SweepRow& row : result.rows) {
    out << "  " << sweepLine(row, *study.sweep) << '\n';
  }
  return reportExpected(expectedOf(result, study), out);
}

void reportStudiesAsJson(const std::vector<StudiedScene>& studies, bool interrupted,
                         std::ostream& out) {
  out << JsonObject()
             .addBool("interrupted", interrupted)
             .add("studies", jsonArrayOf(studies, studyJson))
             .text()
      << '\n';
}

}  // namespace rotatebook::report
