#include "picture/gnuplot.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "image/png_file.h"
#include "pipeline/small_clip.h"

namespace rotatebook::picture {
namespace {

using pipeline::testing::bytesOf;
using pipeline::testing::emptyFolder;
using pipeline::testing::messageOf;
using pipeline::testing::namesIn;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::StartsWith;

/// Another PATH, for as long as it lives.
class PathVariable {
 public:
  explicit PathVariable(const std::string& value) {
    if (const char* old = std::getenv("PATH")) old_ = old;
    setenv("PATH", value.c_str(), 1);
  }
  PathVariable(const PathVariable&) = delete;
  PathVariable& operator=(const PathVariable&) = delete;
  ~PathVariable() { old_ ? setenv("PATH", old_->c_str(), 1) : unsetenv("PATH"); }

 private:
  std::optional<std::string> old_;
};

TEST(Gnuplot, DrawsBothPictures) {
  const auto folder = emptyFolder();
  drawPlot("plot x\n", folder / "a.svg", folder / "a.png");
  EXPECT_THAT(namesIn(folder), ElementsAre("a.png", "a.svg"));
  const image::Image picture = image::readPng(folder / "a.png");
  EXPECT_EQ(picture.view().width, 1800);
  EXPECT_EQ(picture.view().height, 900);
  EXPECT_THAT(bytesOf(folder / "a.svg"), StartsWith("<?xml"));
  EXPECT_THAT(bytesOf(folder / "a.svg"), HasSubstr("</svg>"));
}

TEST(Gnuplot, TakesPathsOfAnyLetters) {
  const auto folder = emptyFolder() / "it's \"a\" $HOME `folder`";
  std::filesystem::create_directories(folder);
  drawPlot("plot x\n", folder / "|a.svg", folder / "a'.png");
  EXPECT_THAT(namesIn(folder), ElementsAre("a'.png", "|a.svg"));
}

TEST(Gnuplot, PassesItsWordsOn) {
  const auto folder = emptyFolder();
  const std::string message = messageOf<MachineError>(
      [&] { drawPlot("plot nonsense(x)\n", folder / "a.svg", folder / "a.png"); });
  EXPECT_THAT(message, StartsWith("gnuplot can't draw " + (folder / "a.svg").string()));
  EXPECT_THAT(message, HasSubstr("undefined function: nonsense"));
  EXPECT_THAT(namesIn(folder), IsEmpty());
}

TEST(Gnuplot, NamesThePackageWhereItIsMissing) {
  const auto folder = emptyFolder();
  const PathVariable path(folder.string());
  EXPECT_EQ(
      messageOf<MachineError>([&] { drawPlot("plot x\n", folder / "a.svg", folder / "a.png"); }),
      "can't draw the plot: gnuplot isn't installed; apt-get install gnuplot-nox");
  EXPECT_THAT(namesIn(folder), IsEmpty());
}

/// Writes a program named gnuplot that prints `message`.
void writeGnuplot(const std::filesystem::path& folder, const std::string& message, int status) {
  std::ofstream(folder / "gnuplot")
      << "#!/bin/sh\necho '" << message << "'\nexit " << status << "\n";
  std::filesystem::permissions(folder / "gnuplot", std::filesystem::perms::owner_all);
}

TEST(Gnuplot, TakesNothingElseForAPicture) {
  const auto folder = emptyFolder();
  const PathVariable path(folder.string());
  const auto messageFor = [&](int status) {
    writeGnuplot(folder, "<svg> no more", status);
    return messageOf<MachineError>(
        [&] { drawPlot("plot x\n", folder / "a.svg", folder / "a.png"); });
  };
  const std::string start = "gnuplot can't draw " + (folder / "a.svg").string();
  EXPECT_EQ(messageFor(0), start +
                               " (status 0): the picture is incomplete; is the file size limited "
                               "(ulimit -f)?");
  EXPECT_EQ(messageFor(7), start + " (status 7)");
  EXPECT_THAT(namesIn(folder), ElementsAre("gnuplot"));
}

// Whatever a title says, it is drawn.
TEST(GnuplotString, LetsATextRunNothing) {
  const auto folder = emptyFolder();
  const std::string mark = (folder / "ran").string();
  const std::vector<std::string> titles{
      "`touch " + mark + "`",
      "'; system('touch " + mark + "') #",
      "''; system 'touch " + mark + "'",
      "\\'; system(\"touch " + mark + "\")",
      "\n!touch " + mark + "\n",
      "\nsystem(\"touch " + mark + "\")\n",
      "@X ${X} $(touch " + mark + ")",
      "\"; `touch " + mark + "`; \"",
  };
  std::string commands;
  for (std::size_t i = 0; i < titles.size(); ++i) {
    commands += "set label " + std::to_string(i + 1) + " " + gnuplotString(titles[i]) +
                " at screen 0.5,0.5 noenhanced\n";
  }
  drawPlot(commands + "plot x title " + gnuplotString(titles[1]) + "\n", folder / "a.svg",
           folder / "a.png");
  EXPECT_THAT(namesIn(folder), ElementsAre("a.png", "a.svg"));
  EXPECT_THAT(bytesOf(folder / "a.svg"), HasSubstr("`touch "));
}

TEST(GnuplotString, QuotesWhatGnuplotWouldRead) {
  EXPECT_EQ(gnuplotString("plain"), "'plain'");
  EXPECT_EQ(gnuplotString("it's \"so\" \\n `date`"), "'it’s \"so\" \\n `date`'");
  EXPECT_EQ(gnuplotString("two\nlines\t"), "'two lines '");
}

}  // namespace
}  // namespace rotatebook::picture
