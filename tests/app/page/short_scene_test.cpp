#include "page/short_scene.h"

#include <filesystem>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "page/made_folder.h"
#include "store/scene_file.h"

namespace rotatebook::page {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::Not;

TEST(ShortText, IsWhatOneWouldWrite) {
  EXPECT_EQ(shortText(testing::smallScene()),
            "title = \"Small & <small>\"\n"
            "caption = \"It's \\\"small\\\".\"\n"
            "\n[initial]\nangular_velocity = [5.0, 3.0, 1.0]\n"
            "\n[clip]\nsize = [64, 36]\nfps = 24\nduration = 0.5\n"
            "\n[expect]\nhalf_turns = { max = 0.0, from = 0.0 }\n"
            "L_ratio = { min = 2.0, from = 0.0 }\n");
}

TEST(ShortText, OfAllShippedScenesHasNoCommentAndReadsBackEqual) {
  std::size_t size = 0, whole = 0;
  for (const auto& entry : fs::recursive_directory_iterator(ROTATEBOOK_SOURCE "/scenes")) {
    if (entry.path().extension() != ".toml") continue;
    const scene::Scene scene = store::readScene(entry.path());
    const std::string text = shortText(scene);
    EXPECT_THAT(text, Not(HasSubstr("  # "))) << entry.path();
    size += text.size();
    whole += sceneText(scene).size();
    EXPECT_EQ(sceneText(scene::parseScene(text, scene.name + ".toml")), sceneText(scene));
  }
  // Measured 0.34.
  EXPECT_LT(10 * size, 4 * whole) << size << " of " << whole << " bytes";
}

TEST(ShortText, IsTheWholeTextIfWordsLookLikeAComment) {
  const scene::Scene scene = testing::smallScene({"title=A  # B"});
  EXPECT_EQ(shortText(scene), sceneText(scene));
}

}  // namespace
}  // namespace rotatebook::page
