// The story that the page tells: chapters, their figures and the words between. Inside the room
// only.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "page/figure.h"

namespace rotatebook::page {

/// A scene's place in a chapter, and the sentence before its figure.
struct StoryFigure {
  std::string scene;
  std::string words;
};

struct Chapter {
  std::string id;
  std::string title;
  std::string words;  ///< The chapter in a sentence or two.
  std::vector<StoryFigure> figures;
  std::vector<StoryFigure> folded{};  ///< Shown when somebody asks for them.
};

/// Reads chapters from TOML. Throws InputError for text that isn't a story.
std::vector<Chapter> readStory(std::string_view toml);

/// Returns the chapters of assets/page/story.toml.
const std::vector<Chapter>& story();

/// A figure with the sentence before it, which may be empty.
struct ToldFigure {
  const Figure* figure = nullptr;
  std::string words{};
  bool isFolded = false;
};

struct ToldChapter {
  std::string id;
  std::string title;
  std::string words;
  std::vector<ToldFigure> figures;  ///< Never empty; folded ones last, and never alone.
};

/// Returns the chapters of `story` that have one of `figures`, in the story's order. Figures that
/// it doesn't name make a last chapter, in their own order. The figures must outlive the result.
std::vector<ToldChapter> tell(const std::vector<Figure>& figures, const std::vector<Chapter>& story,
                              const Language& say = {});

}  // namespace rotatebook::page
