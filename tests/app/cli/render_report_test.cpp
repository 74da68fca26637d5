#include "cli/render_report.h"

#include <sstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/batch.h"

namespace rotatebook::cli {
namespace {

using ::testing::HasSubstr;

RenderedScene exampleRender() {
  RenderedScene rendered;
  rendered.scene.name = "tiny";
  rendered.scene.title = "A \"quoted\" title, C:\\new, and 書 🕮";
  rendered.scene.clip.frameRate = {30000, 1001};
  rendered.start = {"a card", "libx264"};
  rendered.result.emplace();
  rendered.result->files = store::clipFiles("out", "tiny");
  rendered.result->csvs = {"out/tiny.csv"};
  rendered.result->framesWritten = 100'000;
  rendered.result->framesKept = 5;
  rendered.result->others = {"out/tiny.gif"};
  return rendered;
}

pipeline::RenderOptions pngAndMp4() {
  pipeline::RenderOptions options;
  options.outputs = pipeline::outputsOf(true, {video::VideoFormat::Mp4});
  return options;
}

std::string jsonOf(const std::vector<RenderedScene>& scenes, bool interrupted = false) {
  const auto asJson = [](const RenderedScene& one) { return renderJson(one, pngAndMp4()); };
  return jsonText(batchJson("scenes", scenes, asJson, interrupted));
}

std::string textOf(const RenderedScene& rendered) {
  std::ostringstream out;
  reportRender(rendered, pngAndMp4(), out);
  return out.str();
}

TEST(RenderReport, IsJson) {
  EXPECT_EQ(jsonOf({exampleRender()}),
            R"({"interrupted":false,"scenes":[{"name":"tiny",)"
            R"("title":"A \"quoted\" title, C:\\new, and 書 🕮","width":1280,"height":720,)"
            R"("frames_per_second":29.97002997002997,"duration_s":12.0,"renderer":"a card",)"
            R"("encoders":"libx264","already_done":false,"interrupted":false,)"
            R"("error":null,"frames_written":100000,"frames_kept":5,)"
            R"("files":["out/tiny.mp4","out/tiny.csv","out/tiny.json","out/tiny.poster.png"],)"
            R"("frame_folder":"out/tiny/","replaced":[],)"
            R"("kept_of_other_settings":["out/tiny.gif"],"note":null,)"
            R"("motions":[]}]})");
}

TEST(RenderReport, HasTheSameFieldsForScenesThatFailedOrWereNotBegun) {
  RenderedScene failed{exampleRender().scene}, waiting{exampleRender().scene};
  failed.error = "can't write \"out\"";
  const std::string json = jsonOf({exampleRender(), failed, waiting}, true);
  EXPECT_THAT(json, HasSubstr(R"("interrupted":true,"scenes":[)"));
  EXPECT_THAT(json, HasSubstr(R"("renderer":null,"encoders":null,"already_done":false,)"
                              R"("interrupted":false,"error":"can't write \"out\"",)"
                              R"("frames_written":0,"frames_kept":0,"files":[],)"
                              R"("frame_folder":null,"replaced":[],"kept_of_other_settings":[],)"
                              R"("note":null,)"
                              R"("motions":[]},{"name":"tiny")"));
}

TEST(RenderReport, NamesTheUnfinishedFilesOfAnInterruptedRender) {
  RenderedScene rendered = exampleRender();
  rendered.interrupted = rendered.result->interrupted = true;
  rendered.result->others = {};
  EXPECT_THAT(jsonOf({rendered}), HasSubstr(R"("files":["out/tiny.partial.mp4"],)"
                                            R"("frame_folder":"out/tiny.partial/")"));
  EXPECT_EQ(textOf(rendered),
            "  kept 5 frames of an earlier run\n"
            "  wrote out/tiny.partial.mp4 and 100000 frames in out/tiny.partial/\n"
            "  interrupted after 100000 frames; go on with the same command and --resume\n");
  rendered.result->framesWritten = rendered.result->framesKept = 0;
  EXPECT_THAT(jsonOf({rendered}), HasSubstr(R"("files":[],"frame_folder":null)"));
  EXPECT_EQ(textOf(rendered), "  interrupted before the first frame; nothing was written\n");
}

TEST(RenderReport, NamesTheFilesThatAnEarlierRunMade) {
  RenderedScene rendered = exampleRender();
  rendered.start.reset();
  rendered.result->framesWritten = rendered.result->framesKept = 0;
  rendered.result->others = {};
  rendered.result->wasDone = true;
  EXPECT_EQ(textOf(rendered), "tiny: already done\n");
  EXPECT_THAT(jsonOf({rendered}),
              HasSubstr(R"("already_done":true,"interrupted":false,"error":null,)"
                        R"("frames_written":0,"frames_kept":0,"files":["out/tiny.mp4",)"));
}

TEST(RenderReport, HasNotesOnWhatIsLostAndWhatStays) {
  RenderedScene rendered = exampleRender();
  rendered.result->replaced = {"out/tiny.mp4", "out/ti\nny.csv"};
  rendered.result->remainder = "the earlier clip stays";
  rendered.motions.resize(1);
  rendered.motions[0].notes = {"the regime changes"};
  std::ostringstream out;
  reportRenderNotes(rendered, out);
  EXPECT_EQ(out.str(),
            "note: tiny: replaced out/tiny.mp4 and out/ti\\nny.csv, made with other settings\n"
            "note: tiny: kept out/tiny.gif, made with other settings\n"
            "note: tiny: the earlier clip stays\n"
            "note: tiny: the regime changes\n");
}

TEST(RenderReport, SaysOnceThatSettingsAreUnknown) {
  RenderedScene rendered = exampleRender();
  rendered.result->replaced = {"out/a.webm (with unknown settings)", "out/tiny.csv"};
  rendered.result->others.clear();
  std::ostringstream out;
  reportRenderNotes(rendered, out);
  EXPECT_EQ(out.str(),
            "note: tiny: replaced out/tiny.csv, made with other settings\n"
            "note: tiny: replaced out/a.webm (with unknown settings)\n");
}

TEST(RenderReport, ListsWhatWasWrittenAndKept) {
  EXPECT_EQ(
      textOf(exampleRender()),
      "  kept 5 frames of an earlier run\n"
      "  wrote out/tiny.mp4, out/tiny.csv, out/tiny.json, out/tiny.poster.png and 100000 frames in "
      "out/tiny/\n");
  RenderedScene none{exampleRender().scene};
  none.interrupted = true;
  EXPECT_EQ(textOf(none), "tiny: interrupted while simulating; nothing was written\n");
}

}  // namespace
}  // namespace rotatebook::cli
