#include "study/study_csv.h"

#include <cmath>

#include "base/number_text.h"
#include "base/text.h"

namespace rotatebook::study {
namespace {

constexpr const char* kStatusColumn = ",status";

// Returns a number as a field after others; empty for NaN.
std::string field(double value) {
  return "," + (std::isnan(value) ? "" : shortestText(value));
}

// Rounds to tenths of a nanosecond, finer than any measurement. NaN stays NaN.
double roundedToTenths(double nanoseconds) {
  return std::round(nanoseconds * 10) / 10;
}

std::string columnsOf(scene::Measure measure) {
  if (measure == scene::Measure::Order) return ",h_s,error_deg,ns_per_step";
  return "," + std::string(scene::nameOf(measure));
}

std::string fieldsOf(const StudyRow& row, std::size_t place, scene::Measure measure) {
  const std::string value = field(row.measured[place]);
  if (measure != scene::Measure::Order) return value;
  return field(row.step) + value + field(roundedToTenths(row.nsPerStep));
}

}  // namespace

bool isStudyHeader(std::string_view row) {
  return row.ends_with(kStatusColumn);
}

std::string studyCsv(const Study& result, const scene::StudySettings& study) {
  std::string text = study.x.key;
  if (study.curves) text += "," + study.curves->key;
  for (const scene::Measure measure : study.measures) text += columnsOf(measure);
  text += std::string(kStatusColumn) + "\n";
  for (const StudyRow& row : result.rows) {
    text += csvField(row.value);
    if (study.curves) text += "," + csvField(row.curve);
    for (std::size_t i = 0; i < study.measures.size(); ++i)
      text += fieldsOf(row, i, study.measures[i]);
    text += "," + row.end.text() + "\n";
  }
  return text;
}

}  // namespace rotatebook::study
