// Wrong input, case by case: the exact message, exit status 2, and nothing written.
#include <ostream>
#include <string>
#include <vector>

#include "cli/program_test.h"

namespace rotatebook::cli::testing {
namespace {

using ::testing::IsEmpty;

struct BadCase {
  const char* name;
  std::vector<std::string> arguments;  ///< Of a render of tiny.toml, unless they begin otherwise.
  const char* message;                 ///< After "rotatebook: ".
};

void PrintTo(const BadCase& bad, std::ostream* stream) {
  *stream << bad.name;
}

const std::vector<BadCase> kOverrides{
    {"MisspeltKey",
     {"--set", "simulation.substep=3"},
     "--set simulation.substep=3: unknown key \"substep\" in [simulation]; did you mean "
     "\"substeps\"?"},
    {"MisspeltSection",
     {"--set", "bdy.mass=3"},
     "--set bdy.mass=3: unknown section \"bdy\"; did you mean \"body\"?"},
    {"WrongType",
     {"--set", "simulation.normalize=3"},
     "--set simulation.normalize=3: simulation.normalize must be true, false or a table such as { "
     "every = 100 }, not 3"},
    {"NotANumberAsSize",
     {"--set", "body.size=[nan, 1, 1]"},
     "--set body.size=[nan, 1, 1]: body.size must be three lengths from 1e-6 to 1e6 m, not nan"},
    {"NegativeSize",
     {"--set", "body.size=[1, -1, 1]"},
     "--set body.size=[1, -1, 1]: body.size must be three lengths from 1e-6 to 1e6 m, not -1"},
    {"NegativeMass",
     {"--set", "body.mass=-1"},
     "--set body.mass=-1: body.mass must be a mass from 1e-9 to 1e9 kg, not -1"},
    {"NoSubsteps",
     {"--set", "simulation.substeps=0"},
     "--set simulation.substeps=0: simulation.substeps must be an integer from 1 to 1000000, not "
     "0"},
    {"ZeroVector",
     {"--set", "initial.angular_momentum=[0, 0, 0]"},
     "--set initial.angular_momentum=[0, 0, 0]: initial.angular_momentum must be three numbers "
     "from -1e9 to 1e9, at least one other than 0, not [0, 0, 0]"},
    {"NoKey", {"--set", "substeps"}, "--set substeps: expected KEY=VALUE"},
    {"Several",
     {"--set", "x", "--size", "65x36", "--set", "video.crf=0", "--set", "title=\"a\u009b\u202eb\""},
     "--size 65x36: clip.size must be even, not 65; the nearest even sizes are 64 and 66\n"
     "  --set title=\"a\\u009B\\u202Eb\": title must be a string without control characters, not "
     "\"a\\u009B\\u202Eb\"\n"
     "  --set video.crf=0: video.crf must be an integer from 1 to 51, not 0\n"
     "  --set x: expected KEY=VALUE"},
    {"UnknownModel",
     {"--set", "simulation.model=matrx"},
     "--set simulation.model=matrx: simulation.model must be \"particles\", \"matrix\", "
     "\"quaternion\", \"exact\" or \"recorded\", not \"matrx\"; did you mean \"matrix\"?"},
};

const std::vector<BadCase> kOptions{
    {"OddSize",
     {"--size", "65x36"},
     "--size 65x36: clip.size must be even, not 65; the nearest even sizes are 64 and 66"},
    {"HugeSize",
     {"--size", "64x99998"},
     "--size 64x99998: clip.size must be an integer from 16 to 16384, not 99998"},
    {"SizeWithoutHeight",
     {"--size", "64"},
     "--size 64: not a size; write width x height, for example 640x360"},
    {"SizeOfThree",
     {"--size", "64x36x3"},
     "--size 64x36x3: not a size; write width x height, for example 640x360"},
    {"NegativePictureSize",
     {"--size=-64x36"},
     "--size -64x36: not a size; write width x height, for example 640x360"},
    {"FramesBeyondTheEnd", {"--frames", "5:13"}, "frames 5:13 don't exist; this clip has 0:12"},
    {"FramesBackwards", {"--frames", "9:5"}, "frames 9:5 don't exist; this clip has 0:12"},
    {"NoFrames", {"--frames", "5:5"}, "frames 5:5 don't exist; this clip has 0:12"},
    {"FramesWithoutEnd",
     {"--frames", "5"},
     "--frames 5: not a range; write first:end, for example 0:60 for the first 60 frames"},
    {"FramesOfWords",
     {"--frames", "a:b"},
     "--frames a:b: not a range; write first:end, for example 0:60 for the first 60 frames"},
    {"MissingTexture",
     {"--set", "book.front=no.png"},
     "--set book.front=no.png: can't read no.png: No such file or directory"},
    {"TextureThatIsNoPicture",
     {"--set", "book.back=tiny.toml"},
     "--set book.back=tiny.toml: can't read tiny.toml: neither PNG, JPEG nor WebP; "
     "convert it to one of them, e.g. with ImageMagick's convert"},
};

const std::vector<BadCase> kCommands{
    {"SceneNotFound", {"render", "nowhere.toml"}, "nowhere.toml: scene not found"},
    {"SceneNearlyFound",
     {"render", "tyny.toml"},
     "tyny.toml: scene not found; did you mean \"tiny.toml\"?"},
    {"EmptyArgument",
     {"render", "tiny.toml", "-o", ""},
     "argument 4, after -o, is empty; is it a variable that isn't set?"},
    {"SceneIsAFolder", {"render", "."}, ".: a folder, not a scene"},
    {"TimeAfterTheEnd",
     {"still", "tiny.toml", "--time", "0.3", "-o", "x.png"},
     "there is no picture at 0.3 s: the clip lasts from 0 to 0.2 s"},
    {"TimeBeforeTheBeginning",
     {"still", "tiny.toml", "--time", "-1", "-o", "x.png"},
     "there is no picture at -1 s: the clip lasts from 0 to 0.2 s"},
    {"TimeIsNotANumber",
     {"still", "tiny.toml", "--time", "nan", "-o", "x.png"},
     "there is no picture at nan s: the clip lasts from 0 to 0.2 s"},
    {"SimulateWrongScene",
     {"simulate", "tiny.toml", "--csv", "x.csv", "--set", "body.mass=0"},
     "--set body.mass=0: body.mass must be a mass from 1e-9 to 1e9 kg, not 0"},
    {"PrintWrongScene",
     {"check", "--print", "tiny.toml", "--set", "body.mass=0"},
     "--set body.mass=0: body.mass must be a mass from 1e-9 to 1e9 kg, not 0"},
    {"ListOfNothing",
     {"list", "nowhere"},
     "can't list the scenes in nowhere: No such file or directory; name a folder that holds "
     "scenes: rotatebook list DIR"},
    {"AssembleNothing",
     {"assemble", "nowhere", "-o", "x.mp4"},
     "can't read the folder nowhere: No such file or directory"},
    {"AssembleWithoutFrames",
     {"assemble", ".", "-o", "x.mp4"},
     ". holds no frames named like frame_00000.png"},
    {"AssembleAtNoRate",
     {"assemble", ".", "-o", "x.mp4", "--fps", "fast"},
     "--fps fast: not a frame rate; write for example 60 or 30000/1001"},
};

class BadInput : public ProgramTest, public ::testing::WithParamInterface<BadCase> {};

TEST_P(BadInput, IsRefusedWithOneLineAndNothingWritten) {
  std::vector<std::string> arguments = GetParam().arguments;
  if (arguments.front().starts_with("--"))
    arguments.insert(arguments.begin(), {"render", "tiny.toml"});
  const ChildResult result = run(arguments);
  EXPECT_EQ(result.status, 2);
  EXPECT_EQ(result.error, "rotatebook: " + std::string(GetParam().message) + "\n");
  EXPECT_THAT(result.output, IsEmpty());
  EXPECT_THAT(files(), IsEmpty());
}

const auto nameOfCase = [](const ::testing::TestParamInfo<BadCase>& bad) {
  return std::string(bad.param.name);
};
INSTANTIATE_TEST_SUITE_P(Overrides, BadInput, ::testing::ValuesIn(kOverrides), nameOfCase);
INSTANTIATE_TEST_SUITE_P(Options, BadInput, ::testing::ValuesIn(kOptions), nameOfCase);
INSTANTIATE_TEST_SUITE_P(Commands, BadInput, ::testing::ValuesIn(kCommands), nameOfCase);

/// Tests of scene files that are wrong in themselves.
class BadScene : public ProgramTest {
 protected:
  void expectRefused(const std::string& scene, const std::string& message) const {
    write("tiny.toml", scene);
    for (const char* command : {"render", "check"}) {
      const ChildResult result = run({command, "tiny.toml"});
      EXPECT_EQ(result.status, 2) << command;
      EXPECT_EQ(result.error, "rotatebook: tiny.toml" + message + "\n") << command;
      EXPECT_THAT(files(), IsEmpty()) << command;
    }
  }
};

TEST_F(BadScene, NamesLineAndColumn) {
  expectRefused(std::string(kTiny) + "[body]\n  mas = 2\n",
                ":8:3: unknown key \"mas\" in [body]; did you mean \"mass\"?");
  expectRefused(
      std::string(kTiny) + "[body]\nmass = 'heavy'\n",
      ":8:8: body.mass must be a mass from 1e-9 to 1e9 kg, not \"heavy\"; a text is a number and a "
      "unit, \"kg\" or \"g\", such as \"1.5 kg\"");
}

TEST_F(BadScene, NeedsExactlyOneSpin) {
  expectRefused("title = 'T'\n[initial]\ntilt = [0.1, 'z']\n",
                ":2:1: [initial] needs angular_velocity or angular_momentum");
  expectRefused("[initial]\nangular_velocity = [0, 0, 1]\nangular_momentum = [0, 0, 1]\n",
                ":1:1: [initial] has both angular_velocity and angular_momentum; keep one of them");
}

TEST_F(BadInput, TexturesThatAreCorruptAreNamed) {
  write("cut.png", "\x89PNG\r\n\x1a\n");
  const ChildResult result = run({"render", "tiny.toml", "--set", "book.spine=cut.png"});
  EXPECT_EQ(result.status, 2);
  EXPECT_EQ(result.error,
            "rotatebook: --set book.spine=cut.png: can't read cut.png: corrupt PNG: the file ends "
            "too early\n");
  EXPECT_THAT(files(), ::testing::ElementsAre("cut.png"));
}

TEST_F(BadScene, HasANameThatNoFileMayHave) {
  const std::string dot = " begins with a dot, as names of hidden files do; rename the file\n";
  const std::string line = " isn't a line of UTF-8 without control characters; rename the file\n";
  for (const auto& [file, problem] : std::vector<std::pair<std::string, std::string>>{
           {"..toml", "..toml: the scene's name \".\"" + dot},
           {".bashrc.toml", ".bashrc.toml: the scene's name \".bashrc\"" + dot},
           {"a\xff.toml", "a\uFFFD.toml: the scene's name \"a\uFFFD\"" + line},
           {"a\nb.toml", "a\\nb.toml: the scene's name \"a\\nb\"" + line},
           {"a\u009b2Kb.toml", "a\\u009B2Kb.toml: the scene's name \"a\\u009B2Kb\"" + line},
           {"a\u202eb.toml", "a\\u202Eb.toml: the scene's name \"a\\u202Eb\"" + line}}) {
    write(file, kTiny);
    const ChildResult result = run({"render", file});
    EXPECT_EQ(result.status, 2);
    EXPECT_EQ(result.error, "rotatebook: " + problem);
    std::filesystem::remove(folder() / file);
    EXPECT_THAT(files(), IsEmpty());
  }
}

class BadFrames : public ProgramTest {
 protected:
  BadFrames() { run({"render", "tiny.toml", "--no-mp4"}); }

  void expectRefused(const std::vector<std::string>& options, const std::string& message) const {
    std::vector<std::string> arguments{"assemble", "out/tiny", "-o", "x.mp4"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const auto before = files();
    const ChildResult result = run(arguments);
    EXPECT_EQ(result.status, 2);
    EXPECT_EQ(result.error, "rotatebook: " + message + "\n");
    EXPECT_EQ(files(), before);
  }
};

TEST_F(BadFrames, OfDifferingSizes) {
  run({"still", "tiny.toml", "--time", "0", "-o", "small.png", "--size", "32x18"});
  std::filesystem::rename(folder() / "small.png", folder() / "out/tiny/frame_00005.png");
  std::filesystem::remove(folder() / "out/tiny/frames.xxh128");
  expectRefused({},
                "frames differ in size: out/tiny/frame_00000.png is 64x36, "
                "out/tiny/frame_00005.png is 32x18");
}

TEST_F(BadFrames, WithAGap) {
  std::filesystem::remove(folder() / "out/tiny/frame_00003.png");
  expectRefused({}, "out/tiny: frame_00003.png is missing; frame_00004.png comes next");
}

TEST_F(BadFrames, OfTwoRates) {
  expectRefused({"--fps", "60"},
                "out/tiny/scene.toml sets the frame rate already; leave --fps out");
}

TEST_F(BadFrames, OfNoRate) {
  std::filesystem::remove(folder() / "out/tiny/scene.toml");
  expectRefused({}, "out/tiny has no scene.toml that sets the frame rate; give it with --fps");
}

}  // namespace
}  // namespace rotatebook::cli::testing
