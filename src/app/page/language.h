// The language of the page.
#pragma once

#include <initializer_list>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "base/text.h"
#include "scene/scene.h"

namespace rotatebook::page {

/// A language as a list of words: assets/words/german.toml, or a file of the same form. The list
/// has texts by their English; what it lacks is English.
struct Language {
  std::string tag = "en";                          ///< Of BCP 47, for browsers.
  std::optional<scene::Words> ofPictures{};        ///< None in English: the scenes' own.
  std::map<std::string, std::string> texts{};      ///< All of the list, by their English.
  std::map<std::string, std::string> ofScripts{};  ///< The part that scripts say.

  /// Returns a text in this language, whatever its spaces are, with each value in the place of its
  /// "{name}".
  std::string operator()(std::string_view english, const std::vector<NamedText>& values = {}) const;
  /// Returns a text with the decimal mark in its numbers.
  std::string numbers(std::string text) const;
};

/// Returns the language that is called so, "english" or "german", or of the list in a file. Throws
/// InputError.
Language readLanguage(const std::string& nameOrFile);

/// Returns the scene as the page tells of it, for its texts alone: title, caption, captions in
/// time, labels and words in the language.
scene::Scene inLanguage(scene::Scene scene, const Language& language);

}  // namespace rotatebook::page
