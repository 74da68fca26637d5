// Studies as CSV tables.
#pragma once

#include <string>
#include <string_view>

#include "study/study.h"

namespace rotatebook::study {

/// Returns a header row and one row a run: the key, the key of the curves if there is one, each
/// measured quantity, status. An order has three columns: h_s, error_deg, ns_per_step. Numbers read
/// back to the same bits; the field of one that a run doesn't have is empty, and what never happens
/// has "inf".
std::string studyCsv(const Study& result, const scene::StudySettings& study);

/// Returns whether a table of runs with this header row is a study's.
bool isStudyHeader(std::string_view row);

}  // namespace rotatebook::study
