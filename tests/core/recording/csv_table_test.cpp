#include "recording/csv_table.h"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "messages.h"
#include "recording/refusal.h"

namespace rotatebook::recording {
namespace {

using ::testing::ElementsAre;

std::string tableRefusal(const std::string& text) {
  return refusalOf([&] { CsvTable(text, "t.csv"); });
}

TEST(CsvTable, ReadsCommasTabsAndSemicolons) {
  for (const char* const text :
       {"a,b\n1,2.5\n", "a\tb\n1\t2.5\n", "a;b\n1;2.5\n", "\"a\",\"b\"\r\n1,2.5\r\n",
        "\xEF\xBB\xBF# made\n\na,b\n\n1,2.5"}) {
    const CsvTable table(text, "t.csv");
    EXPECT_THAT(table.header(), ElementsAre("a", "b")) << text;
    ASSERT_EQ(table.rows(), 1U) << text;
    EXPECT_EQ(table.at(0, 0), 1) << text;
    EXPECT_EQ(table.at(0, 1), 2.5) << text;
  }
}

TEST(CsvTable, ReadsDecimalCommasWhereCommasDontSeparate) {
  const std::string text = "\"Time (s)\";\"x\"\n\"0,5\";-1,25E-3\n";
  const CsvTable table(text, "t.csv");
  EXPECT_EQ(table.at(0, 0), 0.5);
  EXPECT_EQ(table.at(0, 1), -1.25e-3);
}

TEST(CsvTable, CommasInNumbersAreNoMatterOfUnits) {
  for (const std::string number : {"\"0,5\"", "\"1,000.5\"", "\"1.000,50\"", "1'000.5",
                                   "1\xE2\x80\xAF"
                                   "000.5"}) {
    const std::string text = "a,b\n" + number + ",1\n";
    const CsvTable table(text, "t.csv");
    EXPECT_MESSAGE(refusalOf([&] { table.at(0, 0, "write the times in s or ms"); }));
  }
}

TEST(CsvTable, NamesTheLineOfWhatItRefuses) {
  EXPECT_EQ(tableRefusal(""),
            "t.csv: no rows below a header; a recording is a table of numbers (CSV)");
  EXPECT_EQ(tableRefusal("a,b\n"),
            "t.csv: no rows below a header; a recording is a table of numbers (CSV)");
  EXPECT_EQ(tableRefusal("a,b\n1,2\n\n3\n4,5\n"),
            "t.csv:4: 1 cell, but the header names 2 columns; leave such rows out");
  EXPECT_EQ(tableRefusal("a,b,c\n1,2\n3,4\n"),
            "t.csv:2: 2 cells, but the header names 3 columns; give each column a cell in every "
            "row");
  EXPECT_EQ(tableRefusal("a,b\n0,5,1,5\n"),
            "t.csv:2: 4 cells, but the header names 2 columns; name them all, or, if numbers have "
            "decimal commas, separate the cells by semicolons");
  EXPECT_EQ(tableRefusal(std::string(3 * kMaxColumns, ',') + "\n"), "t.csv: more than 256 columns");
  EXPECT_EQ(tableRefusal(std::string(kLargestRecording + 1, ' ')),
            "t.csv: longer than 16 MiB, the limit for a recording; export a part of it");
}

TEST(CsvTable, FindsItsHeader) {
  for (const char* const text :
       {"sep=,\na,b\n1,2.5\n", "\"sep=;\"\na;b\n1;2.5\n", "# made\n# a,b\n1,2.5\n",
        "#a b\n1  2.5\n", "a b\n 1\t2.5 \n", "a,b,\n1,2.5,\n", "a,b\n1,2.5,\n", "a,b,,\n1,2.5\n",
        "a,b\n# in s, in m\n1,2.5\n", "My data,\n\na,b\n1,2.5\n"}) {
    const CsvTable table(text, "t.csv");
    EXPECT_EQ(table.at(0, 0), 1) << text;
    EXPECT_EQ(table.at(0, 1), 2.5) << text;
    EXPECT_EQ(table.rows(), 1U) << text;
  }
  const CsvTable table("sep=,\nDeviceTag:,Xsens DOT 1\n\na,b,c\n1,2.5,3\n", "t.csv");
  EXPECT_THAT(table.header(), ElementsAre("a", "b", "c"));
  EXPECT_EQ(refusalOf([&] { table.failAt(0, "x"); }), "t.csv:5: x");
  EXPECT_THAT(CsvTable("t;x (\xB0/s)\n0;1\n", "t.csv").header(),
              ElementsAre("t", "x (\xC2\xB0/s)"));
  EXPECT_EQ(tableRefusal("2.9 18.5 7.6\n3.0 18.4 7.5\n"),
            "t.csv:1: a row of numbers, but no line above it names its columns; add one, such as "
            "\"time_s,wx,wy,wz\"");
}

TEST(CsvTable, FillsRowsThatAreCutAtItsEnd) {
  for (const std::string end : {"3,", "3", "END", "END\n\n", "3,4\nEND"}) {
    const std::string text = "a,b,c\n1,2,5\n" + end;
    const CsvTable table(text, "t.csv");
    EXPECT_GT(table.rows(), 1U) << end;
    EXPECT_TRUE(table.isHole(table.rows() - 1, 2)) << end;
  }
}

TEST(CsvTable, FindsItsHeaderBelowWhatElseIsThere) {
  for (const char* const text :
       {"ESP-ROM:esp32s3\nBuild:Mar 27 2021\n\na,b\n1,2.5\n",  // a log of a boot
        "3.2,4.5,7\na,b\n1,2.5\n",                             // a row that is cut
        "Objects\n100\na,b\n1,2.5\n", "x,x\na,b\n1,2.5\n", "// made\n// a b\n1 2.5\n",
        "% a b\n1 2.5\n% c d\n", "a|b\n1|2.5\n", "x,y,z\na,b\n1,2.5\n"}) {
    const CsvTable table(text, "t.csv");
    EXPECT_THAT(table.header(), ElementsAre("a", "b")) << text;
    EXPECT_EQ(table.at(0, 1), 2.5) << text;
    EXPECT_EQ(table.rows(), 1U) << text;
  }
  EXPECT_MESSAGE(tableRefusal("1,2\n2,3\n3,4\n4,5\na,b\n5,6\n"));
}

TEST(CsvTable, TellsColumnsApartByTheLineAbove) {
  const std::string beginning =
      ",,Rigid Body,Rigid Body,Rigid Body\n,,Rotation,Rotation,Position\n";
  EXPECT_THAT(CsvTable(beginning + "Frame,Time (Seconds),X,Y,X\n0,0,1,2,3\n", "t.csv").header(),
              ElementsAre("Frame", "Time (Seconds)", "Rotation X", "Rotation Y", "Position X"));
  EXPECT_THAT(CsvTable("a,a,a\nx,y,x\n0,1,2\n", "t.csv").header(), ElementsAre("x", "y", "x"));
}

TEST(CsvTable, SaysWhatIsNoText) {
  EXPECT_MESSAGE(tableRefusal("\xD0\xCF\x11\xE0..."));
  EXPECT_MESSAGE(tableRefusal("PK\x03\x04..."));
  EXPECT_EQ(tableRefusal("\x1F\x8B\x08..."), "t.csv: compressed by gzip; unpack it");
  EXPECT_MESSAGE(tableRefusal("version https://git-lfs.github.com/spec/v1\noid sha256:4d7a\n"));
  EXPECT_MESSAGE(tableRefusal("[{\"t\":0}]"));
  EXPECT_MESSAGE(tableRefusal("<!DOCTYPE html>\n<html>"));
  for (const std::string& begin :
       {std::string("\xFF\xFE\0\0t\0\0\0", 8), std::string("\0\0\xFE\xFF\0\0\0t", 8),
        std::string("t\0\0\0,\0\0\0", 8), std::string("\0\0\0t\0\0\0,", 8)})
    EXPECT_MESSAGE(tableRefusal(begin));
  EXPECT_EQ(tableRefusal(std::string("a\0,\0b\0", 6)),
            "t.csv: its text is in UTF-16 without its byte order mark; save it as UTF-8 (\"CSV "
            "UTF-8\")");
}

TEST(CsvTable, KeepsAllDigits) {
  const CsvTable table(
      "a\n1403636579758555392\n-1.5e3\n1.4e18\n+2.25E-2\n-0,75\n1e30\n1e-300\n0\n-1.5D+03\n"
      "\xE2\x88\x92"
      "2,5\n",
      "t.csv");
  const auto whole = [&](std::size_t row) { return table.decimalAt(row, 0).value().whole; };
  const auto rest = [&](std::size_t row) { return table.decimalAt(row, 0).value().rest; };
  EXPECT_EQ(whole(0), 1403636579758555392);
  EXPECT_EQ(whole(1), -1500);
  EXPECT_EQ(whole(2), 1400000000000000000);
  EXPECT_EQ(rest(3), 0.0225);
  EXPECT_EQ(rest(4), -0.75);
  EXPECT_FALSE(table.decimalAt(5, 0).has_value());
  EXPECT_EQ(rest(6), 1e-300);
  EXPECT_EQ(whole(7), 0);
  EXPECT_EQ(whole(8), -1500);  // Fortran's
  EXPECT_EQ(table.at(8, 0), -1500);
  EXPECT_EQ(table.at(9, 0), -2.5);  // U+2212
  EXPECT_EQ(rest(9), -0.5);
}

TEST(CsvTable, KnowsHoles) {
  const CsvTable table(
      "a,b,c,d,e,f,g,h,i\n1,,NaN,null,x,2,3,4,5\n1,-nan(ind),1.#QNAN,#N/A,?,N/A,None,-,<NA>\n",
      "t.csv");
  for (std::size_t column = 0; column < 9; ++column) {
    EXPECT_EQ(table.isHole(0, column), column >= 1 && column <= 3) << column;
    EXPECT_EQ(table.isHole(1, column), column >= 1 && column != 4) << column;
  }
}

TEST(CsvTable, RefusesCellsThatAreNoNumbers) {
  for (const char* cell : {"", "x", "nan", "inf", "1e999", "1 x", "0x10"}) {
    const std::string text = std::string("a,b\n1,") + cell + "\n";
    const CsvTable table(text, "t.csv");
    EXPECT_EQ(refusalOf([&] { table.at(0, 1); }),
              std::string("t.csv:2: the column \"b\" has \"") + cell +
                  "\", which is no finite number; leave such rows out");
  }
}

TEST(CsvTable, RefusesMoreRowsThanItsLimit) {
  std::string text = "a\n";
  for (std::size_t row = 0; row < kMaxRows; ++row) text += "1\n";
  EXPECT_EQ(tableRefusal(text), "");
  EXPECT_EQ(tableRefusal(text + "1\n"), "t.csv: more than 1000000 rows; export a part of it");
}

}  // namespace
}  // namespace rotatebook::recording
