// Recordings that a page reads or makes. Inside the room only.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/json.h"

namespace rotatebook::bridge {

/// Returns the numbers of rb_flight().
std::vector<double> flightNumbers(const double* readings, std::int32_t count);
/// Returns the JSON of rb_recording(). Throws InputError, beginning with `name`, for what is none.
Json recordingJson(std::string_view bytes, const std::string& name);

}  // namespace rotatebook::bridge
