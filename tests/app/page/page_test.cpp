#include "page/page.h"

#include <string>

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

TEST(Page, HoldsItsFiguresByKindAndInOrder) {
  Figure study = figureOf(FigureKind::Study, "s");
  study.curves = {"<svg>s</svg>"};
  study.badge = {"[badge]"};
  const std::string text = pageText("Books & <such>", {study, figureOf(FigureKind::Clip, "c"),
                                                       figureOf(FigureKind::Comparison, "p")});
  EXPECT_THAT(text, AllOf(HasSubstr("<title>Books &amp; &lt;such&gt;</title>"), HasSubstr("[c][p]"),
                          HasSubstr("src=\"c%201.png\""), HasSubstr("Title of &lt;c&gt;"),
                          Not(HasSubstr("<such>")), HasSubstr("<svg>s</svg>"),
                          Not(HasSubstr("s%201.png")), HasSubstr("</a>[badge]</li>")));
  EXPECT_LT(text.find("<h3>Clips</h3>"), text.find("<h3>Comparisons</h3>"));
  EXPECT_LT(text.find("<h3>Comparisons</h3>"), text.find("<h3>Studies</h3>"));
  EXPECT_EQ(text.find("<h3>Stills"), std::string::npos);
}

TEST(Page, BeginsWithWhatThereIsToSeeAndItsFirstFigure) {
  const std::string text =
      pageText("A", {figureOf(FigureKind::Comparison, "first"),
                     figureOf(FigureKind::Still, "still"), figureOf(FigureKind::Clip, "clip")});
  const std::size_t words = text.find("intermediate axis theorem");
  const std::size_t lead = text.find("[first]");
  const std::size_t overview = text.find("<h2 id=\"overview\">");
  EXPECT_LT(words, lead);
  EXPECT_LT(lead, overview);
  EXPECT_LT(overview, text.find("[still][clip]"));
  EXPECT_THAT(text, AllOf(HasSubstr("href=\"#first\""), HasSubstr("<h3>Stills and clips</h3>")));
}

TEST(Page, HasNoOverviewOfASingleFigure) {
  EXPECT_THAT(
      pageText("A", {figureOf(FigureKind::Clip, "a")}),
      AllOf(HasSubstr("[a]"), Not(HasSubstr("id=\"overview\"")), Not(HasSubstr("#overview"))));
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
