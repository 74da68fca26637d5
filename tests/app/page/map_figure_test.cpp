// The figure of a map.
#include <filesystem>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "messages.h"
#include "page/figure.h"
#include "page/made_folder.h"
#include "pipeline/make_map.h"

namespace rotatebook::page {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using testing::emptyFolder;
using ::testing::HasSubstr;
using ::testing::Not;

scene::Scene mapScene(const std::vector<std::string>& overrides = {}) {
  return scene::parseScene(
      "title = 'Bodies & <more>'\n[simulation]\nmodel = 'exact'\n"
      "[initial]\nangular_velocity = [5, 0, 0]\n[map]\n"
      "x = { key = 'moments.smallest', from = 0, to = 1 }\n"
      "y = { key = 'moments.middle', from = 0.5, to = 1 }\n"
      "size = [8, 6]\nmeasure = 'growth'\n"
      "expect = [{ of = 'largest', max = 2 }, { of = 'share', outcome = 'refused', max = 0.1 }]\n",
      "scenes/bodies.toml", overrides);
}

void makeIn(const fs::path& folder) {
  const scene::Scene scene = mapScene();
  const store::MapFiles files = store::mapFiles(folder, scene.name);
  const study::MapRuns runs(scene);
  pipeline::writeMap(scene, runs, pipeline::makeMap(scene, runs, files, {}).result, files);
}

TEST(MapFigure, HasItsPictureItsFilesAndItsExpectations) {
  const fs::path folder = emptyFolder();
  makeIn(folder);
  const Figure figure = readFigure(mapScene(), folder);
  EXPECT_EQ(figure.kind, FigureKind::Map);
  EXPECT_EQ(figure.thumbnail, "bodies.plain.png");
  EXPECT_THAT(figure.section.text,
              AllOf(HasSubstr("Bodies &amp; &lt;more&gt;"), HasSubstr("src=\"bodies.png\""),
                    HasSubstr("href=\"bodies.npy\""), HasSubstr("largest value"),
                    HasSubstr("share refused"), HasSubstr("1 of 2 expectations met")));
  EXPECT_THAT(readFigure(mapScene(), folder, {.isPacked = true}).section.text,
              Not(HasSubstr("bodies.npy")))
      << "megabytes that a page for the web does without";
}

TEST(MapFigure, IsOfThisSceneAlone) {
  const fs::path folder = emptyFolder();
  const auto messageOf = [&](const scene::Scene& scene) -> std::string {
    try {
      readFigure(scene, folder);
      return "no error";
    } catch (const InputError& error) {
      return error.what();
    }
  };
  EXPECT_MESSAGE(messageOf(mapScene()));
  makeIn(folder);
  EXPECT_EQ(messageOf(mapScene()), "no error");
  for (const char* other : {"map.size=[8, 7]", "title=Other", "map.expect=[]"}) {
    EXPECT_MESSAGE(messageOf(mapScene({other})));
  }
}

}  // namespace
}  // namespace rotatebook::page
