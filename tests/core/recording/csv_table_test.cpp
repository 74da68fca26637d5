#include "recording/csv_table.h"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "recording/refusal.h"

namespace rotatebook::recording {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

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
  for (const std::string number : {"\"0,5\"", "\"1,000.5\"", "\"1.000,50\""}) {
    const std::string text = "a,b\n" + number + ",1\n";
    const CsvTable table(text, "t.csv");
    EXPECT_THAT(refusalOf([&] { table.at(0, 0, "write the times in s or ms"); }),
                HasSubstr("no finite number; write numbers without commas, such as 1000.5"));
  }
}

TEST(CsvTable, NamesTheLineOfWhatItRefuses) {
  EXPECT_EQ(tableRefusal(""),
            "t.csv: no rows below a header; a recording is a table of numbers (CSV)");
  EXPECT_EQ(tableRefusal("a,b\n"),
            "t.csv: no rows below a header; a recording is a table of numbers (CSV)");
  EXPECT_EQ(tableRefusal("a,b\n1,2\n\n3\n"), "t.csv:4: 1 cell, but the header names 2 columns");
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

TEST(CsvTable, SaysWhatIsNoText) {
  EXPECT_THAT(tableRefusal("\xD0\xCF\x11\xE0..."), HasSubstr("a workbook (.xls)"));
  EXPECT_THAT(tableRefusal("PK\x03\x04..."), HasSubstr("a ZIP archive"));
  EXPECT_EQ(tableRefusal("\x1F\x8B\x08..."), "t.csv: compressed by gzip; unpack it");
  EXPECT_THAT(tableRefusal("version https://git-lfs.github.com/spec/v1\noid sha256:4d7a\n"),
              HasSubstr("a pointer of git-lfs in the place of the table"));
  EXPECT_THAT(tableRefusal("<!DOCTYPE html>\n<html>"), HasSubstr("a web page; download the table"));
  for (const std::string& begin :
       {std::string("\xFF\xFE\0\0t\0\0\0", 8), std::string("\0\0\xFE\xFF\0\0\0t", 8),
        std::string("t\0\0\0,\0\0\0", 8), std::string("\0\0\0t\0\0\0,", 8)})
    EXPECT_THAT(tableRefusal(begin), HasSubstr("its text is in UTF-32; save it as UTF-8"));
  EXPECT_EQ(tableRefusal(std::string("a\0,\0b\0", 6)),
            "t.csv: its text is in UTF-16 without its byte order mark; save it as UTF-8 (\"CSV "
            "UTF-8\")");
}

TEST(CsvTable, KeepsAllDigits) {
  const CsvTable table("a\n1403636579758555392\n-1.5e3\n1.4e18\n+2.25E-2\n-0,75\n1e30\n1e-300\n0\n",
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
}

TEST(CsvTable, KnowsHoles) {
  const CsvTable table("a,b,c,d,e\n1,,NaN,null,x\n", "t.csv");
  for (std::size_t column = 0; column < 5; ++column)
    EXPECT_EQ(table.isHole(0, column), column >= 1 && column <= 3) << column;
}

TEST(CsvTable, RefusesCellsThatAreNoNumbers) {
  for (const char* cell : {"", "x", "nan", "inf", "1e999", "1 2", "0x10"}) {
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
