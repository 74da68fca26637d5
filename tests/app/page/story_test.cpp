#include "page/story.h"

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "store/scene_file.h"

namespace rotatebook::page {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;

constexpr std::size_t kMostShown = 12;  // Of a chapter's figures.

Figure figureOf(const std::string& id) {
  return {FigureKind::Clip, id, "Title of " + id, id + ".png"};
}

std::vector<std::string> orderOf(const std::vector<ToldChapter>& chapters) {
  std::vector<std::string> order;
  for (const ToldChapter& chapter : chapters) {
    order.push_back("[" + chapter.title + "]");
    for (const ToldFigure& told : chapter.figures) order.push_back(told.figure->id + told.words);
  }
  return order;
}

const std::vector<Chapter> kStory = readStory(R"(
[[chapter]]
id = "one"
title = "One"
words = "Words."
figures = [{ scene = "b", words = "!" }, { scene = "absent", words = "?" }, { scene = "a", words = "." }]
[[chapter]]
id = "two"
title = "Two"
words = "Of nothing that is there."
figures = [{ scene = "nowhere", words = "" }]
)");

TEST(Story, OrdersFiguresByChapters) {
  EXPECT_THAT(orderOf(tell({figureOf("x"), figureOf("a"), figureOf("b")}, kStory)),
              ElementsAre("[One]", "b!", "a.", "[More]", "x"));
}

const std::vector<Chapter> kFolding = readStory(R"(
[[chapter]]
id = "one"
title = "One"
words = "Words."
figures = [{ scene = "a", words = "." }]
folded = [{ scene = "b", words = "!" }]
)");

TEST(Story, FoldsFiguresAwayBehindOthersAlone) {
  const std::vector<Figure> both{figureOf("b"), figureOf("a")};
  const std::vector<ToldChapter> told = tell(both, kFolding);
  EXPECT_THAT(orderOf(told), ElementsAre("[One]", "a.", "b!"));
  EXPECT_FALSE(told[0].figures[0].isFolded);
  EXPECT_TRUE(told[0].figures[1].isFolded);
  const std::vector<Figure> one{figureOf("b")};
  EXPECT_FALSE(tell(one, kFolding)[0].figures[0].isFolded);
}

TEST(Story, LeavesFiguresOfNoChapterInTheirOrder) {
  EXPECT_THAT(orderOf(tell({figureOf("y"), figureOf("x")}, kStory)),
              ElementsAre("[Figures]", "y", "x"));
  EXPECT_TRUE(tell({}, kStory).empty());
}

TEST(Story, RefusesWhatIsNoStory) {
  EXPECT_THROW(readStory("[[chapter]]\nname = \"one\"\n"), InputError);
  EXPECT_THROW(readStory("[[chapter]]\nid = 1\n"), InputError);
  EXPECT_THROW(readStory("chapter = \"one\"\n"), InputError);
}

std::set<std::string> shippedScenes() {
  std::set<std::string> names;
  for (const auto& entry : fs::recursive_directory_iterator(ROTATEBOOK_SOURCE "/scenes")) {
    if (entry.path().extension() == ".toml") names.insert(entry.path().stem().string());
  }
  return names;
}

TEST(Story, NamesEachShippedFigureOnce) {
  std::set<std::string> named;
  for (const Chapter& chapter : story()) {
    EXPECT_FALSE(chapter.words.empty()) << chapter.id;
    EXPECT_LE(chapter.figures.size(), kMostShown) << chapter.id;
    for (const auto* figures : {&chapter.figures, &chapter.folded}) {
      for (const StoryFigure& figure : *figures) {
        EXPECT_TRUE(named.insert(figure.scene).second) << figure.scene << " comes twice";
        EXPECT_FALSE(figure.words.empty()) << figure.scene;
      }
    }
  }
  std::set<std::string> shipped = shippedScenes();
  shipped.erase("spin-about-z");  // An example that isn't part of the story.
  EXPECT_EQ(named, shipped);
}

TEST(Story, HasATitleOfItsOwnForEachShippedFigure) {
  std::set<std::string> titles;
  for (const auto& entry : fs::recursive_directory_iterator(ROTATEBOOK_SOURCE "/scenes")) {
    if (entry.path().extension() != ".toml") continue;
    const std::string title = store::readScene(entry.path()).title;
    EXPECT_TRUE(titles.insert(title).second) << entry.path() << ": " << title;
  }
  EXPECT_FALSE(titles.empty());
}

}  // namespace
}  // namespace rotatebook::page
