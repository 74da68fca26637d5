#include "store/map_tiles.h"

#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>

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
