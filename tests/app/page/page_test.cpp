#include "page/page.h"

#include <regex>
#include <set>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "page/made_folder.h"

namespace rotatebook::page {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

Figure figureOf(FigureKind kind, const std::string& id) {
  Figure figure{kind, id, "Title of <" + id + ">", id + " 1.png"};
  figure.section = {"[" + id + "]"};
  return figure;
}

TEST(Page, TellsItsFiguresInTheStorysOrder) {
  Figure study = figureOf(FigureKind::Study, "figb-flip-interval");
  study.thumbnail = "figb-study.svg";
  study.badge = {"[badge]"};
  const std::string text =
      pageText("Books & <such>",
               {figureOf(FigureKind::Comparison, "axes"), study, figureOf(FigureKind::Clip, "<c>"),
                figureOf(FigureKind::Clip, "fig05-unstable-x")});
  EXPECT_THAT(text, AllOf(HasSubstr("<title>Books &amp; &lt;such&gt;</title>"),
                          HasSubstr("src=\"axes%201.png\""), HasSubstr("Title of &lt;&lt;c&gt;"),
                          Not(HasSubstr("<such>")), HasSubstr("src=\"figb-study.svg\""),
                          HasSubstr("</a>[badge]</li>")));
  EXPECT_LT(text.find("<h2 id=\"chapter/unstable\">"), text.find("[fig05-unstable-x]"));
  EXPECT_LT(text.find("[fig05-unstable-x]"), text.find("<h2 id=\"chapter/why\">"));
  EXPECT_LT(text.find("<h2 id=\"chapter/why\">"), text.find("[figb-flip-interval]"));
  EXPECT_LT(text.find("[figb-flip-interval]"), text.find("<h2 id=\"chapter/more\">"));
  EXPECT_LT(text.find("<h2 id=\"chapter/more\">"), text.find("[<c>]"));
  EXPECT_THAT(text, AllOf(HasSubstr("A book made of springs does it, too"),
                          Not(HasSubstr("chapter/stable"))));
}

TEST(Page, FoldsAwayWhatTheStoryFolds) {
  const std::string text = pageText(
      "A", {figureOf(FigureKind::Clip, "axes"), figureOf(FigureKind::Clip, "fige-stiffness"),
            figureOf(FigureKind::Clip, "fig06-undamped")});
  const std::string fold = "<details class=\"folded\"><summary>1 more</summary>";
  const std::size_t inOverview = text.find(fold);
  const std::size_t inChapter = text.find(fold, inOverview + 1);
  ASSERT_NE(inChapter, text.npos);
  EXPECT_LT(inOverview, text.find("<span class=\"title\">Title of &lt;fige-stiffness&gt;"));
  EXPECT_LT(text.find("[fig06-undamped]"), inChapter);
  EXPECT_LT(inChapter, text.find("[fige-stiffness]"));
  EXPECT_EQ(text.find(fold, inChapter + 1), text.npos);
}

TEST(Page, BeginsWithWhatThereIsToSeeAndItsFirstFigure) {
  const std::string text =
      pageText("A", {figureOf(FigureKind::Comparison, "first"),
                     figureOf(FigureKind::Still, "still"), figureOf(FigureKind::Clip, "clip")});
  const std::size_t words = text.find("turns over, again and again. Nobody");
  const std::size_t lead = text.find("[first]");
  const std::size_t overview = text.find("<h2 id=\"page/overview\">");
  EXPECT_LT(words, lead);
  EXPECT_LT(lead, overview);
  EXPECT_LT(overview, text.find("[still]"));
  EXPECT_LT(text.find("[still]"), text.find("[clip]"));
  EXPECT_EQ(text.find("[first]", lead + 1), text.npos);
  EXPECT_THAT(text, AllOf(HasSubstr("href=\"#first\""), HasSubstr("<h3>Figures</h3>"),
                          HasSubstr("property=\"og:image\" content=\"first%201.png\""),
                          HasSubstr("name=\"description\""), HasSubstr("rel=\"icon\"")));
}

TEST(Page, HasThePlaceOfTheLiveBookOnlyWithOne) {
  const Figure figure = figureOf(FigureKind::Clip, "a");
  const std::string text = pageText("A", {figure}, "<canvas></canvas>{{");
  EXPECT_LT(text.find("<div class=\"live\" id=\"page/live\"><canvas></canvas>{{</div>"),
            text.find("[a]"));
  EXPECT_THAT(pageText("A", {figure}), Not(HasSubstr("class=\"live\"")));
  const std::vector<Figure> two{figure, figureOf(FigureKind::Clip, "b")};
  const std::string ofContents = "<a class=\"of-chapter\" href=\"#page/live\">The live book</a>";
  EXPECT_THAT(pageText("A", two, "<p></p>"), HasSubstr(ofContents));
  EXPECT_THAT(pageText("A", two), Not(HasSubstr(ofContents)));
}

TEST(Page, HasNoOverviewOfASingleFigure) {
  EXPECT_THAT(pageText("A", {figureOf(FigureKind::Clip, "a")}),
              AllOf(HasSubstr("[a]"), Not(HasSubstr("id=\"page/overview\"")),
                    Not(HasSubstr("#page/overview")), Not(HasSubstr("<nav"))));
}

/// Returns the values of an attribute in `html`, without its entities.
std::vector<std::string> valuesOf(const std::string& attribute, const std::string& html) {
  const std::regex pattern(" " + attribute + "=\"([^\"]*)\"");
  std::vector<std::string> values;
  for (std::sregex_iterator at(html.begin(), html.end(), pattern), end; at != end; ++at)
    values.push_back(std::regex_replace((*at)[1].str(), std::regex("&amp;"), "&"));
  return values;
}

std::string percentDecoded(const std::string& text) {
  std::string decoded;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool isCode = text[i] == '%';
    decoded += isCode ? static_cast<char>(std::stoi(text.substr(i + 1, 2), nullptr, 16)) : text[i];
    if (isCode) i += 2;
  }
  return decoded;
}

TEST(Page, HasOneElementOfEachIdAndLinksThatLand) {
  const auto folder = testing::emptyFolder();
  std::vector<Figure> figures;
  for (const char* name : {"theme", "live", "overview", "figures", "a", "a-title", "a-caption",
                           "a#b?c&d%41", "two words", "Ä"}) {
    scene::Scene scene = testing::smallScene();
    scene.name = name;
    testing::makeClip(scene, folder);
    figures.push_back(readFigure(scene, folder));
  }
  const std::string text = pageText("A", figures, "<p></p>");
  const std::vector<std::string> all = valuesOf("id", text);
  const std::set<std::string> ids(all.begin(), all.end());
  EXPECT_EQ(ids.size(), all.size());
  EXPECT_TRUE(ids.contains("a#b?c&d%41"));
  for (const std::string& link : valuesOf("href", text)) {
    if (!link.starts_with('#')) continue;
    EXPECT_TRUE(ids.contains(percentDecoded(link.substr(1)))) << link;
  }
  for (const char* attribute : {"aria-labelledby", "aria-describedby"}) {
    for (const std::string& id : valuesOf(attribute, text)) EXPECT_TRUE(ids.contains(id)) << id;
  }
}

TEST(Page, NeedsNoOtherScriptsNorStyles) {
  const std::string text = pageText("A", {});
  EXPECT_THAT(text, AllOf(HasSubstr("uPlot"), HasSubstr("class Player"), HasSubstr("--ground"),
                          Not(HasSubstr("<script src")), Not(HasSubstr("stylesheet")),
                          Not(HasSubstr("@import")), Not(HasSubstr("url("))));
}

TEST(Page, IsTheSameEachTime) {
  const auto folder = testing::emptyFolder();
  testing::makeClip(testing::smallScene(), folder);
  const auto text = [&] { return pageText("A", {readFigure(testing::smallScene(), folder)}); };
  EXPECT_EQ(text(), text());
}

}  // namespace
}  // namespace rotatebook::page
