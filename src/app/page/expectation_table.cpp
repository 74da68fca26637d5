#include "page/expectation_table.h"

#include <algorithm>

#include <fmt/core.h>

#include "base/number_text.h"
#include "scene/expectation_text.h"

namespace rotatebook::page {
namespace {

constexpr std::string_view kTable = R"(<div class="scroll"><table class="checks">
<caption>{{caption}}</caption>
<thead><tr><th scope="col">Quantity</th><th scope="col">Expected</th><th scope="col">Measured</th><th scope="col">Verdict</th></tr></thead>
<tbody>
{{rows}}</tbody></table></div>
)";

constexpr std::string_view kRow =
    R"(<tr><th scope="row">{{subject}}{{meaning}}</th><td>{{expected}}</td><td>{{measured}}</td><td class="{{class}}">{{verdict}}</td></tr>
)";

constexpr std::string_view kBadge = R"(<p class="badge unmet">{{text}}</p>)";

constexpr std::string_view kFolded = R"(<details class="expectations"{{open}}>
<summary><span class="badge {{class}}">{{text}}</span></summary>
{{tables}}</details>
)";

bool areAllMet(const std::vector<Check>& checks) {
  return std::ranges::all_of(checks, &Check::met);
}

/// Returns "4 of 5 expectations met".
Html countText(const std::vector<Check>& checks) {
  const auto met = std::ranges::count(checks, true, &Check::met);
  return escaped(
      fmt::format("{} of {} expectation{} met", met, checks.size(), checks.size() == 1 ? "" : "s"));
}

Html rowOf(const Check& check) {
  const Html meaning = check.meaning.empty() ? Html{}
                                             : filled(R"(<span class="meaning">{{text}}</span>)",
                                                      {{"text", escaped(check.meaning)}});
  return filled(kRow, {{"subject", escaped(check.subject)},
                       {"meaning", meaning},
                       {"expected", escaped(check.expected)},
                       {"measured", escaped(check.measured)},
                       {"class", {check.met ? "met" : "unmet"}},
                       {"verdict", {check.met ? "✓ met" : "✗ not met"}}});
}

}  // namespace

Check checkOf(const std::string& subject, const scene::Bounds& bounds, double measured,
              const std::string& meaning) {
  const scene::Expectation expectation{.min = bounds.min, .max = bounds.max};
  return {subject, expectedText(expectation), measuredText(measured, expectation, kCheckDigits),
          bounds.hold(measured), meaning};
}

Check checkOf(const scene::ExpectationResult& result) {
  const scene::Expectation& expectation = result.expectation;
  return {std::string(nameOf(expectation.measure)) + windowText(expectation),
          expectedText(expectation), measuredText(result, kCheckDigits), result.met,
          std::string(rowOf(expectation.measure).meaning)};
}

Check unexpectedDivergence(double time) {
  return {"diverges_at", "no divergence", roundedText(time, kCheckDigits) + " s", false,
          std::string(rowOf(scene::Measure::DivergesAt).meaning)};
}

Html checksTable(const std::string& caption, const std::vector<Check>& checks) {
  if (checks.empty()) return {};
  Html rows;
  for (const Check& check : checks) rows += rowOf(check);
  return filled(kTable, {{"caption", escaped(caption)}, {"rows", rows}});
}

Html unmetBadge(const std::vector<Check>& checks) {
  return areAllMet(checks) ? Html{} : filled(kBadge, {{"text", countText(checks)}});
}

Html foldedChecks(const std::vector<Check>& checks, const Html& tables) {
  if (checks.empty()) return {};
  const bool met = areAllMet(checks);
  return filled(kFolded, {{"open", {met ? "" : " open"}},
                          {"class", {met ? "met" : "unmet"}},
                          {"text", countText(checks)},
                          {"tables", tables}});
}

}  // namespace rotatebook::page
