// Failures of the machine: no place to write, no graphics. Exit status 3, and nothing half-written.
#include <string>
#include <vector>

#include "cli/program_test.h"
#include "image/png_file.h"
#include "system/atomic_file.h"

namespace rotatebook::cli::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::ContainsRegex;
using ::testing::ElementsAre;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::StartsWith;

/// Its book has the built-in pictures, so that frames are larger than texts.
class OutputFailure : public ProgramTest {
 protected:
  OutputFailure() {
    std::string scene = kTiny;
    write("tiny.toml", scene.replace(scene.find("book.color"), 0, "# "));
  }

  ChildResult runOnFullDisk(const std::vector<std::string>& arguments, long largestFile) const {
    ChildSettings settings;
    settings.largestFile = largestFile;
    return run(arguments, settings);
  }

  ChildResult runOnFullOutput(const std::vector<std::string>& arguments) const {
    ChildSettings settings;
    settings.outputFile = "/dev/full";
    return run(arguments, settings);
  }
};

constexpr const char* kLostOutput = "rotatebook: can't write to the standard output\n";
constexpr long kLessThanAFrame = 6000;  // [bytes]; of 192x108 they have 11700, scene.toml 2550
constexpr long kLessThanATable = 6000;  // [bytes]; the table has 6519, the clip 4500
constexpr long kLessThanAPlot = 9000;   // [bytes]; the plot has 19000, its table 270
constexpr long kLessThanAClip = 4000;   // [bytes]; frames have 2800 at most

TEST_F(OutputFailure, FileInTheWayOfTheFolder) {
  write("file", "");
  const ChildResult result = run({"render", "tiny.toml", "-o", "file"});
  EXPECT_EQ(result.status, 3);
  const std::string remedy = "; move it out of the way, or choose another path\n";
  EXPECT_EQ(result.error, "rotatebook: can't make the folder file: file is not a folder" + remedy);
  EXPECT_EQ(run({"render", "tiny.toml", "-o", "file/below"}).error,
            "rotatebook: can't make the folder file/below: file is not a folder" + remedy);
  fs::create_symlink("nowhere", folder() / "link");
  EXPECT_EQ(
      run({"render", "tiny.toml", "-o", "link"}).error,
      "rotatebook: can't make the folder link: link is a link whose target doesn't exist" + remedy);
  EXPECT_THAT(files(), ElementsAre("file", "link"));
}

TEST_F(OutputFailure, HasTheStatusOfARetryWhereThatMayHelp) {
  {
    fs::create_directory(folder() / "out");
    const system::AdvisoryLock other(folder() / "out/tiny", system::Lock::Exclusive);
    EXPECT_EQ(run({"render", "tiny.toml", "--retry-status"}).status, 75);
    EXPECT_EQ(run({"render", "tiny.toml"}).status, 3);
    fs::create_directory(folder() / "out/tiny");
    EXPECT_EQ(run({"assemble", "out/tiny", "-o", "a.mp4", "--retry-status"}).status, 75);
  }
  EXPECT_EQ(runWithoutGraphics({"render", "tiny.toml", "--retry-status"}).status, 75);
  write("b.toml", kTiny);
  EXPECT_EQ(runWithoutGraphics({"render", "tiny.toml", "b.toml", "-j2", "--retry-status"}).status,
            75);
  EXPECT_EQ(runWithoutGraphics({"render", "tiny.toml", "--retry-status", "--json"}).status, 75);
  // Another try would end likewise
  write("file", "");
  EXPECT_EQ(run({"render", "tiny.toml", "-o", "file", "--retry-status"}).status, 3);
  EXPECT_EQ(run({"render", "no.toml", "--retry-status"}).status, 2);
  EXPECT_EQ(
      run({"render", "tiny.toml", "--retry-status", "--set", "expect.half_turns={min = 3}"}).status,
      1);
}

TEST_F(OutputFailure, FolderInTheWayOfTheClip) {
  fs::create_directories(folder() / "out/tiny.mp4");
  const ChildResult result = run({"render", "tiny.toml", "--no-png"});
  EXPECT_EQ(result.status, 3);
  EXPECT_EQ(result.error, "rotatebook: can't write out/tiny.mp4: it is a folder\n");
  EXPECT_THAT(files(), ElementsAre("out/", "out/tiny.mp4/"));
}

TEST_F(OutputFailure, FolderInTheWayOfAStudy) {
  fs::create_directories(folder() / "out/tiny-study.png");
  write("out/tiny-study.csv", "order,status\n");
  const ChildResult result = run({"study", "tiny.toml"});
  EXPECT_EQ(result.status, 3);
  EXPECT_EQ(result.error, "rotatebook: can't write out/tiny-study.png: it is a folder\n");
  EXPECT_THAT(result.output, IsEmpty());
  EXPECT_THAT(files(), ElementsAre("out/", "out/tiny-study.csv", "out/tiny-study.png/"));
}

TEST_F(OutputFailure, FolderThatIsReadOnly) {
  fs::create_directories(folder() / "out");
  fs::permissions(folder() / "out", fs::perms::owner_read | fs::perms::owner_exec);
  ChildSettings settings;
  settings.obeysPermissions = true;
  const ChildResult result = run({"render", "tiny.toml"}, settings);
  fs::permissions(folder() / "out", fs::perms::owner_all);
  EXPECT_EQ(result.status, 3);
  EXPECT_EQ(result.error, "rotatebook: can't write out/tiny: Permission denied\n");
  EXPECT_THAT(files(), ElementsAre("out/"));
}

// Found before the first frame, as nothing could be put in its place.
TEST_F(OutputFailure, ClipThatMayNotBeRemoved) {
  ASSERT_EQ(run({"render", "tiny.toml"}).status, 0);
  const std::vector<std::string> before = files();
  const std::string video = read("out/tiny.mp4");
  fs::permissions(folder() / "out/tiny", fs::perms::owner_read | fs::perms::owner_exec);
  ChildSettings settings;
  settings.obeysPermissions = true;
  for (const char* flag : {"--overwrite", "--no-png"}) {
    const ChildResult result = run({"render", "tiny.toml", "--set", "body.mass=2", flag}, settings);
    EXPECT_EQ(result.status, 3);
    EXPECT_THAT(
        result.error,
        HasSubstr("can't replace the clip in out/tiny/: Permission denied; out/tiny belongs "
                  "to "));
    EXPECT_THAT(result.error, HasSubstr("have its owner remove it, or render into another folder"));
    EXPECT_THAT(result.output, IsEmpty());
  }
  fs::permissions(folder() / "out/tiny", fs::perms::owner_all);
  EXPECT_EQ(files(), before);
  EXPECT_TRUE(read("out/tiny.mp4") == video);
}

TEST_F(OutputFailure, KeepsAFileThatMayNotBeReadButToOverwrite) {
  ASSERT_EQ(run({"render", "tiny.toml"}).status, 0);
  ChildSettings settings;
  settings.obeysPermissions = true;
  fs::permissions(folder() / "out/tiny.csv", fs::perms::owner_write);
  const ChildResult kept = run({"render", "tiny.toml", "--resume"}, settings);
  EXPECT_EQ(kept.status, 3);
  EXPECT_EQ(kept.error, "rotatebook: can't read out/tiny.csv: Permission denied\n");
  const ChildResult replaced = run({"render", "tiny.toml", "--overwrite"}, settings);
  EXPECT_EQ(replaced.status, 0) << replaced.error;
  EXPECT_THAT(replaced.error, HasSubstr("replaced out/tiny.csv (with unknown settings)\n"));
  EXPECT_THAT(read("out/tiny.csv"), StartsWith("frame,"));
}

TEST_F(OutputFailure, ReplacedClipThatMayNotBeRemovedStopsNoOtherRender) {
  ASSERT_EQ(run({"render", "tiny.toml"}).status, 0);
  fs::copy(folder() / "out/tiny", folder() / "out/tiny.replaced");
  fs::permissions(folder() / "out/tiny.replaced", fs::perms::owner_read | fs::perms::owner_exec);
  ChildSettings settings;
  settings.obeysPermissions = true;
  const std::string remainder =
      "the earlier clip in out/tiny.replaced/ can't be removed: Permission denied; "
      "out/tiny.replaced belongs to ";
  for (const char* flag : {"--resume", "--no-png"}) {
    const ChildResult result = run({"render", "tiny.toml", flag}, settings);
    EXPECT_EQ(result.status, 0) << result.error;
    EXPECT_THAT(result.error, HasSubstr("note: tiny: " + remainder));
  }
  const ChildResult result = run({"render", "tiny.toml"}, settings);
  fs::permissions(folder() / "out/tiny.replaced", fs::perms::owner_all);
  EXPECT_EQ(result.status, 3);
  EXPECT_THAT(result.error, HasSubstr(remainder));
  EXPECT_EQ(run({"render", "tiny.toml"}).status, 0);
  EXPECT_FALSE(has("out/tiny.replaced"));
}

TEST_F(OutputFailure, PlaceWhereNobodyMayWrite) {
  const ChildResult result = run({"render", "tiny.toml", "-o", "/proc/clips"});
  EXPECT_EQ(result.status, 3);
  EXPECT_EQ(result.error,
            "rotatebook: can't make the folder /proc/clips: No such file or directory\n");
}

TEST_F(OutputFailure, FolderThatIsMissing) {
  const std::string end = ": No such file or directory\n";
  const ChildResult table = run({"simulate", "tiny.toml", "--csv", "no/x.csv"});
  EXPECT_EQ(table.status, 3);
  EXPECT_EQ(table.error, "rotatebook: can't write no/x.csv" + end);
  const ChildResult still = run({"still", "tiny.toml", "--time", "0", "-o", "no/x.png"});
  EXPECT_EQ(still.status, 3);
  EXPECT_EQ(still.error, "rotatebook: can't write no/x.png" + end);
  EXPECT_THAT(files(), IsEmpty());
}

TEST_F(OutputFailure, FullDiskForFrames) {
  const ChildResult result =
      runOnFullDisk({"render", "tiny.toml", "--no-mp4", "--size", "192x108"}, kLessThanAFrame);
  EXPECT_EQ(result.status, 3);
  EXPECT_THAT(result.error, AllOf(StartsWith("rotatebook: can't write out/tiny.partial/frame_000"),
                                  EndsWith(".png: File too large\n")));
  EXPECT_THAT(files(), ElementsAre("out/"));
}

// No file of the render's may become a standard stream, into which words would be printed.
TEST_F(OutputFailure, ClosedStandardStreams) {
  run({"render", "tiny.toml", "-o", "whole"});
  for (const std::vector<int>& closed :
       {std::vector{0}, std::vector{1}, std::vector{2}, std::vector{0, 1}, std::vector{0, 1, 2}}) {
    ChildSettings settings;
    settings.closed = closed;
    const bool silent = closed.size() > 1 || closed.front() == 1;
    EXPECT_EQ(run({"render", "tiny.toml"}, settings).status, silent ? 3 : 0);
    expectSameFiles("whole", "out");
    fs::remove_all(folder() / "out");
  }
}

TEST_F(OutputFailure, FolderInTheWayIsReportedBeforeAnythingIsDrawn) {
  fs::create_directories(folder() / "out/tiny.poster.png");
  const ChildResult result = run({"render", "tiny.toml"});
  EXPECT_EQ(result.status, 3);
  EXPECT_EQ(result.error, "rotatebook: can't write out/tiny.poster.png: it is a folder\n");
}

TEST_F(OutputFailure, FullDiskForTheClip) {
  const ChildResult result = runOnFullDisk({"render", "tiny.toml"}, kLessThanAClip);
  EXPECT_EQ(result.status, 3);
  EXPECT_THAT(result.error,
              AllOf(ContainsRegex("(^|\n)rotatebook: can't write out/"),
                    HasSubstr(": File too large\n  12 finished frames are kept in "
                              "out/tiny.partial/; go on with the same command and --resume\n")));
  for (const std::string& name : files()) {
    EXPECT_THAT(name, Not(HasSubstr(".rotatebook-")));
    EXPECT_THAT(name, Not(HasSubstr(".mp4")));
    if (!name.ends_with(".png")) continue;
    EXPECT_NO_THROW(image::readPng(folder() / name)) << name;
  }
}

TEST_F(OutputFailure, FullDiskForTheTable) {
  const ChildResult render =
      runOnFullDisk({"render", "tiny.toml", "--no-png", "--no-mp4"}, kLessThanATable);
  EXPECT_EQ(render.status, 3);
  EXPECT_EQ(render.error, "rotatebook: can't write out/tiny.csv: File too large\n");
  const ChildResult simulate =
      runOnFullDisk({"simulate", "tiny.toml", "--csv", "x.csv"}, kLessThanATable);
  EXPECT_EQ(simulate.status, 3);
  EXPECT_EQ(simulate.error, "rotatebook: can't write x.csv: File too large\n");
  EXPECT_THAT(files(), ElementsAre("out/"));
}

TEST_F(OutputFailure, FullDiskKeepsTheOlderFile) {
  write("x.csv", "frame,time_s,qw,qx,qy,qz,wx,wy,wz,\n");
  EXPECT_EQ(runOnFullDisk({"simulate", "tiny.toml", "--csv", "x.csv"}, kLessThanATable).status, 3);
  EXPECT_EQ(read("x.csv"), "frame,time_s,qw,qx,qy,qz,wx,wy,wz,\n");
}

TEST_F(OutputFailure, FullDiskForAssembleAndStill) {
  run({"render", "tiny.toml", "--no-mp4", "--size", "192x108"});
  const auto before = files();
  const ChildResult assemble =
      runOnFullDisk({"assemble", "out/tiny", "-o", "x.mp4"}, kLessThanAFrame);
  EXPECT_EQ(assemble.status, 3);
  EXPECT_THAT(assemble.error, EndsWith(": File too large\n"));
  const ChildResult still =
      runOnFullDisk({"still", "tiny.toml", "--size", "192x108", "-o", "x.png"}, kLessThanAFrame);
  EXPECT_EQ(still.status, 3);
  EXPECT_EQ(still.error, "rotatebook: can't write x.png: File too large\n");
  EXPECT_EQ(files(), before);
}

TEST_F(OutputFailure, FilesInMemoryThatMayNotBeLargeEnough) {
  const ChildResult still = runOnFullDisk(
      {"still", "tiny.toml", "--time", "0", "-o", "x.png", "--set", "overlay.show=[\"caption\"]"},
      kLessThanAPlot);
  EXPECT_EQ(still.status, 3);
  EXPECT_EQ(still.error, "rotatebook: can't write the font in memory: File too large\n");
  const ChildResult study = runOnFullDisk(
      {"study", "tiny.toml", "--steps", "1,2", "--integrators", "rk4"}, kLessThanAPlot);
  EXPECT_EQ(study.status, 3);
  EXPECT_EQ(study.error, "rotatebook: can't write the font in memory: File too large\n");
}

TEST_F(OutputFailure, StandardOutputThatIsFull) {
  for (const std::vector<std::string>& arguments :
       {std::vector<std::string>{"simulate", "tiny.toml", "--csv", "-"},
        {"simulate", "tiny.toml", "--csv", "x.csv"},
        {"render", "tiny.toml", "--no-png", "--no-mp4"},
        {"check", "tiny.toml"},
        {"check", "--print", "tiny.toml"},
        {"check", "."},
        {"still", "tiny.toml", "--time", "0", "-o", "x.png"},
        {"--version"},
        {"render", "--help"}}) {
    const ChildResult result = runOnFullOutput(arguments);
    EXPECT_EQ(result.status, 3) << arguments.front();
    EXPECT_EQ(withoutDistances(result.error), kLostOutput) << arguments.front();
  }
}

TEST_F(OutputFailure, ComparisonThatIsLost) {
  run({"still", "tiny.toml", "--time", "0", "-o", "x.png"});
  const ChildResult result = runOnFullOutput({"diff", "x.png", "x.png"});
  EXPECT_EQ(result.status, 3);
  EXPECT_EQ(result.error, kLostOutput);
}

TEST_F(OutputFailure, NoGraphicsSaysWhatToInstall) {
  const std::vector<std::vector<std::string>> commands{
      {"render", "tiny.toml"}, {"still", "tiny.toml", "--time", "0", "-o", "x.png"}};
  for (const std::vector<std::string>& arguments : commands) {
    const ChildResult result = runWithoutGraphics(arguments);
    EXPECT_EQ(result.status, 3);
    EXPECT_THAT(result.error, StartsWith("rotatebook: can't draw: no EGL display gives an OpenGL "
                                         "3.3 core context:\n"));
    EXPECT_THAT(result.error,
                HasSubstr("\n  Install Mesa's software rasteriser (Debian, Ubuntu: apt-get install "
                          "libegl1 libegl-mesa0 libgl1-mesa-dri libopengl0)"));
    EXPECT_THAT(files(), IsEmpty());
  }
}

}  // namespace
}  // namespace rotatebook::cli::testing
