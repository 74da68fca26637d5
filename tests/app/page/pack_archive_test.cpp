#include "page/pack_archive.h"

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
#include "page/pack_folder.h"
#include "system/read_file.h"

namespace rotatebook::page {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using testing::emptyFolder;
using ::testing::HasSubstr;

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

/// Returns a folder with the pack site/ of b.txt and ä.txt, and mine.txt, which isn't of it.
fs::path folderWithPack() {
  const fs::path folder = emptyFolder();
  PackFolder pack(folder / "site", {"b.txt", "ä.txt"});
  pack.write("b.txt", "two, as they are");
  pack.write("ä.txt", "one");
  pack.finish();
  testing::touch(folder / "site" / "mine.txt");
  return folder;
}

TEST(Zip, HoldsThePackWhole) {
  const fs::path folder = folderWithPack();
  writeZip(folder / "site", {"ä.txt", "b.txt", "b.txt"}, folder / "a.zip");
  EXPECT_THAT(namesIn(folder / "a.zip"), ElementsAre("b.txt", kPackMark, "ä.txt"));
  EXPECT_THAT(system::readFileOrEmpty(folder / "a.zip"), HasSubstr("two, as they are"));
  EXPECT_NO_THROW(requirePackArchive(folder / "a.zip"));
  EXPECT_NO_THROW(requirePackArchive(folder / "none.zip"));
}

TEST(Zip, IsTheSameOfTheSameFiles) {
  const fs::path folder = folderWithPack();
  const fs::path file = folder / "site" / "b.txt";
  writeZip(folder / "site", {"b.txt"}, folder / "1.zip");
  fs::last_write_time(file, fs::last_write_time(file) - std::chrono::hours(100));
  writeZip(folder / "site", {"b.txt"}, folder / "2.zip");
  EXPECT_EQ(system::readFileOrEmpty(folder / "1.zip"), system::readFileOrEmpty(folder / "2.zip"));
}

TEST(Zip, IsNoPackWithMoreOrOtherFiles) {
  const fs::path folder = folderWithPack();
  writeZip(folder / "site", {"b.txt", "mine.txt"}, folder / "more.zip");
  EXPECT_THROW(requirePackArchive(folder / "more.zip"), InputError);
  system::writeFileAtomically(folder / "site" / "b.txt", "changed");
  writeZip(folder / "site", {"b.txt"}, folder / "other.zip");
  EXPECT_THROW(requirePackArchive(folder / "other.zip"), InputError);
  testing::touch(folder / "x.zip");
  EXPECT_THROW(requirePackArchive(folder / "x.zip"), InputError);
}

TEST(Zip, IsNoPackWithCommentsOrOtherBytes) {
  const fs::path folder = folderWithPack(), file = folder / "a.zip";
  writeZip(folder / "site", {"b.txt", "ä.txt"}, file);
  const std::string own = system::readFileOrEmpty(file);
  const auto isRefused = [&](const auto& change) {
    system::writeFileAtomically(file, own);
    zip_t* archive = zip_open(file.c_str(), 0, nullptr);
    change(archive);
    EXPECT_EQ(zip_close(archive), 0);
    try {
      requirePackArchive(file);
    } catch (const InputError&) {
      return true;
    }
    return false;
  };
  EXPECT_FALSE(isRefused([](zip_t*) {}));
  EXPECT_TRUE(isRefused([](zip_t* archive) { zip_set_archive_comment(archive, "mine", 4); }));
  EXPECT_TRUE(isRefused([](zip_t* archive) { zip_file_set_comment(archive, 0, "mine", 4, 0); }));
  EXPECT_TRUE(isRefused([](zip_t* archive) {
    const zip_uint8_t bytes[]{1, 2};
    zip_file_extra_field_set(archive, 0, 0x7fff, 0, bytes, 2, ZIP_FL_CENTRAL);
  }));
  system::writeFileAtomically(file, "#!/bin/sh\n" + own);
  EXPECT_THROW(requirePackArchive(file), InputError);
}

TEST(Zip, SaysWhenItCantBeWritten) {
  const fs::path folder = folderWithPack();
  EXPECT_THROW(writeZip(folder / "site", {"b.txt"}, folder / "nowhere" / "a.zip"), MachineError);
}

}  // namespace
}  // namespace rotatebook::page
