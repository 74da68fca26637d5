#include <filesystem>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "messages.h"
#include "page/figure.h"
#include "page/made_folder.h"
#include "store/fingerprint.h"

namespace rotatebook::page {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using testing::emptyFolder;
using ::testing::HasSubstr;
using testing::messageOf;
using testing::smallScene;
using testing::touch;

/// Writes the files that `rotatebook study` leaves, with this result.
void makeStudy(const fs::path& folder, const std::string& json) {
  for (const char* ending : {".png", ".svg", ".pdf", ".csv"})
    touch(folder / (std::string("small-study") + ending));
  system::writeFileAtomically(folder / "small-study.json", json);
}

/// Returns the result of a scene's study with these expectations.
std::string resultOf(const scene::Scene& scene, const std::string& expectations) {
  return R"({"scene_xxh128":")" + store::studySceneChecksum(scene) + R"(","expectations":[)" +
         expectations + "]}";
}

const std::vector<std::string> kStudy{
    "study.curves={ key = 'simulation.integrator', "
    "values = ['euler', 'rk4'] }",
    "study.x={ key = 'simulation.substeps', values = [1, 2] }"};

TEST(StudyFigure, TakesWhatIsExpectedFromItsResult) {
  const fs::path folder = emptyFolder();
  const scene::Scene scene = smallScene(kStudy);
  makeStudy(folder, resultOf(scene, R"({"quantity":"order of rk4","meaning":"<power>",
                                "min":3.9,"max":null,"measured":4.01,"met":true},
                               {"quantity":"order of euler","meaning":"power",
                                "min":null,"max":0.5,"measured":null,"met":false},
                               {"quantity":"diverges_at at 1,2",
                                "meaning":"when","min":8.0,"max":null,"measured":"inf",
                                "met":true})"));
  const Figure figure = readFigure(scene, folder);
  EXPECT_EQ(figure.kind, FigureKind::Study);
  EXPECT_EQ(figure.thumbnail, "small-study.svg");
  EXPECT_THAT(figure.files, ElementsAre("small-study.png", "small-study.svg", "small-study.pdf",
                                        "small-study.csv"));
  const std::string& text = figure.section.text;
  EXPECT_THAT(text, HasSubstr("order of rk4"));
  EXPECT_THAT(text, HasSubstr("&lt;power&gt;</span></th><td>at least 3.9</td><td>4.01</td><td "
                              "class=\"met\""));
  EXPECT_THAT(text, HasSubstr("<td>at most 0.5</td><td>nothing</td><td class=\"unmet\""));
  EXPECT_THAT(text, HasSubstr("<td>at least 8</td><td>inf</td><td class=\"met\""));
  EXPECT_THAT(text, HasSubstr("src=\"small-study.svg\""));
}

TEST(StudyFigure, RefusesAnotherResult) {
  const fs::path folder = emptyFolder();
  const scene::Scene scene = smallScene(kStudy);
  const auto refusalOf = [&](const std::string& json, const scene::Scene& shown) {
    makeStudy(folder, json);
    return messageOf(shown, folder);
  };
  const std::string right = resultOf(scene, "");
  EXPECT_EQ(refusalOf(right, scene), "no error");
  EXPECT_EQ(refusalOf(right, smallScene({kStudy[0], kStudy[1], "title=\"Other\"",
                                         "clip.size=[64, 36]", "camera.frame=\"body\""})),
            "no error");
  const std::string refusal = (folder / "small-study.json").string() +
                              " isn't the result of the scene's study; run the study again (or "
                              "give this command the same --set): rotatebook study "
                              "scenes/small.toml -o " +
                              folder.string();
  for (const std::string& json : {resultOf(scene, "7"), resultOf(scene, "{}"), std::string("[]"),
                                  std::string(), std::string("\0\xff,\n,,\n", 7)})
    EXPECT_EQ(refusalOf(json, scene), refusal) << json;
  for (const char* change : {"study.x.values=[1, 4]", "study.curves.values=[\"rk4\"]",
                             "clip.duration=7", "study.expect=[{ of = 'order', min = 3.9 }]"})
    EXPECT_EQ(refusalOf(right, smallScene({kStudy[0], kStudy[1], change})), refusal) << change;
}

TEST(StudyFigure, NamesAMissingFileAndTheRemedy) {
  const fs::path folder = emptyFolder();
  const scene::Scene scene = smallScene(kStudy);
  EXPECT_MESSAGE(messageOf(scene, folder));
}

}  // namespace
}  // namespace rotatebook::page
