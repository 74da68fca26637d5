#include "page/html.h"

#include <cctype>
#include <set>
#include <stdexcept>

#include <fmt/core.h>

namespace rotatebook::page {
namespace {

constexpr std::string_view kOpen = "{{";
constexpr std::string_view kClose = "}}";

const char* entityOf(char letter) {
  switch (letter) {
    case '&':
      return "&amp;";
    case '<':
      return "&lt;";
    case '>':
      return "&gt;";
    case '"':
      return "&quot;";
    case '\'':
      return "&#39;";
    default:
      return nullptr;
  }
}

bool isPlainInAddresses(char letter) {
  return std::isalnum(static_cast<unsigned char>(letter)) != 0 ||
         std::string_view("-._~/").find(letter) != std::string_view::npos;
}

/// Returns text with <tag> around what is between two `mark`s.
std::string markedUp(std::string_view text, char mark, const std::string& tag) {
  std::string html;
  bool isOpen = false;
  for (const char letter : text) {
    if (letter == mark) isOpen = !isOpen;
    html += letter != mark ? std::string(1, letter) : (isOpen ? "<" : "</") + tag + ">";
  }
  return html;
}

/// Returns the words of a template, with quotation marks around them, in the language.
Html wordsIn(const std::string& quoted, const std::map<std::string, Html>& values,
             const Language& say, std::set<std::string>& used) {
  const std::string english = quoted.substr(1, quoted.size() - 2);
  std::vector<NamedText> texts;
  for (const auto& [name, html] : values) {
    if (english.find("{" + name + "}") == english.npos) continue;
    texts.emplace_back(name, html.text);
    used.insert(name);
  }
  const std::string text = escaped(say(english)).text;
  return {filledIn(markedUp(markedUp(text, '`', "kbd"), '*', "em"), texts)};
}

}  // namespace

Html escaped(std::string_view text) {
  Html html;
  for (const char letter : text) {
    if (const char* entity = entityOf(letter)) {
      html.text += entity;
    } else {
      html.text += letter;
    }
  }
  return html;
}

Html addressOf(const std::string& path) {
  Html html;
  for (const char letter : path) {
    html.text += isPlainInAddresses(letter)
                     ? std::string(1, letter)
                     : fmt::format("%{:02X}", static_cast<unsigned char>(letter));
  }
  return html;
}

Html filled(std::string_view text, const std::map<std::string, Html>& values, const Language& say) {
  Html html;
  std::set<std::string> used;
  std::size_t at = 0;
  for (std::size_t open = text.find(kOpen); open != std::string_view::npos;
       open = text.find(kOpen, at)) {
    const std::size_t close = text.find(kClose, open);
    if (close == std::string_view::npos) throw std::logic_error("a template's {{ is left open");
    const std::string name(text.substr(open + kOpen.size(), close - open - kOpen.size()));
    html.text += text.substr(at, open - at);
    at = close + kClose.size();
    if (name.starts_with('"')) {
      html += wordsIn(name, values, say, used);
      continue;
    }
    if (!values.contains(name))
      throw std::logic_error("a template's {{" + name + "}} has no value");
    html += values.at(name);
    used.insert(name);
  }
  html.text += text.substr(at);
  if (used.size() != values.size()) throw std::logic_error("a template doesn't use all its values");
  return html;
}

}  // namespace rotatebook::page
