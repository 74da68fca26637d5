#include "page/language.h"

#include <algorithm>
#include <cctype>
#include <filesystem>

#include <fmt/core.h>

#include "base/document/toml_tree.h"
#include "base/document/value_reader.h"
#include "base/error.h"
#include "base/nearest_name.h"
#include "embedded/page.h"
#include "system/read_file.h"

namespace rotatebook::page {
namespace {

using document::TomlNode;
using document::ValueReader;

constexpr std::size_t kLongestTag = 35;
constexpr std::size_t kLongestText = 2000;

/// Returns a text with plain spaces for those that don't break lines, which nobody can tell apart
/// in a list.
std::string withPlainSpaces(std::string_view text) {
  constexpr std::string_view kNoBreak = "\u00a0";
  std::string plain(text);
  for (std::size_t at = plain.find(kNoBreak); at != plain.npos; at = plain.find(kNoBreak, at))
    plain.replace(at, kNoBreak.size(), " ");
  return plain;
}

/// Adds the texts of a table of the list.
void addTexts(const ValueReader& table, std::map<std::string, std::string>& texts) {
  const auto* entries = std::get_if<TomlNode::Table>(&table.node().value);
  if (entries == nullptr) table.mismatch("a table of texts by their English");
  for (const auto& [english, location, node] : *entries) {
    texts[withPlainSpaces(english)] =
        ValueReader(node, table.name() + "." + quotedText(english)).lines(kLongestText);
  }
}

std::string tagFrom(const ValueReader& value) {
  std::string tag = value.text(kLongestTag);
  const auto isPlain = [](char letter) {
    return std::isalnum(static_cast<unsigned char>(letter)) != 0 || letter == '-';
  };
  if (!tag.empty() && std::ranges::all_of(tag, isPlain)) return tag;
  value.mismatch("a language's tag such as \"fr\"");
}

Language languageIn(std::string_view toml, const std::string& file) {
  const TomlNode tree = document::parseToml(toml, file, document::kLongestWords);
  const ValueReader list(tree, "");
  Language language;
  language.ofPictures = scene::readWords(list);
  const auto tag = list.find("language");
  if (!tag)
    throw InputError(file + ": the list of words has no language, such as language = \"fr\"");
  language.tag = tagFrom(*tag);
  for (std::size_t i = 0; i < scene::kEnglishWords.size(); ++i)
    language.ofScripts[std::string(scene::kEnglishWords[i])] = language.ofPictures->texts[i];
  language.ofScripts["decimal_mark"] = language.ofPictures->decimalMark;
  if (const auto page = list.find("page")) addTexts(*page, language.ofScripts);
  language.texts = language.ofScripts;
  for (const char* key : {"story", "figures"}) {
    if (const auto table = list.find(key)) addTexts(*table, language.texts);
  }
  return language;
}

}  // namespace

std::string Language::operator()(std::string_view english,
                                 const std::vector<NamedText>& values) const {
  const auto found = texts.find(withPlainSpaces(english));
  return filledIn(found == texts.end() ? english : std::string_view(found->second), values);
}

std::string Language::numbers(std::string text) const {
  if (!ofPictures || ofPictures->decimalMark == ".") return text;
  const auto isDigit = [&](std::size_t at) {
    return at < text.size() && std::isdigit(static_cast<unsigned char>(text[at])) != 0;
  };
  for (std::size_t at = text.find('.'); at != text.npos; at = text.find('.', at + 1)) {
    if (at > 0 && isDigit(at - 1) && isDigit(at + 1)) text.replace(at, 1, ofPictures->decimalMark);
  }
  return text;
}

Language readLanguage(const std::string& nameOrFile) {
  if (nameOrFile == scene::kLanguages[0]) return {};
  if (nameOrFile == scene::kLanguages[1]) return languageIn(germanList(), "german.toml");
  if (nameOrFile.find('.') != nameOrFile.npos)
    return languageIn(system::readInput(nameOrFile, document::kLongestWords), nameOrFile);
  throw InputError("--language must be english, german or the file of a list of words, not " +
                   oneLine(nameOrFile) + didYouMean(nameOrFile, scene::kLanguages));
}

scene::Scene inLanguage(scene::Scene scene, const Language& language) {
  scene.title = language(scene.title);
  scene.caption = language(scene.caption);
  for (scene::Cue& cue : scene.cues) {
    if (cue.text) cue.text = language(*cue.text);
    cue.chapter = language(cue.chapter);
  }
  for (scene::Panel& motion : scene.motions) motion.label = language(motion.label);
  if (language.ofPictures) scene.overlay.words = *language.ofPictures;
  return scene;
}

}  // namespace rotatebook::page
