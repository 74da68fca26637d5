// `rotatebook verify`.
#include <filesystem>
#include <string>
#include <sys/stat.h>
#include <vector>

#include "cli/program_test.h"
#include "image/png_file.h"

namespace rotatebook::cli::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::StartsWith;

class VerifyCommand : public ProgramTest {
 protected:
  /// Renders tiny.toml, MP4 alone unless `more` says otherwise.
  void render(const std::vector<std::string>& more = {}) const {
    std::vector<std::string> words{"render", "tiny.toml", "--no-png"};
    words.insert(words.end(), more.begin(), more.end());
    const ChildResult result = run(words);
    ASSERT_EQ(result.status, 0) << result.error;
  }

  /// Puts `with` in the place of `what`, of the same length, in out/tiny.mp4.
  void change(const std::string& what, const std::string& with) const {
    std::string content = read("out/tiny.mp4");
    const std::size_t at = content.find(what);
    ASSERT_NE(at, std::string::npos) << what;
    ASSERT_EQ(what.size(), with.size());
    write("out/tiny.mp4", content.replace(at, what.size(), with));
  }

  /// Expects that `clip` is refused as a wrong input with a message in one line.
  void expectRefused(const std::string& clip, const std::string& message) const {
    const ChildResult result = run({"verify", clip});
    EXPECT_EQ(result.status, 2) << result.output;
    EXPECT_THAT(result.error, AllOf(StartsWith("rotatebook: "), HasSubstr(message)));
    EXPECT_THAT(result.output, IsEmpty());
  }
};

TEST_F(VerifyCommand, ProvesAClipLineByLine) {
  render();
  const ChildResult result = run({"verify", "out/tiny.mp4"});
  EXPECT_EQ(result.status, 0) << result.output << result.error;
  EXPECT_THAT(
      result.output,
      AllOf(
          StartsWith("out/tiny.mp4: claims to be 12 frames of the scene tiny, made by rotatebook "),
          HasSubstr("\n  ok      size         64x36 (as it must be)\n"),
          HasSubstr("\n  ok      codec        h264 High, yuv420p (as it must be)\n"),
          HasSubstr("\n  ok      frames       12 (as it must be)\n"),
          HasSubstr(
              "\n  ok      time stamps  off by up to 0 ms (frame n at n/fps within 0.001 ms)\n"),
          HasSubstr("\n  ok      container    primaries bt709, transfer bt709, matrix bt709, "
                    "range tv (as it must be)\n"),
          HasSubstr("\n  ok      display      as stored (as it must be)\n"),
          HasSubstr("\n  ok      layout       as rotatebook writes it (as it must be)\n"),
          HasSubstr("\n  ok      coding       as rotatebook writes it (as it must be)\n"),
          Not(HasSubstr("FAILED")), Not(HasSubstr("note"))));
  EXPECT_EQ(countOf("\n  ok      frame ", result.output), 6);
  EXPECT_THAT(result.output, ::testing::ContainsRegex(
                                 "\nProved for 6 of 12 pictures \\([01], [23], [45], [67], [89], "
                                 "1[01]\\): they and the motion are those of the scene; --all "
                                 "compares every picture.\nWorth: coded at a mean quantiser of "
                                 "[0-9.]+ of 51; changes of up to [^\n]* may pass unnoticed.\n$"));
}

// The processor may have other functions of the C library than the one that rendered.
TEST_F(VerifyCommand, ProvesAClipOfAnotherProcessor) {
  write("exact.toml",
        "book.color = \"#2b5d8a\"\n[simulation]\nmodel = \"exact\"\n[initial]\nangular_velocity = "
        "[5.0, 0.01, 0.0]\n"
        "[clip]\nsize = [160, 90]\nduration = 4.0\n");
  ASSERT_EQ(run({"render", "exact.toml", "--no-png"}).status, 0);
  ChildSettings withoutFma;
  withoutFma.environment = {
      {"GLIBC_TUNABLES", "glibc.cpu.hwcaps=-AVX2,-AVX2_Usable,-FMA,-FMA_Usable,-FMA4,-AVX512F"}};
  const ChildResult result = run({"verify", "out/exact.mp4"}, withoutFma);
  EXPECT_EQ(result.status, 0) << result.output << result.error;
  EXPECT_THAT(result.output,
              AllOf(HasSubstr("\n  ok      motion       "), HasSubstr("\nProved for 6 of ")));
}

TEST_F(VerifyCommand, ComparesTheFramesThatAreNamed) {
  render();
  const ChildResult result = run({"verify", "out/tiny.mp4", "--frames", "3,7"});
  EXPECT_EQ(result.status, 0);
  EXPECT_THAT(result.output, HasSubstr("\nProved for 2 of 12 pictures (3, 7): "));
  EXPECT_EQ(countOf("\n  ok      frame ", result.output), 2);
  EXPECT_THAT(run({"verify", "out/tiny.mp4", "--all"}).output,
              HasSubstr("\nProved: the motion and all 12 pictures are those of the scene.\n"));
  const ChildResult outside = run({"verify", "out/tiny.mp4", "--frames", "3,12"});
  EXPECT_EQ(outside.status, 2);
  EXPECT_EQ(outside.error, "rotatebook: frame 12 isn't in the clip, which has 0 to 11\n");
  EXPECT_EQ(run({"verify", "out/tiny.mp4", "--frames", "3", "--all"}).status, 2);
  EXPECT_EQ(run({"verify", "out/tiny.mp4", "--frames", "x"}).status, 2);
  EXPECT_THAT(
      run({"verify", "out/tiny.mp4", "--frames", "99999999999999999999"}).error,
      HasSubstr("--frames must be a whole number from 0 to 1000000, not 99999999999999999999"));
}

TEST_F(VerifyCommand, WaitsForNoPipe) {
  ASSERT_EQ(mkfifo((folder() / "clip.mp4").c_str(), 0600), 0);
  for (const std::vector<std::string>& command :
       {std::vector<std::string>{"verify"}, {"verify", "--again", "again"}}) {
    std::vector<std::string> arguments = command;
    arguments.emplace_back("clip.mp4");
    const ChildResult result = run(arguments);
    EXPECT_EQ(result.status, 2);
    EXPECT_EQ(result.error, "rotatebook: can't read clip.mp4: it is a pipe, not a file\n");
  }
}

TEST_F(VerifyCommand, ProvesWebMAndParts) {
  render({"--format", "webm", "--frames", "2:9"});
  const ChildResult result = run({"verify", "out/tiny_00002-00009.webm"});
  EXPECT_EQ(result.status, 0) << result.output << result.error;
  EXPECT_THAT(result.output, AllOf(HasSubstr(": claims to be frames 2:9 of 12 of the scene tiny"),
                                   HasSubstr("\n  ok      frame 8      off by ")));
}

TEST_F(VerifyCommand, IsJsonToo) {
  render();
  const ChildResult result = run({"verify", "out/tiny.mp4", "--json", "--frames", "0,11"});
  EXPECT_EQ(result.status, 0);
  EXPECT_EQ(countOf("\n", result.output), 1);
  EXPECT_THAT(result.output,
              AllOf(StartsWith("{\"clip\":\"out/tiny.mp4\",\"proved\":true,"
                               "\"verdict\":\"proved\",\"quantiser\":"),
                    HasSubstr("\"frames\":[0,12],\"whole_frames\":12,"),
                    HasSubstr("{\"check\":\"size\",\"passed\":true,\"measured\":\"64x36\","),
                    HasSubstr("{\"frame\":11,\"passed\":true,\"quantiser\":"),
                    HasSubstr(",\"measured\":{\"rms\":"), HasSubstr(",\"brightness\":"),
                    EndsWith("\"closer_to\":null}]}\n")));
}

TEST_F(VerifyCommand, FailsForAnotherScene) {
  render();
  change("angular_velocity = [5.0, ", "angular_velocity = [6.0, ");
  const ChildResult result = run({"verify", "out/tiny.mp4", "--all"});
  EXPECT_EQ(result.status, 1);
  EXPECT_THAT(result.output,
              AllOf(HasSubstr("\n  FAILED  motion       "), HasSubstr("\n  FAILED  frame 11     "),
                    HasSubstr("\nNOT PROVED: ")));
  EXPECT_THAT(run({"verify", "out/tiny.mp4", "--json"}).output, HasSubstr("\"proved\":false"));
}

TEST_F(VerifyCommand, ProvesNoCoarseClip) {
  render({"--set", "video.crf=45"});
  const ChildResult result = run({"verify", "out/tiny.mp4"});
  EXPECT_EQ(result.status, 4) << result.output << result.error;
  EXPECT_THAT(result.output, AllOf(HasSubstr("\nConsistent, coarsely: "),
                                   HasSubstr(", above 32; changes of up to "),
                                   Not(HasSubstr("FAILED")), Not(HasSubstr("Proved"))));
  EXPECT_THAT(run({"verify", "out/tiny.mp4", "--json"}).output,
              HasSubstr("\"proved\":false,\"verdict\":\"consistent, coarsely\","));
}

TEST_F(VerifyCommand, ProvesTheMotionAloneOfABrowsersClip) {
  render();
  const std::string made = read("out/tiny.mp4");
  const std::size_t begin = made.find("# Renderer: ") + 12, end = made.find('\n', begin);
  ASSERT_GT(end - begin, 11);
  std::string renderer = "a browser, ";
  renderer.resize(end - begin, 'x');
  change(made.substr(begin, end - begin), renderer);
  const ChildResult result = run({"verify", "out/tiny.mp4"});
  EXPECT_EQ(result.status, 4) << result.output << result.error;
  EXPECT_THAT(result.output,
              AllOf(HasSubstr("\nMotion proved: it is that of the scene, bit for bit. The "
                              "pictures are a browser's own, which can't be compared."),
                    Not(HasSubstr("FAILED")), Not(HasSubstr("note"))));
  EXPECT_THAT(run({"verify", "out/tiny.mp4", "--json"}).output,
              HasSubstr("\"proved\":false,\"verdict\":\"motion proved\","));
}

TEST_F(VerifyCommand, NotesOtherToolsWithoutFailing) {
  render();
  change("# Renderer: llvmpipe", "# Renderer: llvmPIPE");
  const ChildResult result = run({"verify", "out/tiny.mp4"});
  EXPECT_EQ(result.status, 0) << result.output;
  EXPECT_THAT(result.output, HasSubstr("\n  note    the renderer was llvmPIPE"));
}

TEST_F(VerifyCommand, RequiresNoWordsOfARecordOfAnotherVersion) {
  render();
  change("# Renderer: ", "# Sendererx ");
  EXPECT_THAT(run({"verify", "out/tiny.mp4"}).output, HasSubstr("\n  FAILED  record  "));
  change("rotatebook 0.", "rotatebook 9.");
  const ChildResult result = run({"verify", "out/tiny.mp4"});
  EXPECT_EQ(result.status, 0) << result.output;
  EXPECT_THAT(result.output, HasSubstr("\n  note    the renderer was not recorded, here it is "));
}

TEST_F(VerifyCommand, RefusesWhatIsNoClip) {
  render({"--format", "gif,apng"});
  expectRefused("out/tiny.gif", "out/tiny.gif is in the format gif, which holds no record");
  expectRefused("out/tiny.apng", "out/tiny.apng is in the format apng, which holds no record");
  expectRefused("tiny.toml", "tiny.toml isn't an MP4 or WebM\n");
  expectRefused("out/tiny.poster.png", "out/tiny.poster.png isn't an MP4 or WebM\n");
  expectRefused("no.mp4", "can't read no.mp4: No such file or directory");
  expectRefused("out", "can't read out: Is a directory");
}

TEST_F(VerifyCommand, RefusesDamagedRecords) {
  render();
  const std::string whole = read("out/tiny.mp4");
  change("# Made by rotatebook", "# Made by somebodyel");
  expectRefused("out/tiny.mp4", "out/tiny.mp4 isn't a clip of rotatebook: its metadata holds no");
  write("out/tiny.mp4", whole);
  change("the scene tiny", "the scene ../x");
  expectRefused("out/tiny.mp4", "is damaged: its scene's name ");
  write("out/tiny.mp4", whole);
  change("\nangular_velocity", "\nangular_velocitx");
  expectRefused("out/tiny.mp4", "the record in out/tiny.mp4 is damaged: out/tiny.mp4:");
}

TEST_F(VerifyCommand, RefusesTruncatedFiles) {
  render({"--format", "mp4,webm"});
  for (const std::string format : {"mp4", "webm"}) {
    const std::string whole = read("out/tiny." + format);
    for (std::size_t size = whole.size() / 9; size < whole.size(); size += whole.size() / 9) {
      write("out/cut." + format, whole.substr(0, size));
      expectRefused("out/cut." + format, "out/cut." + format + " ends early, or is damaged: ");
    }
  }
}

TEST_F(VerifyCommand, FindsTexturesFromTheSceneFolder) {
  image::Image cover(8, 12, image::PixelFormat::Rgb8);
  fs::create_directories(folder() / "scenes");
  writePng(folder() / "scenes/cover.png", cover.view());
  write("scenes/covered.toml", "book.front = \"cover.png\"\n" + std::string(kTiny));
  ASSERT_EQ(run({"render", "scenes/covered.toml", "--no-png"}).status, 0);
  const ChildResult near = run({"verify", "out/covered.mp4"});
  EXPECT_EQ(near.status, 0) << near.output << near.error;
  fs::create_directories(folder() / "more/deeper");
  fs::rename(folder() / "scenes", folder() / "more/deeper/scenes");
  fs::create_directories(folder() / "scenes");
  writePng(folder() / "scenes/cover.png", image::Image(4, 4, image::PixelFormat::Rgb8).view());
  const ChildResult missing = run({"verify", "out/covered.mp4"});
  EXPECT_EQ(missing.status, 2);
  EXPECT_THAT(missing.error, AllOf(HasSubstr("can't read out/cover.png: No such file or directory"),
                                   HasSubstr("; name its scene's folder with --scene-folder DIR")));
  const ChildResult found =
      run({"verify", "out/covered.mp4", "--scene-folder", "more/deeper/scenes"});
  EXPECT_EQ(found.status, 0) << found.output << found.error;
}

TEST_F(VerifyCommand, TakesTexturesFromOutsideOnlyIfAllowed) {
  const image::Image cover(8, 12, image::PixelFormat::Rgb8);
  fs::create_directories(folder() / "scenes");
  writePng(folder() / "cover.png", cover.view());
  fs::copy_file(folder() / "tiny.toml", folder() / "scenes/tiny.toml");
  const ChildResult rendered = run({"render", "scenes/tiny.toml", "--no-png", "--set",
                                    "book.front=../cover.png", "--allow-outside"});
  ASSERT_EQ(rendered.status, 0) << rendered.error;
  const ChildResult refused = run({"verify", "out/tiny.mp4", "--scene-folder", "scenes"});
  EXPECT_EQ(refused.status, 2);
  EXPECT_THAT(refused.error, EndsWith(": it leads outside the scene's folder, which "
                                      "--allow-outside allows\n"));
  const ChildResult allowed =
      run({"verify", "out/tiny.mp4", "--scene-folder", "scenes", "--allow-outside"});
  EXPECT_EQ(allowed.status, 0) << allowed.output << allowed.error;
}

// Pictures of the recorded size might take gigabytes: nothing is drawn.
TEST_F(VerifyCommand, DrawsNothingForAnotherSize) {
  render();
  change("size = [64, 36]", "size = [96, 36]");
  const ChildResult result = runWithoutGraphics({"verify", "out/tiny.mp4"});
  EXPECT_EQ(result.status, 1) << result.error;
  EXPECT_THAT(result.output, HasSubstr("\n  FAILED  size         64x36 (96x36)\n"));
}

TEST_F(VerifyCommand, NeedsGraphics) {
  render();
  EXPECT_EQ(runWithoutGraphics({"verify", "out/tiny.mp4"}).status, 3);
}

}  // namespace
}  // namespace rotatebook::cli::testing
