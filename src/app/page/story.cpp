#include "page/story.h"

#include <algorithm>
#include <set>

#include "base/document/toml_tree.h"
#include "base/document/value_reader.h"
#include "embedded/page.h"

namespace rotatebook::page {
namespace {

using document::ValueReader;

constexpr std::size_t kLongestWords = 500;  // [characters]

StoryFigure readStoryFigure(const ValueReader& table) {
  StoryFigure figure;
  table.readTable(
      {{"scene", [&](const auto& value) { figure.scene = value.text(kLongestWords); }},
       {"words", [&](const auto& value) { figure.words = value.text(kLongestWords); }}});
  return figure;
}

std::vector<StoryFigure> readStoryFigures(const ValueReader& array) {
  std::vector<StoryFigure> figures;
  for (const ValueReader& figure : array.tables("an array of figures")) {
    figures.push_back(readStoryFigure(figure));
  }
  return figures;
}

Chapter readChapter(const ValueReader& table) {
  Chapter chapter;
  table.readTable(
      {{"id", [&](const auto& value) { chapter.id = value.text(kLongestWords); }},
       {"title", [&](const auto& value) { chapter.title = value.text(kLongestWords); }},
       {"words", [&](const auto& value) { chapter.words = value.text(kLongestWords); }},
       {"figures", [&](const auto& value) { chapter.figures = readStoryFigures(value); }},
       {"folded", [&](const auto& value) { chapter.folded = readStoryFigures(value); }}});
  return chapter;
}

/// Returns what no chapter holds; "More" only if there is a story before it.
ToldChapter restOf(const std::vector<Figure>& figures, const std::set<std::string>& told,
                   const Language& say) {
  ToldChapter rest{"more", told.empty() ? say("Figures") : say("More"), "", {}};
  for (const Figure& figure : figures) {
    if (!told.contains(figure.id)) rest.figures.push_back({&figure});
  }
  return rest;
}

}  // namespace

std::vector<Chapter> readStory(std::string_view toml) {
  const document::TomlNode tree = document::parseToml(toml, "story.toml");
  std::vector<Chapter> chapters;
  ValueReader(tree, "").readTable({{"chapter", [&](const ValueReader& value) {
                                      for (const auto& table : value.tables("tables"))
                                        chapters.push_back(readChapter(table));
                                    }}});
  return chapters;
}

const std::vector<Chapter>& story() {
  static const std::vector<Chapter> chapters = readStory(storyText());
  return chapters;
}

std::vector<ToldChapter> tell(const std::vector<Figure>& figures, const std::vector<Chapter>& story,
                              const Language& say) {
  std::vector<ToldChapter> told;
  std::set<std::string> scenes;
  for (const Chapter& chapter : story) {
    ToldChapter next{chapter.id, say(chapter.title), say(chapter.words), {}};
    const auto tellAll = [&](const std::vector<StoryFigure>& all, bool isFolded) {
      for (const StoryFigure& one : all) {
        const auto found = std::ranges::find(figures, one.scene, &Figure::id);
        if (found == figures.end() || !scenes.insert(one.scene).second) continue;
        next.figures.push_back({&*found, say(one.words), isFolded});
      }
    };
    tellAll(chapter.figures, false);
    tellAll(chapter.folded, !next.figures.empty());
    if (!next.figures.empty()) told.push_back(next);
  }
  const ToldChapter rest = restOf(figures, scenes, say);
  if (!rest.figures.empty()) told.push_back(rest);
  return told;
}

}  // namespace rotatebook::page
