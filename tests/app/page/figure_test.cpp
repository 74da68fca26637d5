#include "page/figure.h"

#include <filesystem>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/checksum.h"
#include "messages.h"
#include "page/clip_videos.h"
#include "page/made_folder.h"
#include "store/manifest.h"
#include "system/file_checksum.h"

namespace rotatebook::page {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::ContainsRegex;
using ::testing::ElementsAre;
using testing::emptyFolder;
using ::testing::HasSubstr;
using testing::makeClip;
using testing::makePicture;
using testing::makeVideo;
using testing::messageOf;
using ::testing::Not;
using testing::recordOf;
using testing::smallScene;
using testing::touch;

TEST(ClipFigure, HasItsWordsItsFilesAndItsData) {
  const fs::path folder = emptyFolder();
  makeClip(smallScene(), folder);
  const Figure figure = readFigure(smallScene(), folder);
  EXPECT_EQ(figure.kind, FigureKind::Clip);
  EXPECT_EQ(figure.id, "small");
  EXPECT_EQ(figure.thumbnail, "small.poster.png");
  EXPECT_THAT(
      figure.section.text,
      AllOf(HasSubstr("Small &amp; &lt;small&gt;"), HasSubstr("It&#39;s &quot;small&quot;."),
            HasSubstr("src=\"small.mp4\""), HasSubstr("href=\"small.csv\""),
            HasSubstr("max=\"11\""), HasSubstr("\"rate\":[24,1],\"frames\":12")));
  EXPECT_THAT(figure.section.text, Not(HasSubstr("<small>")));
  EXPECT_EQ(readFigure(smallScene(), folder, {.hasThumbnails = true}).thumbnail,
            "small.thumbnail.png");
}

TEST(ClipFigure, TellsWhatHappensInCaptionsAndInAList) {
  const fs::path folder = emptyFolder();
  const scene::Scene scene = smallScene({"nudge=[{ at = 0.25, angular_velocity = [0, 0, 0.01] }]"});
  makeClip(scene, folder);
  EXPECT_THAT(
      readFigure(scene, folder).section.text,
      AllOf(HasSubstr("src=\"data:text/"
                      "vtt;charset=utf-8,WEBVTT%20rotatebook%0A%0A00%3A00%3A00.250%20--%3E"),
            HasSubstr("<button type=\"button\" data-frame=\"6\">0.25 s: nudge 1<")));
}

TEST(ClipFigure, HasOfItsMotionsWhatItPlots) {
  const fs::path folder = emptyFolder();
  const auto dataOf = [&](const scene::Scene& scene) {
    makeClip(scene, folder);
    const std::string text = readFigure(scene, folder).section.text;
    return text.substr(text.find("class=\"data\""));
  };
  EXPECT_THAT(dataOf(smallScene()),
              AllOf(HasSubstr("\"poster\":6"), Not(HasSubstr("kinetic")), HasSubstr("\"total\":[1"),
                    ContainsRegex("\"tilt\":\\[[0-9.]{1,6},[0-9.]{1,6},")));
  EXPECT_THAT(dataOf(smallScene({"clip.poster=0.125", "simulation.model=particles"})),
              AllOf(HasSubstr("\"poster\":3"), HasSubstr("\"kinetic\":[")));
}

TEST(ClipFigure, SaysWhetherItsPicturesHaveItsCaption) {
  const fs::path folder = emptyFolder();
  const auto captionIn = [&](const std::vector<std::string>& overrides, const Language& say = {}) {
    makeClip(smallScene(overrides), folder);
    const std::string text = readFigure(smallScene(overrides), folder, {}, say).section.text;
    const std::size_t from = text.find("<p class=\"caption");
    return text.substr(from, text.find('>', from) - from);
  };
  const std::string show = "overlay.show=[\"caption\"]";
  EXPECT_EQ(captionIn({}), "<p class=\"caption\" id=\"small/caption\"");
  EXPECT_EQ(captionIn({show}), "<p class=\"caption drawn\" id=\"small/caption\"");
  EXPECT_EQ(captionIn({show, "cue=[{ at = 0.1, text = \"Now\" }]"}),
            "<p class=\"caption\" id=\"small/caption\"");
  Language other;
  other.texts["It's \"small\"."] = "Klein.";
  EXPECT_EQ(captionIn({show}, other), "<p class=\"caption\" id=\"small/caption\"");
}

TEST(ClipFigure, DistinguishesExpectedFromMeasured) {
  const fs::path folder = emptyFolder();
  makeClip(smallScene(), folder);
  const Figure figure = readFigure(smallScene(), folder);
  EXPECT_THAT(figure.badge.text, AllOf(HasSubstr("unmet"), HasSubstr("1 of 2 expectations met")));
  EXPECT_THAT(
      figure.section.text,
      AllOf(HasSubstr("<th scope=\"row\">half_turns<span class=\"meaning\">how many times the "
                      "axis that the book was spun about has turned over</span></th>"
                      "<td>at most 0</td><td>0</td><td class=\"met\">✓ met</td>"),
            HasSubstr("angular momentum at the start</span></th><td>at least 2</td>"),
            HasSubstr("<td class=\"unmet\">✗ not met</td>")));
}

TEST(ClipFigure, FoldsItsExpectations) {
  const fs::path folder = emptyFolder();
  makeClip(smallScene(), folder);
  const auto figureOf = [&](const std::vector<std::string>& overrides) {
    makeClip(smallScene(overrides), folder);
    return readFigure(smallScene(overrides), folder);
  };
  const Figure unmet = figureOf({});
  EXPECT_THAT(unmet.section.text,
              AllOf(HasSubstr("<details class=\"expectations\" open>\n<summary><span class=\"badge "
                              "unmet\">1 of 2 expectations met</span></summary>"),
                    HasSubstr(unmet.badge.text)));
  const Figure met = figureOf({"expect={half_turns.max = 0}"});
  EXPECT_EQ(met.badge.text, "");
  EXPECT_THAT(met.section.text,
              HasSubstr("<details class=\"expectations\">\n<summary><span class=\"badge "
                        "met\">1 of 1 expectation met</span></summary>"));
  const Figure none = figureOf({"expect={}"});
  EXPECT_EQ(none.badge.text, "");
  EXPECT_THAT(none.section.text,
              AllOf(Not(HasSubstr("expectations")), Not(HasSubstr("Expected and measured"))));
}

TEST(ClipFigure, HasNoEmptyHeading) {
  const fs::path folder = emptyFolder();
  makeClip(smallScene(), folder);
  EXPECT_THAT(readFigure(smallScene(), folder).section.text, Not(ContainsRegex("<th[^>]*></th>")));
}

TEST(ClipFigure, LinksToFramesOnlyWhereThereAreThoseOfItsScene) {
  const fs::path folder = emptyFolder();
  makeClip(smallScene(), folder);
  const auto links = [&](bool frames, bool record) {
    const std::string text = readFigure(smallScene(), folder).section.text;
    EXPECT_EQ(text.find("href=\"small/\"") != text.npos, frames);
    EXPECT_EQ(text.find("href=\"small/scene.toml\"") != text.npos, record);
  };
  links(false, false);
  fs::create_directories(folder / "small");
  system::writeFileAtomically(folder / "small" / "scene.toml", recordOf(smallScene()));
  links(false, true);
  for (std::int64_t frame = 0; frame < 11; ++frame) {
    touch(folder / "small" / store::frameName(frame));
  }
  links(false, true);  // One is missing.
  touch(folder / "small" / store::frameName(11));
  links(true, true);
  system::writeFileAtomically(folder / "small" / "scene.toml",
                              recordOf(smallScene({"look.background=stars"})));
  links(false, false);
  touch(folder / "small" / "scene.toml");
  links(false, false);
}

TEST(ClipFigure, SaysWhenItsMotionDiverges) {
  const fs::path folder = emptyFolder();
  const scene::Scene scene = smallScene({"simulation.model=particles", "simulation.substeps=1",
                                         "simulation.normalize=false", "simulation.damping=0"});
  makeClip(scene, folder);
  const Figure figure = readFigure(scene, folder);
  EXPECT_THAT(figure.section.text,
              AllOf(HasSubstr("The motion diverges at 0.125 s"),
                    HasSubstr("diverges, and so ends [s]</span></th><td>no divergence</td>"),
                    HasSubstr("2000 N/m, undamped")));
}

TEST(ClipFigure, NamesAMissingFileAndTheRemedy) {
  const fs::path folder = emptyFolder();
  for (const char* name : {"small.mp4", "small.csv", "small.json", "small.poster.png"}) {
    makeClip(smallScene(), folder);
    fs::remove(folder / name);
    EXPECT_EQ(messageOf(smallScene(), folder),
              (folder / name).string() +
                  " is missing; render it first: rotatebook render scenes/small.toml -o " +
                  folder.string());
  }
}

/// " ...: rotatebook render" at the end of a refusal.
std::string remedyIn(const fs::path& folder) {
  return "; render it again (or give this command the same --size and --set): rotatebook render "
         "scenes/small.toml -o " +
         folder.string();
}

TEST(ClipFigure, RefusesTheClipOfAnotherMotion) {
  const fs::path folder = emptyFolder();
  makeClip(smallScene(), folder);
  EXPECT_EQ(messageOf(smallScene(), folder), "no error");
  EXPECT_MESSAGE(messageOf(smallScene({"initial.angular_velocity=[5, 3, 2]"}), folder));
}

TEST(ClipFigure, RefusesTheResultOfOtherExpectations) {
  const fs::path folder = emptyFolder();
  makeClip(smallScene(), folder);
  const std::string expected =
      (folder / "small.json").string() + " was made from another scene or with other settings";
  EXPECT_EQ(messageOf(smallScene({"expect={}"}), folder), expected + remedyIn(folder));
  touch(folder / "small.json");
  EXPECT_EQ(messageOf(smallScene(), folder), expected + remedyIn(folder));
}

TEST(ClipFigure, RefusesPicturesOfAnotherSize) {
  const fs::path folder = emptyFolder();
  makeClip(smallScene({"clip.size=[48, 64]"}), folder);
  const std::string difference = ": its pictures are 48x64, and the scene's are 64x36";
  EXPECT_EQ(messageOf(smallScene(), folder),
            (folder / "small.mp4").string() + difference + remedyIn(folder));
  makeClip(smallScene(), folder);
  makePicture(folder / "small.poster.png", 48, 64);
  EXPECT_EQ(messageOf(smallScene(), folder),
            (folder / "small.poster.png").string() + difference + remedyIn(folder));
  makePicture(folder / "small.poster.png", 64, 36);
  EXPECT_EQ(messageOf(smallScene(), folder), "no error");
}

TEST(ClipFigure, RefusesAVideoOfOtherSettings) {
  const fs::path folder = emptyFolder();
  makeClip(smallScene({"look.background=stars"}), folder);
  EXPECT_EQ(messageOf(smallScene(), folder),
            (folder / "small.mp4").string() +
                ": it was made from another scene or with other settings" + remedyIn(folder));
  touch(folder / "small.mp4");
  EXPECT_MESSAGE(messageOf(smallScene(), folder));
}

TEST(ClipFigure, LinksToTheVideosOfItsSceneAndSaysWhichAreNot) {
  using enum video::VideoFormat;
  const fs::path folder = emptyFolder();
  makeClip(smallScene(), folder);
  makeVideo(smallScene({"look.background=stars"}), folder, WebM);
  makeVideo(smallScene({"clip.size=[32, 18]"}), folder, Gif);
  makeVideo(smallScene(), folder, Apng);
  Figure figure = readFigure(smallScene(), folder);
  EXPECT_THAT(figure.section.text,
              AllOf(HasSubstr("href=\"small.mp4\""), HasSubstr("href=\"small.apng\""),
                    Not(HasSubstr("small.webm")), Not(HasSubstr("small.gif"))));
  EXPECT_THAT(figure.leftOut,
              ::testing::ElementsAre(
                  (folder / "small.webm").string() +
                      " isn't linked: it was made from another scene or with other settings",
                  (folder / "small.gif").string() +
                      " isn't linked: its pictures are 32x18, and the scene's are 64x36"));
  makeVideo(smallScene(), folder, WebM);
  makeVideo(smallScene({"look.background=stars"}), folder, Mp4);
  figure = readFigure(smallScene(), folder);
  EXPECT_THAT(figure.section.text,
              AllOf(HasSubstr("src=\"small.webm\""), Not(HasSubstr("small.mp4"))));
}

/// Leaves a GIF as the only video of `scene`, the record of `recorded` beside it, and the manifest
/// of a render that made both.
void makeGifAlone(const scene::Scene& scene, const scene::Scene& recorded, const fs::path& folder) {
  makeClip(scene, folder);
  const store::ClipFiles files = store::clipFiles(folder, scene.name);
  fs::remove(files.video(video::VideoFormat::Mp4));
  makeVideo(scene, folder, video::VideoFormat::Gif);
  const fs::path gif = files.video(video::VideoFormat::Gif);
  fs::create_directories(files.frameFolder);
  system::writeFileAtomically(files.sceneCopy, recordOf(recorded));
  store::Manifest manifest;
  manifest.own.made["scene"] = checksumOf(sceneText(recorded));
  manifest.own.files[gif.filename().string()] = system::checksumOfFile(gif);
  system::writeFileAtomically(files.frameFolder / store::kManifestName,
                              store::manifestText(manifest));
}

TEST(ClipFigure, ShowsAGifWhereThereIsNoVideo) {
  const fs::path folder = emptyFolder();
  makeGifAlone(smallScene(), smallScene(), folder);
  const Figure figure = readFigure(smallScene(), folder);
  EXPECT_THAT(figure.section.text,
              AllOf(HasSubstr("data-moving=\"small.gif\""), HasSubstr("href=\"small.gif\""),
                    Not(HasSubstr("<video"))));
  EXPECT_EQ(figure.clip, "small.gif");
}

TEST(ClipFigure, RefusesAGifThatMayBeOfAnotherScene) {
  const fs::path folder = emptyFolder();
  const std::string refusal = (folder / "small.gif").string() + ": " + kOtherSettings;
  makeGifAlone(smallScene(), smallScene({"look.background=stars"}), folder);
  EXPECT_MESSAGE(messageOf(smallScene(), folder));
  makeGifAlone(smallScene(), smallScene(), folder);
  makeVideo(smallScene({"clip.fps=12"}), folder, video::VideoFormat::Gif);
  EXPECT_MESSAGE(messageOf(smallScene(), folder));
}

TEST(ClipFigure, HasAColumnAndATableForEachPanel) {
  const fs::path folder = emptyFolder();
  const scene::Scene scene = scene::parseScene(
      "title = \"Pair\"\n[clip]\nsize = [64, 36]\nfps = 24\nduration = 0.5\n"
      "[initial]\nangular_velocity = [5, 3, 1]\n"
      "[[panel]]\nlabel = \"Euler's\"\nexpect.half_turns.max = 0\n"
      "[[panel]]\nlabel = \"exact\"\nsimulation.model = \"exact\"\n",
      "scenes/pair.toml");
  makeClip(scene, folder);
  const Figure figure = readFigure(scene, folder);
  EXPECT_EQ(figure.kind, FigureKind::Comparison);
  EXPECT_THAT(figure.section.text,
              AllOf(HasSubstr("<th>Euler&#39;s</th><th>exact</th>"),
                    HasSubstr("<td>quaternion</td><td>exact</td>"),
                    HasSubstr("<caption>Expected and measured: Euler&#39;s</caption>"),
                    HasSubstr("\"label\":\"Euler's\""), HasSubstr("href=\"pair_exact.csv\"")));
  fs::remove(folder / "pair_exact.csv");
  EXPECT_MESSAGE(messageOf(scene, folder));
}

TEST(StillFigure, IsAPictureWithoutAClip) {
  const fs::path folder = emptyFolder();
  makePicture(folder / "small.png", 80, 45);
  const Figure figure = readFigure(smallScene(), folder);
  EXPECT_EQ(figure.kind, FigureKind::Still);
  EXPECT_EQ(figure.thumbnail, "small.png");
  EXPECT_THAT(figure.section.text,
              AllOf(HasSubstr("src=\"small.png\""), HasSubstr("width=\"80\" height=\"45\""),
                    Not(HasSubstr("<table"))));
  makeClip(smallScene(), folder);
  EXPECT_EQ(readFigure(smallScene(), folder).kind, FigureKind::Clip);
}

TEST(StillFigure, CanBePlayedWithUnlessItIsOfARecording) {
  const fs::path folder = emptyFolder();
  makePicture(folder / "small.png", 80, 45);
  EXPECT_THAT(readFigure(smallScene(), folder).section.text, HasSubstr("Play with this"));
  const scene::Scene recorded = scene::parseScene(
      "[simulation]\nmodel = \"recorded\"\nfile = \"a.csv\"\n", "scenes/small.toml", {});
  EXPECT_THAT(readFigure(recorded, folder).section.text, Not(HasSubstr("Play with this")));
}

}  // namespace
}  // namespace rotatebook::page
