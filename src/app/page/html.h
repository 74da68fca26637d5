// Text into HTML, and HTML into templates. Inside the room only.
#pragma once

#include <map>
#include <string>
#include <string_view>

namespace rotatebook::page {

/// A piece of HTML. Text becomes one through escaped() or filled(), so that no scene's words are
/// ever read as markup.
struct Html {
  std::string text;

  Html& operator+=(const Html& other) {
    text += other.text;
    return *this;
  }
};

/// `text` as content or as the value of a quoted attribute.
Html escaped(std::string_view text);

/// `path`, with '/' between its parts, as a relative address in a quoted attribute.
Html addressOf(const std::string& path);

/// A template with each {{name}} replaced by that value. Throws std::logic_error if the two don't
/// have the same names.
Html filled(std::string_view text, const std::map<std::string, Html>& values);

}  // namespace rotatebook::page
