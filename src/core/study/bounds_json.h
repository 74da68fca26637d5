// Expectations on studies and maps as JSON.
#pragma once

#include <string>
#include <string_view>

#include "base/json.h"
#include "scene/expectation.h"

namespace rotatebook::study {

/// Returns one number that bounds apply to as a JSON object: {"quantity": `subject`, "meaning",
/// "min", "max", "measured", "met"}; infinity is "inf", NaN null.
Json boundsJson(const std::string& subject, std::string_view meaning, const scene::Bounds& bounds,
                double measured);

}  // namespace rotatebook::study
