// `rotatebook page --pack`: what it replaces, and what is left of one that was stopped.
#include <csignal>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cli/program_test.h"
#include "image/png_file.h"

namespace rotatebook::cli::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::Not;

class PackCommand : public ProgramTest {
 protected:
  PackCommand() {
    write("s.toml", kTiny);
    run({"render", "s.toml", "--no-png", "--format", "mp4,webm"});
  }

  ChildResult pack(const std::string& target, ChildSettings settings = {}) const {
    return run({"page", "s.toml", "--no-thumbnails", "--pack", target}, std::move(settings));
  }

  void expectPacked(const std::string& target) const {
    const ChildResult result = pack(target);
    EXPECT_EQ(result.status, 0) << result.error;
    EXPECT_THAT(result.output, HasSubstr("wrote " + target + ", "));
  }

  /// Expects that nothing is packed, and that all files stay as they are.
  void expectRefused(const std::string& target, const std::string& message) const {
    const fs::path copy = folder().string() + ".before";
    fs::remove_all(copy);
    fs::copy(folder(), copy, fs::copy_options::recursive | fs::copy_options::copy_symlinks);
    const ChildResult result = pack(target);
    EXPECT_EQ(result.status, 2) << result.output;
    EXPECT_THAT(result.error, HasSubstr(message));
    EXPECT_EQ(
        std::system(("diff -r --no-dereference '" + copy.string() + "' '" + folder().string() + "'")
                        .c_str()),
        0);
    fs::remove_all(copy);
  }
};

TEST_F(PackCommand, ReplacesItsOwnPackAndKeepsOtherFiles) {
  for (const char* target : {"site", "site.zip"}) {
    expectPacked(target);
    expectPacked(target);
  }
  const std::string archive = read("site.zip");
  EXPECT_FALSE(has("site.rotatebook-pack"));
  write("site/CNAME", "book.example");
  expectPacked("site");
  EXPECT_EQ(read("site/CNAME"), "book.example");
  expectPacked("site.zip");
  EXPECT_TRUE(read("site.zip") == archive) << "the same bytes again";
}

// Though their rate factor is none that a record has.
TEST_F(PackCommand, MakesClipsThatAreProved) {
  const ChildResult packed =
      run({"page", "s.toml", "--no-thumbnails", "--pack", "site", "--pack-crf", "18"});
  EXPECT_EQ(packed.status, 0) << packed.error;
  const ChildResult result = run({"verify", "site/s.mp4"});
  EXPECT_EQ(result.status, 0) << result.output << result.error;
}

TEST_F(PackCommand, ReplacesNoOtherFolderOfResults) {
  fs::copy(folder() / "out", folder() / "best", fs::copy_options::recursive);
  ASSERT_EQ(run({"page", "s.toml", "--no-thumbnails", "-o", "best"}).status, 0);
  expectRefused("best", "best isn't empty, and no page that --pack made is in it");
  expectRefused("out", "is the folder with the results");
  expectPacked("site");
  ASSERT_EQ(run({"render", "s.toml", "--no-png", "-o", "site"}).status, 0);
  expectRefused("site", "site/s.mp4 isn't as --pack left it, and would be replaced");
}

TEST_F(PackCommand, ReplacesNoOtherArchive) {
  for (const std::string& content :
       {std::string("PK\5\6") + std::string(18, '\0'), std::string("a thesis"), std::string()}) {
    write("thesis.zip", content);
    expectRefused("thesis.zip", "thesis.zip isn't an archive as --pack made it");
  }
  fs::remove(folder() / "thesis.zip");
  expectPacked("site.zip");
  fs::create_symlink("site.zip", folder() / "thesis.zip");
  expectRefused("thesis.zip", "thesis.zip isn't an archive as --pack made it");
  std::string changed = read("site.zip");
  changed.replace(changed.find("<!doctype html>"), 15, "<!DOCTYPE html>");
  write("site.zip", changed);
  expectRefused("site.zip", "site.zip isn't an archive as --pack made it");
}

TEST_F(PackCommand, RemovesAndPublishesNothingOfOthers) {
  write("x.rotatebook-pack/index.html", "<meta name=\"generator\" content=\"rotatebook 1\">");
  write("x.rotatebook-pack/mine.txt", "mine");
  write("x.rotatebook-pack/sub/mine.txt", "mine");
  expectRefused("x.zip", "as x.zip is put together in that one");
  fs::remove_all(folder() / "x.rotatebook-pack");

  // Beside an interrupted pack
  expectPacked("x");
  fs::rename(folder() / "x", folder() / "x.rotatebook-pack");
  write("x.rotatebook-pack/mine.txt", "mine");
  expectPacked("x.zip");
  EXPECT_EQ(read("x.rotatebook-pack/mine.txt"), "mine");
  EXPECT_FALSE(has("x.rotatebook-pack/index.html"));
  EXPECT_THAT(read("x.zip"), Not(HasSubstr("mine.txt")));
}

TEST_F(PackCommand, WritesThroughNoLink) {
  write("precious.webm", "precious");
  for (const char* name : {"site/s.mp4", "site/rotatebook.pack", "site/index.html"}) {
    fs::remove_all(folder() / "site");
    expectPacked("site");
    fs::remove(folder() / name);
    fs::create_symlink("../precious.webm", folder() / name);
    expectRefused("site", "site");
  }
  fs::remove_all(folder() / "site");
  write("lk/index.html", read("out/index.html"));
  fs::create_symlink("../precious.webm", folder() / "lk/s.webm");
  expectRefused("lk", "lk isn't empty");
}

TEST_F(PackCommand, ReplacesNoTextureOfItsScenes) {
  image::writePng(folder() / "cover.png", image::Image(8, 12, image::PixelFormat::Rgb8).view());
  expectPacked("cv");
  fs::remove(folder() / "cv/s.poster.webp");
  fs::create_hard_link(folder() / "cover.png", folder() / "cv/s.poster.webp");
  write("s.toml", "book.front = \"cv/s.poster.webp\"\n" + std::string(kTiny));
  ASSERT_EQ(run({"render", "s.toml", "--no-png", "--format", "mp4,webm"}).status, 0);
  expectRefused("cv", "cv/s.poster.webp is a texture of the scene s and would be replaced");
}

// A moving picture is larger than the page, and copied as it is.
TEST_F(PackCommand, LeavesNoPartOfAFileOnAFullDisk) {
  ASSERT_EQ(
      run({"render", "s.toml", "-o", "big", "--no-png", "--format", "apng", "--size", "480x270"})
          .status,
      0);
  const auto packBig = [&](const std::string& target, std::optional<long> largest = {}) {
    ChildSettings settings;
    settings.largestFile = largest;
    return run(
        {"page", "s.toml", "-o", "big", "--no-thumbnails", "--size", "480x270", "--pack", target},
        settings);
  };
  ASSERT_EQ(packBig("whole").status, 0);
  ASSERT_EQ(packBig("whole.zip").status, 0);
  const auto clip = static_cast<long>(fs::file_size(folder() / "big/s.apng"));
  ASSERT_GT(clip, static_cast<long>(fs::file_size(folder() / "whole/index.html")) + 8192);

  EXPECT_EQ(packBig("site", clip - 4096).status, 3);
  EXPECT_FALSE(has("site/s.apng"));
  for (const long largest : {clip - 4096, clip + 4096}) {
    EXPECT_EQ(packBig("site.zip", largest).status, 3);
    EXPECT_FALSE(has("site.zip"));
  }

  // The same commands go on
  EXPECT_EQ(packBig("site").status, 0);
  expectSameFiles("site", "whole");
  EXPECT_EQ(packBig("site.zip").status, 0);
  EXPECT_TRUE(read("site.zip") == read("whole.zip"));
}

TEST_F(PackCommand, GoesOnAfterBeingKilled) {
  expectPacked("whole");
  expectPacked("whole.zip");
  for (const char* target : {"site", "site.zip"}) {
    const std::string folderName = std::string(target) == "site" ? "site" : "site.rotatebook-pack";
    for (const char* until : {"/", "/rotatebook.pack", "/s.poster.webp", "/s.mp4"}) {
      ChildSettings killed;
      killed.signal = SIGKILL;
      killed.signalWhen = [&] { return has(folderName + until); };
      pack(target, killed);
      fs::remove(folder() / folderName / "index.html");
    }
    expectPacked(target);
  }
  expectSameFiles("site", "whole");
  EXPECT_TRUE(read("site.zip") == read("whole.zip"));
  EXPECT_FALSE(has("site.rotatebook-pack"));
}

TEST_F(PackCommand, KeepsClipsThatAnInterruptedOneHasMade) {
  expectPacked("site");
  fs::remove(folder() / "site/index.html");
  const ChildResult again = pack("site");
  EXPECT_EQ(again.status, 0) << again.error;
  EXPECT_THAT(again.error, Not(HasSubstr("packing s.mp4")));
  const ChildResult finer =
      run({"page", "s.toml", "--no-thumbnails", "--pack", "site", "--pack-crf", "24"});
  EXPECT_THAT(finer.error, HasSubstr("packing s.mp4"));
}

TEST_F(PackCommand, IsRefusedBeforeThePageIsWritten) {
  write("best/mine", "mine");
  fs::remove(folder() / "out/index.html");
  EXPECT_EQ(pack("best").status, 2);
  EXPECT_FALSE(has("out/index.html"));
}

TEST_F(PackCommand, LosesNoLiveBook) {
  write("out/index.html", "<p>live</p>");
  const ChildResult result = run({"page", "s.toml", "--no-thumbnails", "--live", "out/index.html"});
  EXPECT_EQ(result.status, 2);
  EXPECT_THAT(result.error, HasSubstr("out/index.html is the live book that --live names and"));
  EXPECT_EQ(read("out/index.html"), "<p>live</p>");
}

}  // namespace
}  // namespace rotatebook::cli::testing
