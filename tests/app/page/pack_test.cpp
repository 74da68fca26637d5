#include "page/pack.h"

#include <chrono>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>
#include <zip.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "page/made_folder.h"
#include "page/page.h"
#include "store/clip_record.h"
#include "system/read_file.h"
#include "video/clip_reader.h"

namespace rotatebook::page {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::ElementsAre;
using testing::emptyFolder;
using ::testing::HasSubstr;
using testing::makeClip;
using ::testing::Not;
using testing::smallScene;

Figure packedFigure(const fs::path& folder) {
  return readFigure(smallScene(), folder, {.isPacked = true});
}

/// Leaves a clip in a folder and packs it into another, which is returned.
fs::path packedFolder(int crf) {
  const fs::path folder = emptyFolder();
  const fs::path target = folder / "site";
  fs::create_directories(target);
  makeClip(smallScene(), folder);
  packFiles({packedFigure(folder)}, folder, target, crf);
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
  fs::create_directories(folder / "site");
  testing::touch(folder / "a.plain.png");
  fs::copy_file(fs::path(ROTATEBOOK_SOURCE) / "docs" / "gallery.png", folder / "still.png");
  Figure figure;
  figure.files = {"a.plain.png"};
  figure.pictures = {"still.png"};
  packFiles({figure}, folder, folder / "site", kPackCrf);
  EXPECT_TRUE(fs::exists(folder / "site" / "a.plain.png"));
  EXPECT_FALSE(fs::exists(folder / "site" / "still.png"));
  EXPECT_THAT(system::readFileOrEmpty(folder / "site" / "still.webp").substr(8, 4), "WEBP");
}

TEST(Pack, RefusesADamagedClip) {
  const fs::path folder = emptyFolder();
  const fs::path target = folder / "site";
  fs::create_directories(target);
  makeClip(smallScene(), folder);
  const Figure figure = packedFigure(folder);
  testing::touch(folder / "small.mp4");
  EXPECT_THROW(packFiles({figure}, folder, target, kPackCrf), InputError);
  EXPECT_FALSE(fs::exists(target / "small.mp4"));
}

std::vector<std::string> namesIn(const fs::path& zip) {
  const std::unique_ptr<zip_t, decltype([](zip_t* archive) { zip_discard(archive); })> archive(
      zip_open(zip.c_str(), ZIP_RDONLY | ZIP_CHECKCONS, nullptr));
  std::vector<std::string> names;
  if (archive == nullptr) return names;
  for (zip_int64_t i = 0; i < zip_get_num_entries(archive.get(), 0); ++i) {
    names.emplace_back(zip_get_name(archive.get(), static_cast<zip_uint64_t>(i), 0));
  }
  return names;
}

TEST(Zip, HoldsTheFolderWhole) {
  const fs::path folder = emptyFolder();
  fs::create_directories(folder / "site");
  system::writeFileAtomically(folder / "site" / "b.txt", "two, as they are");
  system::writeFileAtomically(folder / "site" / "ä.txt", "one");
  writeZip(folder / "site", folder / "a.zip");
  EXPECT_THAT(namesIn(folder / "a.zip"), ElementsAre("b.txt", "ä.txt"));
  EXPECT_THAT(system::readFileOrEmpty(folder / "a.zip"), HasSubstr("two, as they are"));
}

TEST(Zip, IsTheSameOfTheSameFiles) {
  const fs::path folder = emptyFolder();
  fs::create_directories(folder / "site");
  const fs::path file = folder / "site" / "a.txt";
  system::writeFileAtomically(file, "a");
  writeZip(folder / "site", folder / "1.zip");
  fs::last_write_time(file, fs::last_write_time(file) - std::chrono::hours(100));
  writeZip(folder / "site", folder / "2.zip");
  EXPECT_EQ(system::readFileOrEmpty(folder / "1.zip"), system::readFileOrEmpty(folder / "2.zip"));
}

TEST(Zip, SaysWhenItCantBeWritten) {
  const fs::path folder = emptyFolder();
  EXPECT_THROW(writeZip(folder, folder / "nowhere" / "a.zip"), MachineError);
}

}  // namespace
}  // namespace rotatebook::page
