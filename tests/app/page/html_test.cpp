#include "page/html.h"

#include <stdexcept>

#include <gtest/gtest.h>

namespace rotatebook::page {
namespace {

TEST(Escaped, LeavesNoMarkup) {
  EXPECT_EQ(escaped(R"(<b a="1" c='2'>&amp;</b> ω²)").text,
            "&lt;b a=&quot;1&quot; c=&#39;2&#39;&gt;&amp;amp;&lt;/b&gt; ω²");
  EXPECT_EQ(escaped("plain words").text, "plain words");
}

TEST(AddressOf, EncodesWhatAddressesGiveAMeaning) {
  EXPECT_EQ(addressOf("a b/100%#?\"é.mp4").text, "a%20b/100%25%23%3F%22%C3%A9.mp4");
  EXPECT_EQ(addressOf("fig05-unstable_x.mp4").text, "fig05-unstable_x.mp4");
}

TEST(Filled, PutsEachValueInItsPlaces) {
  EXPECT_EQ(filled("{{a}}-{{b}}-{{a}}.", {{"a", {"1"}}, {"b", {"{{a}}"}}}).text, "1-{{a}}-1.");
  EXPECT_EQ(filled("no names", {}).text, "no names");
}

TEST(Filled, RefusesATemplateThatDoesNotFit) {
  EXPECT_THROW(filled("{{a}}", {}), std::logic_error);
  EXPECT_THROW(filled("{{a}}", {{"a", {}}, {"b", {}}}), std::logic_error);
  EXPECT_THROW(filled("{{a", {{"a", {}}}), std::logic_error);
}

}  // namespace
}  // namespace rotatebook::page
