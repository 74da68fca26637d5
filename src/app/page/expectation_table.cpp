#include "page/expectation_table.h"

#include <algorithm>

#include "base/number_text.h"
#include "scene/expectation_text.h"

namespace rotatebook::page {
namespace {

constexpr std::string_view kTable = R"(<div class="scroll"><table class="checks">
<caption>{{caption}}</caption>
<thead><tr><th scope="col">{{"Quantity"}}</th><th scope="col">{{"Expected"}}</th><th scope="col">{{"Measured"}}</th><th scope="col">{{"Verdict"}}</th></tr></thead>
<tbody>
{{rows}}</tbody></table></div>
)";

constexpr std::string_view kRow =
    R"(<tr><th scope="row">{{subject}}{{meaning}}</th><td>{{expected}}</td><td>{{measured}}</td><td class="{{class}}">{{verdict}}</td></tr>
)";

constexpr std::string_view kBadge = R"(<p class="badge unmet">{{text}}</p>)";

constexpr std::string_view kFoldedTables = R"(<details class="expectations"{{open}}>
<summary><span class="badge {{class}}">{{text}}</span></summary>
{{tables}}</details>
)";

bool areAllMet(const std::vector<Check>& checks) {
  return std::ranges::all_of(checks, &Check::met);
}

/// Returns "4 of 5 expectations met".
Html countText(const std::vector<Check>& checks, const Language& say) {
  const auto met = std::to_string(std::ranges::count(checks, true, &Check::met));
  if (checks.size() == 1) return escaped(say("{met} of 1 expectation met", {{"met", met}}));
  return escaped(say("{met} of {all} expectations met",
                     {{"met", met}, {"all", std::to_string(checks.size())}}));
}

Html rowOf(const Check& check, const Language& say) {
  const Html meaning = check.meaning.empty() ? Html{}
                                             : filled(R"(<span class="meaning">{{text}}</span>)",
                                                      {{"text", escaped(check.meaning)}});
  return filled(kRow, {{"subject", escaped(check.subject)},
                       {"meaning", meaning},
                       {"expected", escaped(check.expected)},
                       {"measured", escaped(check.measured)},
                       {"class", {check.met ? "met" : "unmet"}},
                       {"verdict", escaped(check.met ? say("✓ met") : say("✗ not met"))}});
}

}  // namespace

Check checkOf(const std::string& subject, const scene::Bounds& bounds, double measured,
              const std::string& meaning, const Language& say) {
  const scene::Expectation expectation{.min = bounds.min, .max = bounds.max};
  return {subject, say.numbers(expectedText(expectation, say)),
          say.numbers(measuredText(measured, expectation, kCheckDigits, say)),
          bounds.hold(measured), say(meaning)};
}

Check checkOf(const scene::ExpectationResult& result, const Language& say) {
  const scene::Expectation& expectation = result.expectation;
  return {std::string(nameOf(expectation.measure)) + say.numbers(windowText(expectation, say)),
          say.numbers(expectedText(expectation, say)),
          say.numbers(measuredText(result, kCheckDigits, say)), result.met,
          say(rowOf(expectation.measure).meaning)};
}

Check unexpectedDivergence(double time, const Language& say) {
  return {"diverges_at", say("no divergence"), say.numbers(roundedText(time, kCheckDigits)) + " s",
          false, say(rowOf(scene::Measure::DivergesAt).meaning)};
}

Html checksTable(const std::string& caption, const std::vector<Check>& checks,
                 const Language& say) {
  if (checks.empty()) return {};
  Html rows;
  for (const Check& check : checks) rows += rowOf(check, say);
  return filled(kTable, {{"caption", escaped(caption)}, {"rows", rows}}, say);
}

Html unmetBadge(const std::vector<Check>& checks, const Language& say) {
  return areAllMet(checks) ? Html{} : filled(kBadge, {{"text", countText(checks, say)}});
}

Html foldedChecks(const std::vector<Check>& checks, const Html& tables, const Language& say) {
  if (checks.empty()) return {};
  const bool met = areAllMet(checks);
  return filled(kFoldedTables, {{"open", {met ? "" : " open"}},
                                {"class", {met ? "met" : "unmet"}},
                                {"text", countText(checks, say)},
                                {"tables", tables}});
}

}  // namespace rotatebook::page
