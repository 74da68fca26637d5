#include "report/map_report.h"

#include <algorithm>

#include "base/json.h"
#include "base/number_text.h"
#include "base/text.h"
#include "report/expectation_report.h"

namespace rotatebook::report {
namespace {

std::string countText(std::int64_t count, const char* what) {
  return count > 0 ? std::to_string(count) + " " + what : "";
}

std::string factsLine(const study::MapFacts& facts) {
  constexpr int kDigits = 4;
  const std::string values = facts.withValue() == 0
                                 ? "no run has a value"
                                 : "values from " + roundedText(facts.smallest, kDigits) + " to " +
                                       roundedText(facts.largest, kDigits) + ", mean " +
                                       roundedText(facts.mean, kDigits);
  return std::to_string(facts.runs) + " runs: " +
         joined({values, countText(facts.never, "never"), countText(facts.diverged, "diverged"),
                 countText(facts.refused, "refused")});
}

std::string valueText(double value) {
  constexpr int kDigits = 5;
  switch (study::outcomeOf(value)) {
    case scene::Outcome::Value:
      break;
    case scene::Outcome::Never:
      return "never";
    case scene::Outcome::Diverged:
      return "diverged";
    case scene::Outcome::Refused:
      return "refused";
  }
  return roundedText(value, kDigits);
}

std::string factsJson(const study::MapFacts& facts) {
  return JsonObject()
      .addInteger("runs", facts.runs)
      .addInteger("never", facts.never)
      .addInteger("diverged", facts.diverged)
      .addInteger("refused", facts.refused)
      .addNumber("smallest", facts.smallest)
      .addNumber("largest", facts.largest)
      .addNumber("mean", facts.mean)
      .text();
}

std::string expectedJson(const study::ExpectedOfMap& expected) {
  return JsonObject()
      .addString("quantity", expected.subject())
      .addNumberOrNull("min", expected.expectation.bounds.min)
      .addNumberOrNull("max", expected.expectation.bounds.max)
      .addNumber("measured", expected.measured)
      .addBool("met", expected.isMet())
      .text();
}

std::string mapJson(const MappedScene& mapped) {
  return JsonObject()
      .addString("name", mapped.scene.name)
      .addString("title", mapped.scene.title)
      .addBool("interrupted", mapped.interrupted)
      .addStringOrNull("error", mapped.error)
      .add("files", jsonArrayOf(mapped.files, jsonString))
      .add("facts", mapped.facts ? factsJson(*mapped.facts) : "null")
      .add("expectations", jsonArrayOf(mapped.expected, expectedJson))
      .text();
}

}  // namespace

bool MappedScene::isMet() const {
  return std::ranges::all_of(expected, &study::ExpectedOfMap::isMet);
}

void reportMap(const MappedScene& mapped, std::ostream& out) {
  if (mapped.facts) out << "  " << factsLine(*mapped.facts) << '\n';
  for (const study::MarkedValue& marked : mapped.marks) {
    out << "  " << marked.mark.label << " at [" << shortestText(marked.mark.x) << ", "
        << shortestText(marked.mark.y) << "]: " << joinedOf(marked.values, valueText) << '\n';
  }
  for (const study::ExpectedOfMap& one : mapped.expected) {
    out << "  " << reportLine(one.subject(), one.expectation.bounds, one.measured) << '\n';
  }
}

void reportMapsAsJson(const std::vector<MappedScene>& maps, bool interrupted, std::ostream& out) {
  out << JsonObject()
             .addBool("interrupted", interrupted)
             .add("maps", jsonArrayOf(maps, mapJson))
             .text()
      << '\n';
}

}  // namespace rotatebook::report
