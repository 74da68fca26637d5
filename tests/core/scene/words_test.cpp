#include "scene/words.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <string>

#include <gtest/gtest.h>

#include "base/error.h"
#include "messages.h"
#include "scene/scene_text.h"

namespace rotatebook::scene {
namespace {

Scene sceneWithWords(const std::string& words) {
  return parseScene("[initial]\nangular_velocity = [5, 3, 1]\n[overlay]\nwords = " + words + "\n",
                    "a.toml");
}

TEST(Words, AreEnglishByDefault) {
  const Words words;
  EXPECT_EQ(words[Word::Flips], "Flips");
  EXPECT_EQ(words.number("1.5 s"), "1.5 s");
  EXPECT_EQ(sceneWithWords("'english'").overlay.words, words);
}

TEST(Words, OfTheListAreAllDifferentAndTranslated) {
  const Words german = germanWords();
  for (std::size_t i = 0; i < kEnglishWords.size(); ++i) {
    EXPECT_EQ(std::ranges::count(kEnglishWords, kEnglishWords[i]), 1) << kEnglishWords[i];
    EXPECT_FALSE(german.texts[i].empty()) << kEnglishWords[i];
  }
}

TEST(Words, ShipInGerman) {
  const Words words = sceneWithWords("'german'").overlay.words;
  EXPECT_EQ(words[Word::Flips], "Überschläge");
  EXPECT_EQ(words.number("1.5 s"), "1,5 s");
  EXPECT_EQ(words.number("12 s"), "12 s");
}

TEST(Words, AreFoundByTheirEnglish) {
  EXPECT_EQ(Words{}.of("midpoint"), "midpoint");
  EXPECT_EQ(germanWords().of("midpoint"), "Mittelpunktsregel");
  EXPECT_EQ(germanWords().of("rk4"), "rk4");
}

TEST(Words, OfATableReplaceThoseInEnglish) {
  const Words words = sceneWithWords("{ 'Flips' = 'Retournements' }").overlay.words;
  EXPECT_EQ(words[Word::Flips], "Retournements");
  EXPECT_EQ(words[Word::Energy], "Energy");
}

TEST(Words, AreAllInTheFrenchTable) {
  std::ifstream stream(std::string(ROTATEBOOK_SOURCE) + "/docs/tables/french.words");
  const std::string table(std::istreambuf_iterator<char>(stream), {});
  for (const std::string_view english : kEnglishWords) {
    const std::string bare = "\n" + std::string(english) + " = \"";
    const std::string quoted = "\n\"" + std::string(english) + "\" = \"";
    EXPECT_TRUE(table.find(bare) != table.npos || table.find(quoted) != table.npos) << english;
  }
}

TEST(Words, OfAListForThePageAreTakenFromIt) {
  const Words words =
      sceneWithWords("{ language = 'fr', page = { 'Play' = 'Lire' }, 'flip' = 'tour' }")
          .overlay.words;
  EXPECT_EQ(words[Word::Flip], "tour");
}

TEST(Words, AreThoseOfTheScenesText) {
  for (const char* words :
       {"'english'", "'german'", "{ 'Flips' = 'Retournements', decimal_mark = ',' }"}) {
    const Scene scene = sceneWithWords(words);
    EXPECT_EQ(parseScene(sceneText(scene), "a.toml").overlay.words, scene.overlay.words) << words;
  }
}

std::string refusalOf(const std::string& words) {
  try {
    sceneWithWords(words);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(Words, HaveADecimalMarkThatLeavesNumbersWhatTheyAre) {
  for (const char* mark : {".", ",", "·", "٫"}) {
    const std::string words = std::string("{ decimal_mark = '") + mark + "' }";
    EXPECT_EQ(sceneWithWords(words).overlay.words.decimalMark, mark);
  }
  for (const char* mark : {"", "5", "-", "+", "e", " ", "1.", "..", ", ", "x", "٣", "−", "½"}) {
    EXPECT_MESSAGE(refusalOf(std::string("{ decimal_mark = '") + mark + "' }")) << mark;
  }
}

TEST(Words, ThatAreUnknownAreRefused) {
  EXPECT_MESSAGE(refusalOf("{ 'Polhodes' = 'Polhodie' }"));
  for (const char* words : {"'germann'", "3", "'french'", "'french.words'"}) {
    EXPECT_MESSAGE(refusalOf(words)) << words;
  }
}

}  // namespace
}  // namespace rotatebook::scene
