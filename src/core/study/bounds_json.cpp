#include "study/bounds_json.h"

#include <cmath>

namespace rotatebook::study {

Json boundsJson(const std::string& subject, std::string_view meaning, const scene::Bounds& bounds,
                double measured) {
  return {{"quantity", subject},
          {"meaning", meaning},
          {"min", orNull(bounds.min)},
          {"max", orNull(bounds.max)},
          {"measured", std::isinf(measured) ? Json("inf") : Json(measured)},
          {"met", bounds.hold(measured)}};
}

}  // namespace rotatebook::study
