// `rotatebook export`.
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "cli/program_test.h"
#include "messages.h"

namespace rotatebook::cli::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::StartsWith;

using ExportCommand = ProgramTest;

TEST_F(ExportCommand, WritesAGlbAndSaysWhatIsInIt) {
  const ChildResult result = runWithoutGraphics({"export", "tiny.toml", "-o", "book.glb"});
  EXPECT_EQ(result.status, 0) << result.error;
  EXPECT_THAT(result.output, StartsWith("tiny: wrote book.glb, "));
  EXPECT_THAT(result.output, HasSubstr(" KB: 12 keys in 0.1833 s, at most "));
  EXPECT_THAT(result.error, IsEmpty());
  EXPECT_THAT(read("book.glb"), StartsWith("glTF"));
  EXPECT_THAT(files(), ElementsAre("book.glb"));
}

TEST_F(ExportCommand, ReplacesItsOwnFilesAlone) {
  EXPECT_EQ(run({"export", "tiny.toml"}).status, 0);
  const ChildResult again = run({"export", "tiny.toml", "--tangents"});
  EXPECT_EQ(again.status, 0);
  EXPECT_EQ(again.error, "note: replaced tiny.glb\n");
  EXPECT_THAT(read("tiny.glb"), HasSubstr("CUBICSPLINE"));
  write("tiny.glb", "glTF of another program");
  const ChildResult refused = run({"export", "tiny.toml"});
  EXPECT_EQ(refused.status, 2);
  EXPECT_MESSAGE(refused.error);
  EXPECT_EQ(read("tiny.glb"), "glTF of another program");
}

TEST_F(ExportCommand, WritesUsdzByItsEnding) {
  const ChildResult result = runWithoutGraphics({"export", "tiny.toml", "-o", "book.usdz"});
  EXPECT_EQ(result.status, 0) << result.error;
  EXPECT_THAT(result.output, StartsWith("tiny: wrote book.usdz, "));
  EXPECT_THAT(read("book.usdz"), StartsWith("PK"));
  EXPECT_EQ(run({"export", "tiny.toml", "-o", "book.usdz"}).status, 0);
  write("book.usdz", "PK of another program");
  EXPECT_EQ(run({"export", "tiny.toml", "-o", "book.usdz"}).status, 2);
  EXPECT_EQ(read("book.usdz"), "PK of another program");
}

TEST_F(ExportCommand, SaysOfABodyThatDeformsHowFarItsCornersAreOff) {
  const std::vector<std::string> command{"export", "tiny.toml",
                                         "-o",     "soft.glb",
                                         "--set",  "simulation.model=particles",
                                         "--set",  "simulation.stiffness=4"};
  EXPECT_THAT(run(command).output, HasSubstr(" mm off at a corner between them\n"));
}

TEST_F(ExportCommand, PrintsJson) {
  const ChildResult result = run({"export", "tiny.toml", "-o", "book.glb", "--json"});
  const nlohmann::json object = nlohmann::json::parse(result.output);
  EXPECT_EQ(object["file"], "book.glb");
  EXPECT_EQ(object["bytes"], read("book.glb").size());
  EXPECT_EQ(object["keys"], 12);
  EXPECT_LT(object["error_deg"], 0.05);  // measured 0.030
  EXPECT_TRUE(object["error_m"].is_null());
  EXPECT_TRUE(object["panel"].is_null());
  EXPECT_TRUE(object["notes"].empty());
}

TEST_F(ExportCommand, TakesAPanelByLabelOrNumber) {
  write("tiny.toml", std::string(kTiny) +
                         "[[panel]]\nlabel = \"one\"\n[[panel]]\nlabel = \"1\"\n"
                         "body.mass = 2\n");
  EXPECT_THAT(run({"export", "tiny.toml", "-o", "a.glb"}).output, HasSubstr(" KB: one, 12 keys"));
  EXPECT_THAT(run({"export", "tiny.toml", "-o", "a.glb", "--panel", "1"}).output,
              HasSubstr(" KB: 1, 12 keys"));
  EXPECT_THAT(run({"export", "tiny.toml", "-o", "a.glb", "--panel", "2"}).output,
              HasSubstr(" KB: 1, 12 keys"));
  const ChildResult wrong = run({"export", "tiny.toml", "-o", "b.glb", "--panel", "3"});
  EXPECT_EQ(wrong.status, 2);
  EXPECT_EQ(
      wrong.error,
      "rotatebook: --panel 3: tiny has no such panel; take one of \"one\", \"1\", or a number "
      "from 1 to 2\n");
  EXPECT_FALSE(has("b.glb"));
}

}  // namespace
}  // namespace rotatebook::cli::testing
