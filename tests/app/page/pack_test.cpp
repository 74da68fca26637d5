#include "page/pack.h"

#include <filesystem>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "page/made_folder.h"
#include "store/clip_record.h"
#include "system/read_file.h"
#include "video/clip_reader.h"
#include "video/written_form.h"

namespace rotatebook::page {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using testing::emptyFolder;
using ::testing::HasSubstr;
using testing::makeClip;
using ::testing::Not;
using testing::smallScene;

Figure packedFigure(const fs::path& folder, const scene::Scene& scene = smallScene()) {
  return readFigure(scene, folder, {.isPacked = true});
}

/// Leaves a clip in a folder and packs it into another, which is returned.
fs::path packedFolder(int crf, const scene::Scene& scene = smallScene()) {
  const fs::path folder = emptyFolder();
  const fs::path target = folder / "site";
  makeClip(scene, folder);
  writePack({packedFigure(folder, scene)}, "the page", {folder, target, crf});
  return target;
}

TEST(Pack, KeepsTheRecordAndEachPicture) {
  const fs::path target = packedFolder(kPackCrf);
  const video::ClipMetadata metadata = video::readClipMetadata(target / "small.mp4");
  EXPECT_TRUE(store::isRecordOfClip(smallScene(), metadata.comment));
  EXPECT_EQ(metadata.title, smallScene().title);
  video::ClipReader packed(target / "small.mp4");
  video::ClipReader original(target / ".." / "small.mp4");
  int pictures = 0;
  while (original.next()) {
    ASSERT_TRUE(packed.next());
    EXPECT_EQ(packed.time(), original.time());
    // Black, whatever it is coded with.
    EXPECT_LE(video::distance(packed.picture(), original.picture()).rms, 1);
    ++pictures;
  }
  EXPECT_FALSE(packed.next());
  EXPECT_EQ(pictures, 2);
}

TEST(Pack, KeepsChapters) {
  const scene::Scene scene = smallScene({"cue=[{ chapter = 'The start' }]"});
  const fs::path clip = packedFolder(kPackCrf, scene) / "small.mp4";
  EXPECT_EQ(video::differencesFromWritten(clip, {.width = scene.clip.width,
                                                 .height = scene.clip.height,
                                                 .frameRate = scene.clip.frameRate,
                                                 .frames = 2,
                                                 .chapters = {{0, "The start"}}})
                .container,
            "");
}

TEST(Pack, GivesTheSameBytesAgainAndOthersAtAnotherRate) {
  const auto bytesAt = [](int crf) {
    return system::readFileOrEmpty(packedFolder(crf) / "small.mp4");
  };
  const std::string once = bytesAt(30);
  EXPECT_EQ(bytesAt(30), once);
  EXPECT_NE(bytesAt(20), once);
}

TEST(Pack, NamesOnlyFilesThatItLeaves) {
  const fs::path target = packedFolder(kPackCrf);
  EXPECT_TRUE(fs::exists(target / "small.poster.webp"));
  EXPECT_THAT(system::readFileOrEmpty(target / "small.poster.webp").substr(8, 4), "WEBP");
  EXPECT_THAT(packedFigure(target / "..").section.text,
              AllOf(HasSubstr("data-poster=\"small.poster.webp\""), HasSubstr("href=\"small.mp4\""),
                    Not(HasSubstr(".csv\"")), Not(HasSubstr("poster.png"))));
}

TEST(Pack, CopiesWhatFiguresNameAndCodesTheirPictures) {
  const fs::path folder = emptyFolder();
  testing::touch(folder / "a.plain.png");
  fs::copy_file(fs::path(ROTATEBOOK_SOURCE) / "docs" / "gallery.png", folder / "still.png");
  Figure figure;
  figure.files = {"a.plain.png"};
  figure.pictures = {"still.png"};
  writePack({figure}, "the page", {folder, folder / "site"});
  EXPECT_TRUE(fs::exists(folder / "site" / "a.plain.png"));
  EXPECT_FALSE(fs::exists(folder / "site" / "still.png"));
  EXPECT_THAT(system::readFileOrEmpty(folder / "site" / "still.webp").substr(8, 4), "WEBP");
}

TEST(Pack, RefusesADamagedClip) {
  const fs::path folder = emptyFolder();
  const fs::path target = folder / "site";
  makeClip(smallScene(), folder);
  const Figure figure = packedFigure(folder);
  testing::touch(folder / "small.mp4");
  EXPECT_THROW(writePack({figure}, "the page", {folder, target}), InputError);
  EXPECT_FALSE(fs::exists(target / "small.mp4"));
}

}  // namespace
}  // namespace rotatebook::page
