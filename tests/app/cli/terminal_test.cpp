#include "cli/terminal.h"

#include <sstream>

#include <gtest/gtest.h>

#include "cli/text_width.h"

namespace rotatebook::cli {
namespace {

TEST(Wrapped, BreaksBetweenWordsAndIndentsWhatFollows) {
  EXPECT_EQ(wrapped("a line of seven short words in all", 20),
            "a line of seven\nshort words in all");
  EXPECT_EQ(wrapped("  4 flips, at 1.86 s; energy kept", 24),
            "  4 flips, at 1.86 s;\n    energy kept");
  EXPECT_EQ(wrapped("  not met  half_turns: expected at least 9", 30),
            "  not met  half_turns:\n           expected at least 9");
}

TEST(Wrapped, LeavesWhatFitsAndWordsThatDoNot) {
  EXPECT_EQ(wrapped("exactly twenty long.", 20), "exactly twenty long.");
  EXPECT_EQ(wrapped("see https://example.org/a/long/path here", 20),
            "see\nhttps://example.org/a/long/path\nhere");
  EXPECT_EQ(wrapped("any line in too narrow a terminal", 19), "any line in too narrow a terminal");
  EXPECT_EQ(wrapped("  ", 40), "  ");
}

TEST(Wrapped, CountsLettersNotBytes) {
  EXPECT_EQ(wrapped("äöü äöü äöü äöü äöü äöü", 20), "äöü äöü äöü äöü äöü\näöü");
}

TEST(Wrapped, CountsTheColumnsOfWideLettersAndMarks) {
  EXPECT_EQ(wrapped("漢字 漢字 漢字 漢字 漢字", 20), "漢字 漢字 漢字 漢字\n漢字");
  EXPECT_EQ(wrapped("a\u0308b a\u0308b a\u0308b a\u0308b a\u0308b a\u0308b a\u0308b", 20),
            "a\u0308b a\u0308b a\u0308b a\u0308b a\u0308b a\u0308b a\u0308b");
}

TEST(TextWidth, IsThatOnATerminal) {
  EXPECT_EQ(columnsOf("tumble"), 6U);
  EXPECT_EQ(columnsOf("Öl 漢字"), 7U);
  EXPECT_EQ(columnsOf("a\u0308\u0301 한 \u200B"), 5U);
  EXPECT_EQ(columnsOf("\xff\xe6\xbc"), 3U);
}

TEST(TextWidth, IsKeptByACut) {
  EXPECT_EQ(cutTo("tumble", 6), "tumble");
  EXPECT_EQ(cutTo("tumble", 5), "tumb…");
  EXPECT_EQ(cutTo("漢字漢字", 8), "漢字漢字");
  EXPECT_EQ(cutTo("漢字漢字", 7), "漢字漢…");
  EXPECT_EQ(cutTo("漢字漢字", 6), "漢字…");
  EXPECT_EQ(cutTo("a\u0308bc", 2), "a\u0308…");
  EXPECT_EQ(cutTo("ab", 1), "…");
  EXPECT_EQ(cutTo("ab", 0), "");
}

TEST(Coloured, MarksWhatALineBeginsWith) {
  EXPECT_EQ(coloured("  not met  order"), "  \x1b[1;31mnot met\x1b[m  order");
  EXPECT_EQ(coloured("  met      order"), "  \x1b[32mmet\x1b[m      order");
  EXPECT_EQ(coloured("note: it met"), "\x1b[33mnote:\x1b[m it met");
  EXPECT_EQ(coloured("it is not met "), "it is not met ");
}

TEST(WholeParagraphs, AreJoinedWhereALineGoesOn) {
  const std::string longLine(60, 'x');
  EXPECT_EQ(withWholeParagraphs(longLine + "\nends.\nExamples:\n  one\n\nlast"),
            longLine + " ends.\nExamples:\n  one\n\nlast");
  EXPECT_EQ(withWholeParagraphs(longLine + "\n  indented\n"), longLine + "\n  indented\n");
  EXPECT_EQ(withWholeParagraphs(longLine + "\n\nnext\n"), longLine + "\n\nnext\n");
}

TEST(TerminalText, LeavesWhatIsNoTerminal) {
  std::ostringstream stream;
  {
    TerminalText text(stream, -1);
    EXPECT_FALSE(text.isTerminal());
    stream << "  not met  " << std::string(200, 'x') << '\n';
  }
  EXPECT_EQ(stream.str(), "  not met  " + std::string(200, 'x') + '\n');
}

}  // namespace
}  // namespace rotatebook::cli
