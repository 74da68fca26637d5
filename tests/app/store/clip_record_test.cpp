#include "store/clip_record.h"

#include <cstdint>
#include <filesystem>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/checksum.h"
#include "base/error.h"
#include "base/version.h"
#include "image/png_file.h"
#include "messages.h"
#include "picture/texture_files.h"
#include "pipeline/small_clip.h"
#include "scene/scene_text.h"
#include "store/encoding.h"
#include "timeline/motion_checksum.h"
#include "video/decoded_video.h"
#include "video/video_writer.h"

namespace rotatebook::store {
namespace {

namespace fs = std::filesystem;
using pipeline::testing::emptyFolder;
using pipeline::testing::smallScene;
using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::StartsWith;

const Provenance kProvenance{"small", "1.2.3", "some renderer", "5.1", "0123"};

std::string smallRecord() {
  return sceneRecord(smallScene(), kProvenance);
}

/// Returns the error of reading `text`.
std::string problemOf(const std::string& text) {
  return pipeline::testing::messageOf<InputError>([&] { parseRecord(text, "x/y.mp4", "x"); });
}

TEST(SceneRecord, IsASceneThatSaysWhatMadeIt) {
  const std::string record = smallRecord();
  EXPECT_THAT(record, StartsWith("# Made by rotatebook 1.2.3 from the scene small\n"
                                 "# Renderer: some renderer\n# FFmpeg: 5.1\n# Motion: 0123\n\n"));
  const scene::Scene again = scene::parseScene(record, "small.toml");
  EXPECT_EQ(scene::sceneText(again), scene::sceneText(smallScene()));
}

TEST(SceneRecord, IsReadBack) {
  const ClipRecord record = parseRecord(smallRecord(), "x/y.mp4", "textures");
  EXPECT_EQ(record.provenance.scene, "small");
  EXPECT_EQ(record.provenance.program, "1.2.3");
  EXPECT_EQ(record.provenance.renderer, "some renderer");
  EXPECT_EQ(record.provenance.ffmpeg, "5.1");
  EXPECT_EQ(record.provenance.motion, "0123");
  EXPECT_FALSE(record.part);
  EXPECT_EQ(record.scene.name, "small");
  EXPECT_EQ(record.scene.folder, "textures");
  EXPECT_EQ(scene::sceneText(record.scene), scene::sceneText(smallScene()));
}

TEST(SceneRecord, NamesTheTexturesThatAreNotBuiltIn) {
  const scene::Scene scene = smallScene();
  const Provenance provenance =
      provenanceOf(scene, "", {{"book.front", "abc"}, {"book.spine", "built-in"}}, "r", "5.1");
  const std::string record = sceneRecord(scene, provenance);
  EXPECT_THAT(record, HasSubstr("\n# Textures: book.front abc\n\n"));
  EXPECT_EQ(parseRecord(record, "x", "").provenance.textures, "book.front abc");
}

TEST(SceneRecord, OfFramesAloneNamesNoFfmpegUntilAVideoIsMade) {
  Provenance frames = kProvenance;
  frames.ffmpeg.clear();
  const std::string record = sceneRecord(smallScene(), frames);
  EXPECT_THAT(record, Not(HasSubstr("FFmpeg")));
  EXPECT_EQ(parseRecord(record, "x", "").provenance.ffmpeg, "");
  EXPECT_EQ(recordOfVideo(record, "5.1"), smallRecord());
  EXPECT_EQ(recordOfVideo(smallRecord(), "7"), smallRecord());
  EXPECT_EQ(recordOfVideo("title = 'of somebody else'\n", "7"), "title = 'of somebody else'\n");
}

TEST(SceneRecord, OfAPartNamesItsFrames) {
  const std::string part = recordOfPart(smallRecord(), {3, 5});
  EXPECT_THAT(part, HasSubstr("# Motion: 0123\n# Frames: 3:5\n\n"));
  EXPECT_EQ(parseRecord(part, "x", "").part, (FrameRange{3, 5}));
  EXPECT_EQ(recordOfPart("title = 'of somebody else'\n", {3, 5}), "title = 'of somebody else'\n");
}

TEST(SceneRecord, OfThisVersionHoldsNoOtherWords) {
  Provenance own = kProvenance;
  own.program = kVersion;
  const auto isPlain = [](const std::string& text) {
    return isPlainRecord(parseRecord(text, "x", ""), text);
  };
  const std::string record = sceneRecord(smallScene(), own), part = recordOfPart(record, {3, 5});
  EXPECT_TRUE(isPlain(record));
  EXPECT_TRUE(isPlain(part));
  for (const std::string& text : {record + "\n", record + "# It lasts 8 s\n", part + "#\n",
                                  "# Made by rotatebook " + own.program +
                                      " from the scene small\n# Proved by an institute\n" +
                                      record.substr(record.find('\n') + 1)}) {
    EXPECT_FALSE(isPlain(text)) << text.substr(0, 100);
  }
  EXPECT_TRUE(isPlain(smallRecord() + "# Of another version\n"));
}

TEST(SceneRecord, StaysWholeWithNamesOfSeveralLines) {
  scene::Scene scene = smallScene();
  scene.name = "a\nb = 1";
  const Provenance provenance = provenanceOf(scene, "", {}, "r\n\nmass = 2", "");
  const ClipRecord record = parseRecord(sceneRecord(scene, provenance), "x", "");
  EXPECT_EQ(record.provenance.scene, "a\\nb = 1");
  EXPECT_EQ(record.provenance.renderer, "r\\n\\nmass = 2");
}

// TOML's comments have none.
TEST(SceneRecord, SendsNoControlCharactersToTheTerminal) {
  for (const char* head :
       {"1\x1b[2J from the scene x\n", "1 from the scene \x1b]0;x\x07\n",
        "1 from the scene x\n# Renderer: \r\x1b[1m\n", "1 from the scene x\n# Renderer: \u009b1m\n",
        "1 from the scene a\u202eb\n", "1\u009b2K from the scene x\n",
        "1 from the scene x\n# FFmpeg: \xff\n"}) {
    EXPECT_THAT(problemOf(std::string("# Made by rotatebook ") + head +
                          "\ninitial.angular_velocity = [1, 0, 0]\n"),
                AllOf(StartsWith("the record in x/y.mp4 is damaged: "), Not(HasSubstr("\x1b")),
                      Not(HasSubstr("\u009b")), Not(HasSubstr("\u202e"))));
  }
}

TEST(SceneRecord, OfSomethingElseIsRefused) {
  for (const char* text : {"", "Made with love", "title = 'x'\n", "#Made by rotatebook 1"}) {
    EXPECT_EQ(problemOf(text), "x/y.mp4 isn't a clip of rotatebook: its metadata holds no scene");
  }
}

TEST(SceneRecord, ThatIsDamagedIsRefused) {
  const std::string start = "the record in x/y.mp4 is damaged: ";
  EXPECT_EQ(problemOf("# Made by rotatebook 0.1.0"), start + "it doesn't name its scene");
  EXPECT_EQ(problemOf(smallRecord() + std::string(2'000'000, '#')),
            start + "no scene is that long");
  EXPECT_THAT(problemOf(smallRecord() + "[clip]\n"), StartsWith(start + "x/y.mp4:"));
  EXPECT_THAT(problemOf("# Made by rotatebook 0.1.0 from the scene x\n\nmaas = 1\n"),
              AllOf(StartsWith(start + "x/y.mp4:3:1: "), HasSubstr("maas")));
  EXPECT_THAT(problemOf(smallRecord() + "\"\xff\xfe\" = 1\n"), StartsWith(start));
  EXPECT_THAT(
      problemOf("# Made by rotatebook 0.1.0 from the scene x\n\na = " + std::string(100'000, '[')),
      StartsWith(start));
  const auto withFrames = [](const std::string& frames) {
    return problemOf("# Made by rotatebook 1 from the scene x\n# Frames: " + frames + "\n\n");
  };
  for (const char* frames : {"x", "5:5", "5:3", "-1:3", "3"}) {
    EXPECT_EQ(withFrames(frames), start + "its frames aren't a range") << frames;
  }
}

TEST(SceneRecord, HasANameThatAScenesFileMayHave) {
  const auto withName = [](const std::string& name) {
    return problemOf("# Made by rotatebook 1 from the scene " + name +
                     "\n\ninitial.angular_velocity = [1, 0, 0]\n");
  };
  const std::string start = "the record in x/y.mp4 is damaged: its scene's name \"";
  for (const char* name : {".", "..", ".bashrc", ".v.rotatebook-1"}) {
    EXPECT_EQ(withName(name), start + name + "\" begins with a dot, as names of hidden files do");
  }
  for (const char* name : {"/", "a/b", "/etc/passwd", "a/"}) {
    EXPECT_EQ(withName(name), start + name + "\" holds a slash, as paths do");
  }
  EXPECT_EQ(withName(""), start + "\" is empty");
  EXPECT_EQ(withName("v.partial"),
            start + "v.partial\" ends in .partial, as what a running render writes does");
  EXPECT_EQ(withName("v.replaced"),
            start + "v.replaced\" ends in .replaced, as what a running render writes does");
  EXPECT_THAT(withName(std::string(201, 'a')), HasSubstr("\" has 201 bytes; the limit is 200"));
  EXPECT_EQ(withName(std::string(200, 'a')), "no error");
}

TEST(SceneRecord, OfARenderIsTrue) {
  const fs::path folder = emptyFolder();
  pipeline::testing::render(smallScene(), pipeline::testing::pngAndMp4(folder));
  const RecordedClip clip = readRecordedClip(folder / "small.mp4", {});
  EXPECT_EQ(clip.format, video::VideoFormat::Mp4);
  EXPECT_EQ(clip.record.scene.folder, folder);
  const Provenance& provenance = clip.record.provenance;
  EXPECT_EQ(provenance.program, kVersion);
  EXPECT_EQ(provenance.renderer, picture::makeRenderer(smallScene()).description());
  EXPECT_EQ(provenance.ffmpeg, video::ffmpegVersion());
  EXPECT_EQ(provenance.motion, timeline::motionChecksum(timeline::simulateScene(smallScene())));
}

TEST(SceneRecord, NamesTheOptionWhereATextureIsMissing) {
  const fs::path folder = emptyFolder();
  scene::Scene scene = smallScene({"book.front=cover.png"});
  const fs::path clip = folder / "small.mp4";
  const std::string record = sceneRecord(scene, kProvenance);
  {
    video::VideoWriter writer(video::VideoFormat::Mp4, clip, videoSettings(scene, record));
    writer.write(image::Image(64, 36, image::PixelFormat::Rgba8).view());
    writer.finish();
  }
  EXPECT_MESSAGE(
      pipeline::testing::messageOf<InputError>([&] { readRecordedClip(clip, {"other"}); }));
}

TEST(SceneRecord, NamesTheOptionOnlyWhereATextureIsMissing) {
  const fs::path folder = emptyFolder();
  const scene::Scene scene = smallScene({"book.front=../cover.png"});
  fs::create_directories(folder / "clips");
  const fs::path clip = folder / "clips/small.mp4";
  {
    video::VideoWriter writer(video::VideoFormat::Mp4, clip,
                              videoSettings(scene, sceneRecord(scene, kProvenance)));
    writer.write(image::Image(64, 36, image::PixelFormat::Rgba8).view());
    writer.finish();
  }
  image::writePng(folder / "cover.png", image::Image(8, 12, image::PixelFormat::Rgb8).view());
  EXPECT_MESSAGE(pipeline::testing::messageOf<InputError>([&] { readRecordedClip(clip, {}); }));
  EXPECT_TRUE(readRecordedClip(clip, {.allowOutside = true}).record.scene.allowOutside);
}

// The clip's folder may hold another file of a texture's name.
TEST(SceneRecord, IsOfTheFilesWithItsChecksums) {
  const fs::path folder = emptyFolder(), out = folder / "out", clip = out / "small.mp4";
  fs::create_directories(out);
  scene::Scene scene = smallScene({"book.front=cover.png"});
  scene.folder = folder;
  image::writePng(folder / "cover.png", image::Image(8, 12, image::PixelFormat::Rgb8).view());
  image::writePng(out / "cover.png", image::Image(9, 12, image::PixelFormat::Rgb8).view());
  Provenance provenance = kProvenance;
  const picture::TextureFiles textures = picture::readTextures(scene);
  provenance.textures = "book.front " + checksumOf(textures.at("book.front"));
  {
    video::VideoWriter writer(video::VideoFormat::Mp4, clip,
                              videoSettings(scene, sceneRecord(scene, provenance)));
    writer.write(image::Image(64, 36, image::PixelFormat::Rgba8).view());
    writer.finish();
  }
  EXPECT_EQ(readRecordedClip(clip, {}).record.scene.folder, out / "..");
  fs::remove(folder / "cover.png");
  EXPECT_EQ(readRecordedClip(clip, {}).record.scene.folder, out);
}

TEST(SceneRecord, IsOfItsSceneAlone) {
  const scene::Scene scene = smallScene();
  EXPECT_TRUE(isRecordOf(scene, smallRecord()));
  EXPECT_TRUE(isRecordOf(scene, recordOfPart(smallRecord(), {3, 5})));
  EXPECT_FALSE(isRecordOf(smallScene({"video.crf=30"}), smallRecord()));
  EXPECT_FALSE(isRecordOf(scene, ""));
  EXPECT_FALSE(isRecordOf(scene, "title = \"Small\"\n"));
}

TEST(SceneRecord, OfAWholeClipMayExpectSomethingElse) {
  EXPECT_TRUE(isRecordOfClip(smallScene(), smallRecord()));
  EXPECT_TRUE(isRecordOfClip(smallScene({"expect.half_turns.max=3"}), smallRecord()));
  EXPECT_FALSE(isRecordOfClip(smallScene(), recordOfPart(smallRecord(), {3, 5})));
  EXPECT_FALSE(isRecordOfClip(smallScene({"video.crf=30"}), smallRecord()));
  EXPECT_FALSE(isRecordOfClip(smallScene(), "title = \"Small\"\n"));
}

TEST(DifferencesOfTools, AreReportedOneByOne) {
  Provenance here = kProvenance;
  EXPECT_THAT(differencesOfTools(kProvenance, here), IsEmpty());
  here.motion = "else";
  EXPECT_THAT(differencesOfTools(kProvenance, here), IsEmpty());
  here.program = "2";
  here.ffmpeg = "7";
  EXPECT_THAT(differencesOfTools(kProvenance, here),
              ElementsAre("rotatebook was 1.2.3, here it is 2", "FFmpeg was 5.1, here it is 7"));
  here = kProvenance;
  here.textures = "book.front b";
  EXPECT_THAT(differencesOfTools(kProvenance, here), IsEmpty());
  Provenance there = kProvenance;
  there.textures = "book.front a";
  EXPECT_THAT(differencesOfTools(there, here),
              ElementsAre("the textures were book.front a, here they are book.front b"));
  EXPECT_THAT(differencesOfTools({}, kProvenance),
              ElementsAre("rotatebook was not recorded, here it is 1.2.3",
                          "the renderer was not recorded, here it is some renderer",
                          "FFmpeg was not recorded, here it is 5.1"));
}

}  // namespace
}  // namespace rotatebook::store
