// `rotatebook doctor`, and --device and --require-hardware of the commands that draw.
#include <csignal>
#include <string>
#include <vector>

extern "C" {
#include <libavformat/version.h>
}

#include "cli/program_test.h"

namespace rotatebook::cli::testing {
namespace {

using ::testing::AllOf;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::StartsWith;

using DoctorCommand = ProgramTest;

/// Mesa's software rasteriser alone, whatever cards this machine has.
constexpr std::pair<const char*, const char*> kMesaAlone{
    "__EGL_VENDOR_LIBRARY_FILENAMES", "/usr/share/glvnd/egl_vendor.d/50_mesa.json"};

TEST_F(DoctorCommand, FindsThatThisMachineRenders) {
  const ChildResult result = run({"doctor"});
  EXPECT_EQ(result.status, 0) << result.output << result.error;
  EXPECT_THAT(result.output,
              AllOf(StartsWith("rotatebook "), HasSubstr("\ngraphics\n  EGL device 0 "),
                    HasSubstr("; draws by default\n"), HasSubstr(" reference picture right: "),
                    HasSubstr("\n  mp4                  libx264\n"),
                    HasSubstr("\n  output folder        out, "), HasSubstr("\nReady to render: "),
                    Not(HasSubstr("WRONG"))));
  EXPECT_THAT(result.error, IsEmpty());
  EXPECT_THAT(files(), IsEmpty());
}

TEST_F(DoctorCommand, ReportsTheCauseAndTheRemedyWithoutGraphics) {
  const ChildResult result = runWithoutGraphics({"doctor"});
  EXPECT_EQ(result.status, 3);
  EXPECT_THAT(
      result.output,
      AllOf(HasSubstr("\n  1. __EGL_VENDOR_LIBRARY_FILENAMES=/nonexistent names no EGL driver"),
            HasSubstr("\n     remedy: unset __EGL_VENDOR_LIBRARY_FILENAMES,"),
            Not(HasSubstr("\n  2. ")),
            EndsWith("\nNOT READY to render: nothing draws as it should.\n")));
}

TEST_F(DoctorCommand, UnsetsTheVariableThatKeepsMesaFromDrawing) {
  for (const auto& [name, value] : {std::pair{"MESA_GL_VERSION_OVERRIDE", "2.1"},
                                    {"GALLIUM_DRIVER", "none-such"},
                                    {"GALLIUM_NOOP", "1"}}) {
    ChildSettings settings;
    settings.environment = {kMesaAlone, {name, value}};
    const ChildResult result = run({"doctor", "--json"}, settings);
    EXPECT_EQ(result.status, 3) << name;
    EXPECT_THAT(result.output,
                HasSubstr(std::string("\"remedy\":\"unset ") + name + " (it is " + value + ")"));
  }
}

TEST_F(DoctorCommand, ReportsAllElseWithoutFfmpeg) {
  const std::string format = AV_STRINGIFY(LIBAVFORMAT_VERSION_MAJOR);
  write("libavformat.so." + format, "no library");
  ChildSettings broken;
  broken.environment = {{"LD_LIBRARY_PATH", folder().string()}};
  const ChildResult result = run({"doctor"}, broken);
  EXPECT_EQ(result.status, 3);
  EXPECT_THAT(result.output,
              AllOf(HasSubstr("; draws by default\n"), HasSubstr("\n  mp4                  none\n"),
                    HasSubstr("\n  apng                 none\n"),
                    HasSubstr("\n  1. mp4, webm, gif, apng, prores, hevc, av1: can't load FFmpeg:"),
                    HasSubstr("libavformat.so." + format), HasSubstr("\n     remedy: install "),
                    HasSubstr("libavformat" + format + ","), Not(HasSubstr("\n  2. ")),
                    EndsWith("\nNOT READY to render: MP4 can't be encoded.\n")));
  const ChildResult json = run({"doctor", "--json"}, broken);
  EXPECT_EQ(json.status, 3);
  EXPECT_THAT(json.output,
              AllOf(StartsWith("{\"ready\":false,"), HasSubstr("\"reference_picture\":"),
                    HasSubstr("{\"format\":\"webm\",\"encoder\":null,"
                              "\"error\":\"can't load FFmpeg: ")));
}

TEST_F(DoctorCommand, TriesToWriteWhereNothingCanBe) {
  const ChildResult result = run({"doctor", "-o", "/proc"});
  EXPECT_EQ(result.status, 3);
  EXPECT_THAT(result.output,
              AllOf(HasSubstr("can't write /proc/"), HasSubstr("name a folder that you may write"),
                    EndsWith("\nNOT READY to render: the output folder can't be written.\n")));
}

TEST_F(DoctorCommand, LeavesNothingWhereItTriesToWrite) {
  EXPECT_EQ(run({"doctor", "-o", "."}).status, 0);
  EXPECT_EQ(run({"doctor", "-o", "new/folder"}).status, 0);
  EXPECT_THAT(files(), IsEmpty());
}

// As some that start services have it.
TEST_F(DoctorCommand, HearsOfProcessesThoughTheirEndWasIgnored) {
  ChildSettings settings;
  settings.ignoredSignal = SIGCHLD;
  const ChildResult result = run({"doctor"}, settings);
  EXPECT_EQ(result.status, 0) << result.error;
  EXPECT_THAT(result.output, HasSubstr("\nReady to render: "));
}

TEST_F(DoctorCommand, IsJsonToo) {
  const ChildResult result = run({"doctor", "--json"});
  EXPECT_EQ(result.status, 0) << result.error;
  EXPECT_THAT(result.output,
              AllOf(StartsWith("{\"ready\":true,\"version\":"),
                    HasSubstr("\"name\":\"EGL device 0\",\"device\":0,"),
                    HasSubstr("\"reference_picture\":{\"passed\":true,"),
                    HasSubstr("{\"format\":\"mp4\",\"encoder\":\"libx264\","), EndsWith("]}\n")));
  EXPECT_EQ(countOf("\n", result.output), 1);
  EXPECT_THAT(runWithoutGraphics({"doctor", "--json"}).output,
              AllOf(StartsWith("{\"ready\":false,"), HasSubstr("\"remedy\":\"unset ")));
}

TEST_F(DoctorCommand, ReportsAFolderThatCannotBe) {
  const ChildResult result = run({"doctor", "-o", "tiny.toml/out"});
  EXPECT_EQ(result.status, 3);
  EXPECT_THAT(result.output,
              AllOf(HasSubstr("\n     remedy: name a folder that you may write, with -o DIR\n"),
                    EndsWith("\nNOT READY to render: the output folder can't be written.\n")));
}

class DeviceOption : public ProgramTest {
 protected:
  /// On Mesa alone.
  ChildResult draw(const std::vector<std::string>& more) const {
    std::vector<std::string> words{"still", "tiny.toml", "--time", "0", "-o", "x.png"};
    words.insert(words.end(), more.begin(), more.end());
    ChildSettings settings;
    settings.environment.emplace_back(kMesaAlone);
    return run(words, settings);
  }
};

TEST_F(DeviceOption, SoftwareGivesTheSamePicture) {
  EXPECT_EQ(draw({}).status, 0);
  const std::string picture = read("x.png");
  const ChildResult result = draw({"--device", "software"});
  EXPECT_EQ(result.status, 0) << result.error;
  EXPECT_THAT(result.error, IsEmpty());
  EXPECT_TRUE(read("x.png") == picture);
}

// By a driver that does nothing and reports no error, at a size at which a book may be of one
// colour.
TEST_F(DeviceOption, IsRefusedWhereItDrawsNothing) {
  ChildSettings settings;
  settings.environment = {kMesaAlone, {"GALLIUM_NOOP", "1"}};
  for (const auto& words :
       std::vector<std::vector<std::string>>{{"render", "tiny.toml"},
                                             {"render", "tiny.toml", "--size", "16x16"},
                                             {"render", "tiny.toml", "--size", "640x360", "--set",
                                              "look.background=transparent", "--format", "webm"},
                                             {"still", "tiny.toml", "-o", "x.png", "--count", "2"},
                                             {"still", "tiny.toml", "--time", "0", "-o", "x.png"},
                                             {"bench", "tiny.toml"}}) {
    const ChildResult result = run(words, settings);
    EXPECT_EQ(result.status, 3) << words[0];
    EXPECT_THAT(result.error, AllOf(StartsWith("rotatebook: can't draw: NOOP, OpenGL "),
                                    HasSubstr(" reports no error and draws nothing: "),
                                    HasSubstr("--device"), HasSubstr("Run 'rotatebook doctor'")))
        << words[0];
    EXPECT_THAT(files(), IsEmpty()) << words[0];
  }
}

class DriverCrash : public ProgramTest {
 protected:
  /// Runs with a driver of OpenGL 4.5 that lacks the entry points of `extension`.
  ChildResult runWithout(const std::string& extension,
                         const std::vector<std::string>& words) const {
    ChildSettings settings;
    settings.environment = {kMesaAlone, {"MESA_EXTENSION_OVERRIDE", "-" + extension}};
    return run(words, settings);
  }
};

constexpr const char* kFramebuffers = "GL_ARB_framebuffer_object";
constexpr const char* kSanitizer = "Sanitizer";  // They report a crash in their own words.

TEST_F(DriverCrash, IsExplainedAsByTheDoctor) {
  for (const std::string extension :
       {kFramebuffers, "GL_ARB_map_buffer_range", "GL_ARB_uniform_buffer_object"}) {
    for (const auto& words : std::vector<std::vector<std::string>>{
             {"render", "tiny.toml"},
             {"still", "tiny.toml", "--time", "0", "-o", "x.png", "--device", "software"}}) {
      const ChildResult result = runWithout(extension, words);
      if (result.error.find(kSanitizer) != std::string::npos) GTEST_SKIP();
      EXPECT_EQ(result.status, 3) << extension;
      EXPECT_THAT(
          result.error,
          StartsWith("rotatebook: can't draw: EGL device 0 (software): its driver: ends the "
                     "process (Segmentation fault)\n  remedy: unset MESA_EXTENSION_OVERRIDE "
                     "(it is -" +
                     extension + "); if that doesn't help: update Mesa "));
      EXPECT_EQ(result.error.ends_with(": go on with the same command and --resume\n"),
                words[0] == "render");
      EXPECT_THAT(result.output, IsEmpty());
      EXPECT_THAT(files(), IsEmpty()) << extension;
    }
  }
}

TEST_F(DriverCrash, IsExplainedByEveryCommandThatDraws) {
  ASSERT_EQ(run({"render", "tiny.toml"}).status, 0);
  const std::vector<std::string> before = files();
  for (const auto& words :
       std::vector<std::vector<std::string>>{{"verify", "out/tiny.mp4", "--json"},
                                             {"verify", "out/tiny.mp4", "--again", "again"},
                                             {"still", "tiny.toml", "-o", "x.png", "--count", "2"},
                                             {"page", "tiny.toml"},
                                             {"bench", "tiny.toml"}}) {
    const ChildResult result = runWithout(kFramebuffers, words);
    if (result.error.find(kSanitizer) != std::string::npos) GTEST_SKIP();
    EXPECT_EQ(result.status, 3) << words[0];
    EXPECT_THAT(result.error, HasSubstr("\n  remedy: unset MESA_EXTENSION_OVERRIDE ")) << words[0];
    EXPECT_EQ(files(), before) << words[0];
  }
}

TEST_F(DriverCrash, IsToldFromOneOfTheProgram) {
  ChildSettings settings;
  settings.environment.emplace_back(kMesaAlone);
  settings.signalWhen = [this] { return has("out/tiny.partial/frame_00002.png"); };
  settings.signal = SIGSEGV;
  const std::vector<std::string> render{"render", "tiny.toml", "--set", "clip.duration=20"};
  const ChildResult result = run(render, settings);
  if (result.error.find(kSanitizer) != std::string::npos) GTEST_SKIP();
  EXPECT_EQ(result.status, 128 + SIGSEGV);
  EXPECT_THAT(result.error, HasSubstr("/rotatebook(+0x"));
  EXPECT_THAT(result.error, HasSubstr("rotatebook: crashed, in its own code or in a driver"));
}

TEST_F(DriverCrash, OfTheStackIsPrevented) {
  ChildSettings settings;
  settings.stack = 100 << 10;
  const ChildResult result = run({"still", "tiny.toml", "--time", "0", "-o", "x.png"}, settings);
  EXPECT_EQ(result.status, 3);
  EXPECT_EQ(result.error,
            "rotatebook: the stack is limited to 100 kB, and 2048 kB are needed: raise the limit, "
            "ulimit -s 8192\n");
}

TEST_F(DeviceOption, NamesWhatThereIs) {
  const ChildResult index = draw({"--device", "31"});
  EXPECT_EQ(index.status, 2);
  EXPECT_THAT(index.error, AllOf(StartsWith("rotatebook: can't draw: there is no EGL device 31\n"),
                                 HasSubstr("\n  EGL device 0")));
  const ChildResult cuda = draw({"--device", "cuda:31"});
  EXPECT_EQ(cuda.status, 2);
  EXPECT_THAT(cuda.error, HasSubstr("there is no EGL device with the CUDA id 31\n"));
  const ChildResult words = draw({"--device", "fast"});
  EXPECT_EQ(words.status, 2);
  EXPECT_THAT(words.error, StartsWith("rotatebook: --device fast: not a device; write a number "));
  EXPECT_FALSE(has("x.png"));
}

TEST_F(DeviceOption, RefusesSoftwareWhereHardwareIsRequired) {
  const ChildResult result = draw({"--require-hardware"});
  EXPECT_EQ(result.status, 3);
  EXPECT_THAT(result.error,
              AllOf(StartsWith("rotatebook: can't draw: no EGL display draws in hardware"),
                    HasSubstr("Run 'rotatebook doctor'")));
  EXPECT_EQ(draw({"--require-hardware", "--device", "software"}).status, 2);
  EXPECT_FALSE(has("x.png"));
}

TEST_F(DeviceOption, IsTheMachinesFailureWithoutGraphics) {
  for (const char* device : {"0", "cuda:0", "software"}) {
    const ChildResult result = runWithoutGraphics(
        {"still", "tiny.toml", "--time", "0", "-o", "x.png", "--device", device});
    EXPECT_EQ(result.status, 3) << device;
    EXPECT_THAT(result.error, HasSubstr("rotatebook doctor")) << device;
  }
}

TEST_F(DeviceOption, IsTakenByEveryCommandThatDraws) {
  for (const auto& words :
       std::vector<std::vector<std::string>>{{"render", "tiny.toml"},
                                             {"still", "tiny.toml", "-o", "x.png", "--count", "2"},
                                             {"bench", "tiny.toml"}}) {
    std::vector<std::string> all = words;
    all.insert(all.end(), {"--device", "31"});
    const ChildResult result = run(all);
    EXPECT_EQ(result.status, 2) << words[0];
    EXPECT_THAT(result.error, HasSubstr("there is no EGL device 31")) << words[0];
    EXPECT_THAT(files(), IsEmpty()) << words[0];
  }
}

}  // namespace
}  // namespace rotatebook::cli::testing
