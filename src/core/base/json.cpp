#include "base/json.h"

#include <cmath>

#include "base/number_text.h"

namespace rotatebook {

Json roundedJson(double value, int digits) {
  return std::isfinite(value) ? Json::parse(roundedText(value, digits)) : Json();
}

std::string jsonText(const Json& json) {
  return json.dump(-1, ' ', /*ensure_ascii=*/false, Json::error_handler_t::replace);
}

std::string jsonLine(const Json& json) {
  return jsonText(json) + '\n';
}

bool isResultOf(std::string_view kind, std::string_view text) {
  std::string start = jsonText({{"result", kind}});
  start.pop_back();
  return text.starts_with(start);
}

}  // namespace rotatebook
