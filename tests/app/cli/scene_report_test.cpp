#include "cli/scene_report.h"

#include <sstream>
#include <string>

#include <gtest/gtest.h>

namespace rotatebook::cli {
namespace {

/// A scene, and one that can't be read.
std::vector<SceneFile> exampleFiles() {
  scene::Scene scene;
  scene.name = "a";
  scene.title = "Ω \"x\"";
  scene.motions.resize(2);
  scene.motions[0].label = "first";
  scene.motions[1].label = "second";
  return {{.path = "dir/a.toml",
           .scene = scene,
           .frames = 815,
           .notes = {"second: a centimetre is \"1 cm\""}},
          {.path = "dir/b.toml", .errors = {"dir/b.toml:1:1: unknown key \"x\""}}};
}

TEST(SceneReport, HasErrorsAndNotesOfEachCheckedFile) {
  std::ostringstream out;
  reportChecksAsJson(exampleFiles(), out);
  EXPECT_EQ(out.str(),
            R"({"scenes": [{"path": "dir/a.toml", "ok": true, "errors": [], "notes": ["second: )"
            R"(a centimetre is \"1 cm\""], )"
            R"("frames": 815, "panels": ["first", "second"]}, )"
            R"({"path": "dir/b.toml", "ok": false, )"
            R"("errors": ["dir/b.toml:1:1: unknown key \"x\""], "notes": []}]})"
            "\n");
}

TEST(SceneReport, ListsWhatScenesShow) {
  std::ostringstream out;
  reportListAsJson(exampleFiles(), out);
  EXPECT_EQ(out.str(),
            R"({"scenes": [{"path": "dir/a.toml", "ok": true, "errors": [], "name": "a", )"
            R"("title": "Ω \"x\"", "duration_s": 12, "width": 1280, "height": 720, "frames": 720, )"
            R"("panels": ["first", "second"], "has_study": false}, {"path": "dir/b.toml", )"
            R"("ok": false, "errors": ["dir/b.toml:1:1: unknown key \"x\""]}]})"
            "\n");
}

}  // namespace
}  // namespace rotatebook::cli
