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

Html filled(std::string_view text, const std::map<std::string, Html>& values) {
  Html html;
  std::set<std::string> used;
  std::size_t at = 0;
  for (std::size_t open = text.find(kOpen); open != std::string_view::npos;
       open = text.find(kOpen, at)) {
    const std::size_t close = text.find(kClose, open);
    if (close == std::string_view::npos) throw std::logic_error("a template's {{ is left open");
    const std::string name(text.substr(open + kOpen.size(), close - open - kOpen.size()));
    if (!values.contains(name))
      throw std::logic_error("a template's {{" + name + "}} has no value");
    html.text += text.substr(at, open - at);
    html += values.at(name);
    used.insert(name);
    at = close + kClose.size();
  }
  html.text += text.substr(at);
  if (used.size() != values.size()) throw std::logic_error("a template doesn't use all its values");
  return html;
}

}  // namespace rotatebook::page
