// Conversion of text to HTML, and filling of templates.
#pragma once

#include <map>
#include <string>
#include <string_view>

#include "page/language.h"

namespace rotatebook::page {

/// A piece of HTML. Text becomes HTML by escaped() or addressOf() alone, so that no scene's text is
/// ever read as markup.
struct Html {
  std::string text;

  Html& operator+=(const Html& other) {
    text += other.text;
    return *this;
  }
};

/// Escapes `text` for use as content or as the value of a quoted attribute.
Html escaped(std::string_view text);

/// Converts `path`, with '/' between its parts, to a relative address for a quoted attribute.
Html addressOf(const std::string& path);

/// Returns the template `text` with each {{name}} replaced by its value, and each {{"words"}} by
/// these in the language: `keys` and *emphasis* are marked up, a {name} is a value. Throws
/// std::logic_error if the names of `text` and `values` differ.
Html filled(std::string_view text, const std::map<std::string, Html>& values,
            const Language& say = {});

}  // namespace rotatebook::page
