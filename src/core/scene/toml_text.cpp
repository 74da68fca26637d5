#include "scene/toml_text.h"

#include "base/number_text.h"
#include "base/text.h"

namespace rotatebook::scene {

std::string tomlString(std::string_view text) {
  return quotedText(text);
}

std::string tomlNumber(double value) {
  const std::string text = shortestText(value);
  const bool looksWhole = text.find_first_not_of("-0123456789") == std::string::npos;
  return looksWhole ? text + ".0" : text;
}

}  // namespace rotatebook::scene
