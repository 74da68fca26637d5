#include "page/language.h"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "messages.h"
#include "page/made_folder.h"
#include "page/page.h"
#include "page/story.h"
#include "scene/measure.h"
#include "scene/names.h"
#include "store/scene_file.h"
#include "system/atomic_file.h"

namespace rotatebook::page {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

const fs::path kRoot = ROTATEBOOK_SOURCE;

std::string textOf(const fs::path& file) {
  std::ifstream stream(file);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// Adds the first group of each match.
void addMatches(const std::string& text, const std::string& pattern, std::set<std::string>& texts) {
  const std::regex expression(pattern);
  for (std::sregex_iterator match(text.begin(), text.end(), expression), end; match != end; ++match)
    texts.insert((*match)[1]);
}

/// The text nodes and what is said of elements in HTML.
std::set<std::string> textsIn(std::string html) {
  // No regular expression, whose depth would grow with a script's length.
  for (const std::string tag : {"script", "style", "noscript", "pre", "code"}) {
    for (std::size_t at = html.find("<" + tag); at != html.npos; at = html.find("<" + tag, at)) {
      const std::size_t end = html.find("</" + tag + ">", at);
      if (end == html.npos) break;
      html.replace(at, end + tag.size() + 3 - at, "<i>");
    }
  }
  std::set<std::string> texts;
  addMatches(html, ">\\s*([^<>]*[^<>\\s])\\s*<", texts);
  addMatches(html, " (?:aria-label|aria-roledescription|title|alt|label)=\"([^\"]*)\"", texts);
  addMatches(html, "name=\"description\" content=\"([^\"]*)\"", texts);
  return texts;
}

/// What a file's code says: say("..."), and {{"..."}} in templates.
std::set<std::string> saidIn(const fs::path& file) {
  const std::string text = std::regex_replace(textOf(file), std::regex("\"\\s*\n\\s*\""), "");
  std::set<std::string> said;
  addMatches(text, "\\bsay\\(\\s*\"((?:[^\"\\\\]|\\\\.)*)\"", said);
  addMatches(text, R"re(\{\{\\?"((?:\{\w+\}|[^{}" \n\\])(?:\{\w+\}|[^{}"\n\\])*)\\?"\}\})re", said);
  return said;
}

/// All that the page and the live book say of themselves.
std::set<std::string> ownTexts() {
  std::set<std::string> texts{kTitle};
  for (const char* folder : {"assets/page", "src/app/page", "src/browser/player"}) {
    for (const auto& file : fs::directory_iterator(kRoot / folder))
      if (!file.is_directory() && file.path().extension() != ".h") texts.merge(saidIn(file));
  }
  texts.merge(saidIn(kRoot / "src/core/scene/expectation_text.cpp"));
  for (const char* file : {"player.html", "page.html"}) {
    for (const std::string& text : textsIn(textOf(kRoot / "src/browser/player" / file))) {
      const bool isWords = std::regex_search(text, std::regex("[A-Za-z]{2}"));
      if (isWords && !text.starts_with("{{")) texts.insert(text);
    }
  }
  for (const char* name : {"English", "Deutsch"}) texts.erase(name);
  for (const scene::MeasureRow& row : scene::kMeasureRows) texts.emplace(row.meaning);
  for (const auto& [name, model] : scene::kModels) texts.emplace(name);
  return texts;
}

std::set<std::string> textsOfTheStory() {
  std::set<std::string> texts;
  for (const Chapter& chapter : story()) {
    texts.insert({chapter.title, chapter.words});
    for (const auto* figures : {&chapter.figures, &chapter.folded})
      for (const StoryFigure& figure : *figures) texts.insert(figure.words);
  }
  return texts;
}

std::set<std::string> textsOfShippedScenes() {
  std::set<std::string> texts;
  for (const auto& entry : fs::recursive_directory_iterator(kRoot / "scenes")) {
    if (entry.path().extension() != ".toml") continue;
    const scene::Scene scene = store::readScene(entry.path());
    if (scene.overlay.words == scene::germanWords()) continue;
    texts.insert({scene.title, scene.caption});
    for (const scene::Cue& cue : scene.cues) texts.insert({cue.text.value_or(""), cue.chapter});
    if (scene.grid) continue;
    for (const scene::Panel& motion : scene.motions) texts.insert(motion.label);
  }
  texts.erase("");
  std::set<std::string> plain;
  for (const std::string& text : texts)
    plain.insert(std::regex_replace(text, std::regex("\u00a0"), " "));
  return plain;
}

const Language& german() {
  static const Language language = readLanguage("german");
  return language;
}

std::vector<std::string> lackingIn(const std::set<std::string>& texts) {
  std::vector<std::string> lacking;
  for (const std::string& text : texts)
    if (!german().texts.contains(text)) lacking.push_back(text);
  return lacking;
}

TEST(GermanList, HasWhatThePageAndTheLiveBookSay) {
  EXPECT_THAT(lackingIn(ownTexts()), IsEmpty());
}

TEST(GermanList, HasTheStory) {
  EXPECT_THAT(lackingIn(textsOfTheStory()), IsEmpty());
}

TEST(GermanList, HasTitlesCaptionsAndLabelsOfAllShippedScenes) {
  EXPECT_THAT(lackingIn(textsOfShippedScenes()), IsEmpty());
}

TEST(GermanList, HasNothingElse) {
  std::set<std::string> said = ownTexts();
  said.merge(textsOfTheStory());
  said.merge(textsOfShippedScenes());
  said.insert(scene::kEnglishWords.begin(), scene::kEnglishWords.end());
  said.insert("decimal_mark");
  for (const auto& [english, text] : german().texts) {
    EXPECT_TRUE(said.contains(english)) << english << " is said nowhere";
    EXPECT_FALSE(text.empty()) << english;
  }
}

TEST(GermanList, HasTheNamesThatValuesTakeThePlacesOf) {
  for (const auto& [english, text] : german().texts) {
    std::set<std::string> names, taken;
    addMatches(english, "(\\{\\w+\\})", names);
    addMatches(text, "(\\{\\w+\\})", taken);
    EXPECT_EQ(names, taken) << english;
  }
}

TEST(GermanPage, HasNoEnglish) {
  const fs::path folder = testing::emptyFolder();
  const scene::Scene scene =
      testing::smallScene({"nudge=[{ at = 0.25, angular_velocity = [0, 0, 0.01] }]"});
  testing::makeClip(scene, folder);
  Figure known = readFigure(scene, folder, {}, german());
  Figure other = known;
  other.id = "fig03-stable-z";
  const std::string page = pageText(kTitle, {known, other}, "", german());
  EXPECT_THAT(page, AllOf(HasSubstr("<html lang=\"de\">"), HasSubstr("srclang=\"de\""),
                          HasSubstr("0,25 s: Stoß 1<"), HasSubstr("Sto%C3%9F%201"),
                          HasSubstr("1 von 2 Erwartungen erfüllt"), HasSubstr(">höchstens 0<"),
                          HasSubstr("<h1>Die instabile Drehung eines Buches</h1>"),
                          HasSubstr("Zwei Achsen, die halten")));
  for (const std::string& text : textsIn(page)) {
    const auto found = german().texts.find(text);
    EXPECT_TRUE(found == german().texts.end() || found->second == text) << text;
  }
}

TEST(GermanPage, TellsShippedScenesByTheirGermanTitles) {
  scene::Scene scene = store::readScene(kRoot / "scenes/comparisons/axes.toml");
  scene = inLanguage(scene, german());
  EXPECT_EQ(scene.title, "Ein Buch, drei Achsen");
  EXPECT_EQ(scene.motions[1].label, "x: mittleres Moment");
  EXPECT_EQ(scene.overlay.words, scene::germanWords());
}

TEST(Language, IsEnglishByDefault) {
  const Language say = readLanguage("english");
  EXPECT_EQ(say.tag, "en");
  EXPECT_EQ(say("at most {number}", {{"number", "2.5"}}), "at most 2.5");
  EXPECT_EQ(say.numbers("2.5"), "2.5");
}

TEST(Language, HasItsDecimalMarkInNumbersAlone) {
  EXPECT_EQ(german().numbers("0.5 to 1.25 s. Ende, v1."), "0,5 to 1,25 s. Ende, v1.");
}

Language languageOf(const std::string& list) {
  const fs::path file = testing::emptyFolder() / "own.words";
  system::writeFileAtomically(file, list);
  return readLanguage(file.string());
}

TEST(Language, OfAFileIsEnglishWhereItsListHasNothing) {
  const Language say = languageOf(
      "language = 'fr'\nflip = 'retournement'\n[page]\nPlay = 'Lire'\n[figures]\nA = 'Un'\n'2 kg' "
      "= 'deux'\n");
  EXPECT_EQ(say.tag, "fr");
  EXPECT_EQ(say("flip"), "retournement");
  EXPECT_EQ(say("Play"), "Lire");
  EXPECT_EQ(say("A"), "Un");
  EXPECT_EQ(say("2\u00a0kg"), "deux");
  EXPECT_EQ(say("Pause"), "Pause");
  EXPECT_THAT(pageText("A", {}, "", say),
              AllOf(HasSubstr("<html lang=\"fr\">"), HasSubstr("\"Play\":\"Lire\""),
                    HasSubstr("<title>Un<"), Not(HasSubstr("\"A\":\"Un\""))));
}

TEST(Language, ThatIsNoneIsRefused) {
  const auto refusalOf = [](const std::string& name) {
    try {
      readLanguage(name);
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string("no error");
  };
  EXPECT_MESSAGE(refusalOf("germann"));
  EXPECT_MESSAGE(refusalOf("absent.words"));
  EXPECT_THROW(languageOf("flip = 'tour'\n"), InputError);
  EXPECT_THROW(languageOf("language = 'f r'\n"), InputError);
  EXPECT_THROW(languageOf("language = 'fr'\nflop = 'tour'\n"), InputError);
  EXPECT_THROW(languageOf("language = 'fr'\n[page]\nPlay = 3\n"), InputError);
}

}  // namespace
}  // namespace rotatebook::page
