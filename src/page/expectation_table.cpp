#include "page/expectation_table.h"

#include <algorithm>

#include "base/number_text.h"
#include "physics/expectation_text.h"

namespace rotatebook::page {
namespace {

constexpr std::string_view kTable = R"(<div class="scroll"><table class="checks">
<caption>{{caption}}</caption>
<thead><tr><th scope="col">Quantity</th><th scope="col">Expected</th><th scope="col">Measured</th><th scope="col"></th></tr></thead>
<tbody>
{{rows}}</tbody></table></div>
)";

constexpr std::string_view kRow =
    R"(<tr><th scope="row">{{subject}}</th><td>{{expected}}</td><td>{{measured}}</td><td class="{{class}}">{{verdict}}</td></tr>
)";

constexpr std::string_view kBadge = R"(<p class="badge {{class}}">{{words}}</p>)";

Html rowOf(const Check& check) {
  return filled(kRow, {{"subject", escaped(check.subject)},
                       {"expected", escaped(check.expected)},
                       {"measured", escaped(check.measured)},
                       {"class", {check.met ? "met" : "unmet"}},
                       {"verdict", {check.met ? "✓ met" : "✗ unmet"}}});
}

}  // namespace

std::vector<Check> checksOf(const Motion& motion) {
  std::vector<Check> checks;
  if (divergesUnexpectedly(motion.trajectory, motion.panel.expectations)) {
    checks.push_back({"diverges_at", "no divergence",
                      roundedText(*motion.trajectory.divergedAt, kCheckDigits) + " s", false});
  }
  for (const physics::ExpectationResult& result :
       check(motion.trajectory, motion.panel.expectations)) {
    checks.push_back(
        {std::string(nameOf(result.expectation.quantity)) + windowText(result.expectation),
         expectedText(result.expectation), measuredText(result, kCheckDigits), result.met});
  }
  return checks;
}

Html checksTable(const std::string& caption, const std::vector<Check>& checks) {
  Html rows;
  for (const Check& check : checks) rows += rowOf(check);
  if (checks.empty()) rows.text = "<tr><td colspan=\"4\">nothing is expected</td></tr>\n";
  return filled(kTable, {{"caption", escaped(caption)}, {"rows", rows}});
}

Html badgeOf(const std::vector<Check>& checks) {
  if (checks.empty()) return {};
  const auto met = std::ranges::count(checks, true, &Check::met);
  const auto all = static_cast<std::ptrdiff_t>(checks.size());
  return filled(kBadge, {{"class", {met == all ? "met" : "unmet"}},
                         {"words", escaped(std::to_string(met) + " of " + std::to_string(all) +
                                           " expectations met")}});
}

}  // namespace rotatebook::page
