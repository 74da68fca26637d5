#include "base/text.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "base/error.h"

namespace rotatebook {
namespace {

TEST(Trimmed, HasNoBlanksAtItsEnds) {
  EXPECT_EQ(trimmed(" \ta b\r\n"), "a b");
  EXPECT_EQ(trimmed("a"), "a");
  EXPECT_EQ(trimmed(" \n"), "");
}

TEST(ItemsOf, AreOneMoreThanWhatDividesThem) {
  EXPECT_EQ(itemsOf("a, b ,,"), (std::vector<std::string>{"a", "b", "", ""}));
  EXPECT_EQ(itemsOf("a, b", ':'), (std::vector<std::string>{"a, b"}));
  EXPECT_EQ(itemsOf(""), (std::vector<std::string>{""}));
}

TEST(ShellWord, IsInQuotationMarksIfItNeedsThem) {
  EXPECT_EQ(shellWord("a-b.toml"), "a-b.toml");
  EXPECT_EQ(shellWord("it's"), R"('it'\''s')");
  EXPECT_EQ(shellWord(""), "''");
}

TEST(Joined, LeavesOutWhatIsEmpty) {
  EXPECT_EQ(joined({}), "");
  EXPECT_EQ(joined({"", "a", "", "b", ""}), "a, b");
  EXPECT_EQ(joined({"a", "b"}, "; "), "a; b");
  EXPECT_EQ(joinedOf(std::vector{1, 2}, [](int number) { return std::to_string(number); }), "1, 2");
}

TEST(Listed, JoinsThingsAsASentenceDoes) {
  EXPECT_EQ(listed({}), "nothing");
  EXPECT_EQ(listed({"a"}), "a");
  EXPECT_EQ(listed({"a", "b", "c"}), "a, b and c");
  EXPECT_EQ(listed({"a", "b"}, "or"), "a or b");
}

TEST(CountText, HasAnSButOfOne) {
  EXPECT_EQ(countText(0, "frame"), "0 frames");
  EXPECT_EQ(countText(1, "frame"), "1 frame");
  EXPECT_EQ(countText(-12, "degree"), "-12 degrees");
  EXPECT_EQ(countText("1", "degree"), "1 degree");
  EXPECT_EQ(countText("0.5", "degree"), "0.5 degrees");
}

TEST(SizeText, IsWidthAndHeight) {
  EXPECT_EQ(sizeText(640, 360), "640x360");
}

TEST(QuotedText, EscapesWhatTomlAndJsonForbid) {
  EXPECT_EQ(quotedText("plain é"), "\"plain é\"");
  EXPECT_EQ(quotedText("\"\\\n\t"), R"("\"\\\n\t")");
  EXPECT_EQ(quotedText(std::string("\x01\x1f\x7f\0", 4)), R"("\u0001\u001F\u007F\u0000")");
}

TEST(QuotedText, OfABeginningIsEscapedOnce) {
  EXPECT_EQ(quotedBeginning("a\"\x01\\\xc3", 5), "\"a\\\"\\u0001\\\\\uFFFD\"");
  EXPECT_EQ(quotedBeginning("ab\\", 2), "\"ab...\"");
}

TEST(QuotedText, EscapesTheControlCharactersOfLatin1) {
  EXPECT_EQ(quotedText("\u0080\u009b\u009f\u00a0"), "\"\\u0080\\u009B\\u009F\u00a0\"");
  EXPECT_EQ(quotedText("\xc2"), "\"\xc2\"");
}

TEST(Printable, LeavesATerminalNothingToObey) {
  EXPECT_EQ(printable("a\x1b[31m\u009b\x7f"), "a\\u001B[31m\\u009B\\u007F");
  EXPECT_EQ(printable("\"é\" \\ two\nlines\t"), "\"é\" \\ two\nlines\t");
}

TEST(OneLine, HasNoEndsOfLinesAndNoMoreThanItMay) {
  EXPECT_EQ(oneLine("\"é\" \\ two\nlines\t\x1b", 99), "\"é\" \\ two\\nlines\\t\\u001B");
  EXPECT_EQ(oneLine("aé本📖", 4), "aé本📖");
  EXPECT_EQ(oneLine("aé本📖", 3), "aé本...");
  EXPECT_EQ(oneLine("", 0), "");
  EXPECT_EQ(oneLine(std::string(99, '\x80'), 2),
            "\uFFFD\uFFFD\uFFFD\uFFFD\uFFFD\uFFFD\uFFFD\uFFFD...");
}

TEST(LetterCount, CountsLettersNotBytes) {
  EXPECT_EQ(characterCount(""), 0u);
  EXPECT_EQ(characterCount("aé本📖"), 4u);
}

TEST(FirstLetters, AreNoMoreThanThereAre) {
  EXPECT_EQ(firstCharacters("aé本📖", 3), "aé本");
  EXPECT_EQ(firstCharacters("aé", 3), "aé");
}

TEST(IsOneLine, TakesEveryLetterOfUnicode) {
  EXPECT_TRUE(isOneLine(""));
  EXPECT_TRUE(isOneLine("aé本📖 \u00a0\u07ff\u0800\ud7ff\ue000\uffff\U00010000\U0010ffff"));
}

TEST(IsOneLine, RefusesControlCharactersAndWhatIsNotUtf8) {
  for (const char* control : {"a\n", "\t", "\x1f", "\x7f", "\u0080", "a\u009bb", "\u009f"}) {
    EXPECT_FALSE(isOneLine(control)) << quotedText(control);
  }
  EXPECT_FALSE(isOneLine(std::string(1, '\0')));
  for (const char* broken :
       {"\x80", "a\xc3", "\xc3(", "\xe2\x82", "\xe2\x28\xa1", "\xf0\x9f\x93", "\xff"}) {
    EXPECT_FALSE(isOneLine(broken)) << quotedText(broken);
  }
  // Too long a form, half of a surrogate, beyond the last letter.
  for (const char* forbidden : {"\xc0\xaf", "\xc1\xbf", "\xe0\x9f\xbf", "\xf0\x8f\xbf\xbf",
                                "\xed\xa0\x80", "\xf4\x90\x80\x80"}) {
    EXPECT_FALSE(isOneLine(forbidden)) << quotedText(forbidden);
  }
}

TEST(IsOneLine, RefusesSeparatorsAndMarksOfDirection) {
  for (const char* mark : {"\u061c", "\u200e", "\u200f", "\u2028", "\u2029", "\u202a", "\u202e",
                           "\u2066", "a\u2069b"}) {
    EXPECT_FALSE(isOneLine(mark)) << quotedText(mark);
    EXPECT_TRUE(isOneLine(printable(mark)));
  }
  EXPECT_EQ(quotedText("\u202eb"), "\"\\u202Eb\"");
  EXPECT_TRUE(isOneLine("\u061b\u200d\u2010\u2027\u202f\u2065\u206a"));
}

TEST(Error, IsOnOneLineAndSafeToPrint) {
  EXPECT_STREQ(InputError("can't read a\nb\t\x1b[2J\u009b\u202e\xff.png").what(),
               "can't read a\\nb\\t\\u001B[2J\\u009B\\u202E\uFFFD.png");
  EXPECT_STREQ(MachineError("disk full\n  12 frames are kept").what(),
               "disk full\n  12 frames are kept");
  const std::string once = messageText("a\nb \"\\\" \u009b");
  EXPECT_EQ(messageText(once), once);
}

}  // namespace
}  // namespace rotatebook
