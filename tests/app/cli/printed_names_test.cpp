// Names of files and folders that would make a terminal do something, wherever they are printed.
#include <string>
#include <vector>

#include "base/text.h"
#include "cli/program_test.h"

namespace rotatebook::cli::testing {
namespace {

// A control character of C1, which clears a line in some terminals, a line end, and a stray byte.
const std::string kFolder =
    "o\xc2\x9b"
    "2K\nx\x9b";

class PrintedNames : public ProgramTest {
 protected:
  /// Expects that the command ends with `status` and prints nothing but lines that are safe.
  void expectSafe(const std::vector<std::string>& arguments, int status = 0) const {
    SCOPED_TRACE(arguments.front());
    const ChildResult result = run(arguments);
    EXPECT_EQ(result.status, status) << result.output << result.error;
    EXPECT_EQ(result.output, printable(result.output));
    EXPECT_EQ(result.error, printable(result.error));
    for (const std::string& text : {result.output, result.error}) {
      EXPECT_THAT(text, ::testing::Not(::testing::HasSubstr("2K\n")));
    }
  }
};

TEST_F(PrintedNames, AreEscapedInReports) {
  const std::string video = kFolder + "/tiny.mp4", picture = kFolder +
                                                             "/\x9b"
                                                             "2K.png";
  expectSafe({"render", "tiny.toml", "-o", kFolder});
  expectSafe({"render", "tiny.toml", "-o", kFolder, "--set", "clip.duration=0.1"});
  expectSafe({"simulate", "tiny.toml", "--csv", kFolder + "/t.csv"});
  expectSafe({"study", "tiny.toml", "--steps", "1,2", "--integrators", "rk4", "-o", kFolder});
  expectSafe({"page", "tiny.toml", "-o", kFolder, "--set", "clip.duration=0.1"});
  expectSafe({"still", "tiny.toml", "-o", picture});
  expectSafe({"still", "tiny.toml", "--count", "1", "-o", picture});
  expectSafe({"diff", picture, picture, "-o", kFolder + "/d.png"});
  expectSafe({"assemble", kFolder + "/tiny", "-o", kFolder + "/a.mp4"});
  expectSafe({"verify", video});
  expectSafe({"verify", video, "--again", kFolder + "/again"});
  expectSafe({"check", kFolder}, 2);
  expectSafe({"check", kFolder + "/none.toml"}, 2);
  expectSafe({"bench", kFolder + "/none.toml"}, 2);
  expectSafe({"check", "--print", kFolder + "/tiny/scene.toml"});
  expectSafe({"doctor", "-o", kFolder});
}

TEST_F(PrintedNames, AreEscapedInProgress) {
  if (const std::string why = whyNoTerminal(); !why.empty()) GTEST_SKIP() << why;
  ASSERT_EQ(run({"render", "tiny.toml", "-o", kFolder}).status, 0);
  ChildSettings settings;
  settings.terminal = true;
  const ChildResult result =
      run({"assemble", kFolder + "/tiny", "-o", kFolder + "/a.mp4"}, settings);
  EXPECT_THAT(result.error, ::testing::HasSubstr("12/12 frames"));
  EXPECT_EQ(result.error, validUtf8(result.error));
  EXPECT_EQ(result.error.find("\xc2\x9b"), std::string::npos);
}

}  // namespace
}  // namespace rotatebook::cli::testing
