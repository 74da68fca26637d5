#include "store/map_tiles.h"

#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>

#include "base/error.h"
#include "messages.h"
#include "system/atomic_file.h"

namespace rotatebook::store {
namespace {

namespace fs = std::filesystem;

fs::path emptyTileFolder() {
  const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
  const auto folder = fs::path(ROTATEBOOK_TEST_OUTPUT) / "map_tiles" / test->name();
  fs::remove_all(folder);
  fs::create_directories(folder);
  return folder;
}

TEST(MapTiles, AreReadAsTheyWereWritten) {
  const MapTiles tiles(emptyTileFolder(), "abc");
  tiles.write(7, std::string("x\n\0y", 4));
  EXPECT_EQ(tiles.read(7, 4), std::string("x\n\0y", 4));
  EXPECT_EQ(tiles.read(8, 4), std::nullopt);
  EXPECT_EQ(tiles.read(7, 5), std::nullopt) << "another size";
  EXPECT_EQ(tiles.count().same, 1U);
  EXPECT_EQ(tiles.count().other, 0U);
}

TEST(MapTiles, AreKnownByTheirFingerprint) {
  const fs::path folder = emptyTileFolder();
  MapTiles(folder, "abc").write(0, "1234");
  const MapTiles other(folder, "abd");
  EXPECT_EQ(other.read(0, 4), std::nullopt);
  EXPECT_EQ(other.count().other, 1U);
  EXPECT_EQ(MapTiles(folder, "ab").count().other, 1U);
}

TEST(MapTiles, AreNotReadIfTheyAreDamaged) {
  const fs::path folder = emptyTileFolder();
  const MapTiles tiles(folder, "abc");
  tiles.write(0, "1234");
  std::fstream file(folder / "tile_0", std::ios::in | std::ios::out);
  file.seekp(-1, std::ios::end);
  file << '5';
  file.close();
  EXPECT_EQ(tiles.read(0, 4), std::nullopt);
}

// A power cut leaves a file of zeros, an empty one or a part of one.
TEST(MapTiles, ThatAPowerCutLeftAreMadeAgain) {
  const fs::path folder = emptyTileFolder();
  const MapTiles tiles(folder, "abc");
  for (const std::string& left : {std::string(40, '\0'), std::string(), std::string("ab"),
                                  std::string("abc"), std::string("ab\0\0\n", 5)}) {
    system::writeFileAtomically(folder / "tile_3", left);
    EXPECT_EQ(tiles.count().other, 0U);
    EXPECT_EQ(tiles.count().same, 0U);
    EXPECT_FALSE(tiles.contains(3));
    EXPECT_FALSE(tiles.read(3, 4));
    tiles.write(3, "1234");
    EXPECT_EQ(tiles.read(3, 4), "1234");
  }
}

TEST(MapTiles, AreNoLinksAndNoFolders) {
  const fs::path folder = emptyTileFolder();
  const MapTiles tiles(folder, "abc");
  const auto problem = [&] {
    try {
      tiles.count();
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  fs::create_directory(folder / "tile_1");
  EXPECT_MESSAGE(problem());
  EXPECT_THROW(tiles.remove(), InputError);
  fs::remove(folder / "tile_1");
  system::writeFileAtomically(folder / "mine", "abc\n");
  fs::create_symlink("mine", folder / "tile_1");
  EXPECT_MESSAGE(problem());
  EXPECT_FALSE(tiles.contains(1));
  fs::remove(folder / "tile_1");
  system::writeFileAtomically(folder / "tile_1", "\x89PNG\r\n");
  EXPECT_EQ(tiles.count().other, 1U) << "no tile of a power cut";
  fs::remove(folder / "tile_1");
  system::writeFileAtomically(folder / "tile_notes", "mine");
  EXPECT_EQ(problem(), "");
  tiles.remove();
  EXPECT_TRUE(fs::exists(folder / "tile_notes"));
}

TEST(MapTiles, LeaveOtherFilesAlone) {
  const fs::path folder = emptyTileFolder();
  const MapTiles tiles(folder, "abc");
  EXPECT_EQ(MapTiles(folder / "none", "abc").count().same, 0U);
  tiles.write(0, "1234");
  system::writeFileAtomically(folder / "notes.txt", "mine");
  tiles.remove();
  EXPECT_TRUE(fs::exists(folder / "notes.txt"));
  EXPECT_EQ(tiles.count().same, 0U);
  fs::remove(folder / "notes.txt");
  tiles.remove();
  EXPECT_FALSE(fs::exists(folder));
}

}  // namespace
}  // namespace rotatebook::store
