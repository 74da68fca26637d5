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

TEST(Page, HoldsItsFiguresByKindAndInOrder) {
  const std::string text =
      pageText("Books & <such>", {{FigureKind::Study, "s", "S", "s.svg", {}, {"[study]"}},
                                  {FigureKind::Clip, "a b", "A <b>", "a b.png", {}, {"[clip]"}}});
  EXPECT_THAT(text, AllOf(HasSubstr("<title>Books &amp; &lt;such&gt;</title>"),
                          HasSubstr("[study][clip]"), HasSubstr("src=\"a%20b.png\""),
                          HasSubstr("A &lt;b&gt;"), Not(HasSubstr("<such>"))));
  EXPECT_LT(text.find("<h3>Clips</h3>"), text.find("<h3>Studies</h3>"));
  EXPECT_EQ(text.find("<h3>Stills</h3>"), std::string::npos);
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
