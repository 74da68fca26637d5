// `rotatebook render`: what it leaves on the disk, what it says, and its exit status.
#include <filesystem>
#include <string>
#include <vector>

#include "cli/program_test.h"
#include "image/png_file.h"
#include "messages.h"
#include "video/decoded_video.h"

namespace rotatebook::cli::testing {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::MatchesRegex;
using ::testing::StartsWith;

using RenderCommand = ProgramTest;

constexpr std::size_t kTinyFrames = 12;

// A motion that cannot be: kTiny turns by one radian.
const std::vector<std::string> kUnmet{"--set", "expect.half_turns={min = 3}"};

std::vector<std::string> operator+(std::vector<std::string> words,
                                   const std::vector<std::string>& more) {
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

TEST_F(RenderCommand, WritesFramesClipAndTableIntoOut) {
  const ChildResult result = run({"render", "tiny.toml"});
  EXPECT_EQ(result.status, 0) << result.error;
  EXPECT_THAT(files(), ElementsAre("out/", "out/tiny.csv", "out/tiny.json", "out/tiny.mp4",
                                   "out/tiny.poster.png", "out/tiny/", "out/tiny/frame_00000.png",
                                   "out/tiny/frame_00001.png", "out/tiny/frame_00002.png",
                                   "out/tiny/frame_00003.png", "out/tiny/frame_00004.png",
                                   "out/tiny/frame_00005.png", "out/tiny/frame_00006.png",
                                   "out/tiny/frame_00007.png", "out/tiny/frame_00008.png",
                                   "out/tiny/frame_00009.png", "out/tiny/frame_00010.png",
                                   "out/tiny/frame_00011.png", "out/tiny/frames.manifest",
                                   "out/tiny/frames.xxh128", "out/tiny/scene.toml"));
  EXPECT_EQ(countOf("\n", read("out/tiny.csv")), 1 + static_cast<int>(kTinyFrames));
  EXPECT_EQ(video::testing::decodeVideo(folder() / "out/tiny.mp4").frames.size(), kTinyFrames);
  const image::Image picture = image::readPng(folder() / "out/tiny/frame_00011.png");
  EXPECT_EQ(picture.width(), 64);
  EXPECT_EQ(picture.height(), 36);
}

// Expectations are of the whole: the join reports them.
TEST_F(RenderCommand, OfAPartLeavesFramesAloneAndExpectsNothing) {
  const ChildResult part =
      run(std::vector<std::string>{"render", "tiny.toml", "--part", "2/3"} + kUnmet);
  EXPECT_EQ(part.status, 0) << part.error;
  EXPECT_THAT(part.output,
              AllOf(EndsWith("\n  wrote 4 frames in out/tiny/\n"), Not(HasSubstr(" flips"))));
  EXPECT_FALSE(has("out/tiny.csv") || has("out/tiny.poster.png"));
  EXPECT_TRUE(has("out/tiny/frame_00004.png") && has("out/tiny/frame_00007.png"));
  EXPECT_FALSE(has("out/tiny/frame_00003.png") || has("out/tiny/frame_00008.png"));
  const ChildResult empty =
      run(std::vector<std::string>{"render", "tiny.toml", "--part", "1/13"} + kUnmet);
  EXPECT_EQ(empty.status, 0) << empty.error;
  EXPECT_EQ(empty.output, "tiny: this part has no frames; nothing was written\n");
  const ChildResult json =
      run(std::vector<std::string>{"render", "tiny.toml", "--part", "1/13", "--json"} + kUnmet);
  EXPECT_THAT(json.output,
              HasSubstr(R"("frames_written":0,"frames_kept":0,"files":[],"frame_folder":null)"));
  const ChildResult join =
      run(std::vector<std::string>{"render", "tiny.toml", "--resume"} + kUnmet);
  EXPECT_EQ(join.status, 1);
  EXPECT_THAT(join.output, HasSubstr("kept 4 frames of an earlier run"));
}

TEST_F(RenderCommand, OfAPartTakesNothingThatIsOfTheWhole) {
  const auto problem = [&](const std::vector<std::string>& options) {
    const ChildResult result = run(std::vector<std::string>{"render", "tiny.toml"} + options);
    EXPECT_EQ(result.status, 2);
    return result.error;
  };
  for (const char* part : {"0/3", "4/3", "2", "a/b"}) {
    EXPECT_MESSAGE(problem({"--part", part}));
  }
  EXPECT_MESSAGE(problem({"--part", "1/3", "--frames", "0:3"}));
  EXPECT_MESSAGE(problem({"--part", "1/3", "--no-png"}));
  EXPECT_MESSAGE(problem({"--part", "1/3", "--format", "gif"}));
  EXPECT_FALSE(has("out"));
}

TEST_F(RenderCommand, OfPartsOfSeveralScenesDrawsOneOfEach) {
  write("b.toml", std::string(kTiny) + "fps = 30\n");
  const ChildResult part = run({"render", "tiny.toml", "b.toml", "--part", "2/2", "-j2"});
  EXPECT_EQ(part.status, 0) << part.error;
  EXPECT_TRUE(has("out/tiny/frame_00006.png") && has("out/b/frame_00003.png"));
  EXPECT_FALSE(has("out/tiny/frame_00005.png") || has("out/b/frame_00002.png"));
}

TEST_F(RenderCommand, SaysWhatItDrawsWithAndWhatItWrote) {
  const ChildResult result = run({"render", "tiny.toml", "-v"});
  EXPECT_THAT(
      withoutDistances(result.output),
      AllOf(StartsWith("tiny: Tiny\n  64x36 at 60 frames/s, 0.2 s; renderer "),
            HasSubstr("; encoder libx264\n  threads: 1 draws (a software rasteriser has its own), "
                      "1 composes, "),
            HasSubstr(" PNGs, 1 encodes; cores: "),
            EndsWith("  wrote out/tiny.mp4, out/tiny.csv, out/tiny.json, out/tiny.poster.png and "
                     "12 frames in "
                     "out/tiny/\n")));
}

TEST_F(RenderCommand, LeavesTheFramesOut) {
  const ChildResult result = run({"render", "tiny.toml", "--no-png"});
  EXPECT_EQ(result.status, 0) << result.error;
  EXPECT_THAT(files(), ElementsAre("out/", "out/tiny.csv", "out/tiny.json", "out/tiny.mp4",
                                   "out/tiny.poster.png", "out/tiny/", "out/tiny/frames.manifest",
                                   "out/tiny/scene.toml"));
  EXPECT_THAT(
      withoutDistances(result.output),
      EndsWith("  wrote out/tiny.mp4, out/tiny.csv, out/tiny.json and out/tiny.poster.png\n"));
}

TEST_F(RenderCommand, SaysHowFarTheMotionWasFromTheExactOne) {
  EXPECT_THAT(run({"render", "tiny.toml", "--no-png"}).output,
              HasSubstr(" degrees of the exact motion\n"));
}

TEST_F(RenderCommand, SaysWhatItKeptOfOtherSettings) {
  run({"render", "tiny.toml"});
  const ChildResult result =
      run({"render", "tiny.toml", "--format", "gif", "--no-png", "--set", "body.mass=2"});
  EXPECT_MESSAGE(result.error);
  EXPECT_TRUE(has("out/tiny.mp4"));
  EXPECT_TRUE(has("out/tiny/frame_00011.png"));
}

TEST_F(RenderCommand, MakesTheVideosThatAreAskedFor) {
  const ChildResult result =
      run({"render", "tiny.toml", "--no-png", "--verbose", "--format", "webm,gif,apng"});
  EXPECT_EQ(result.status, 0) << result.error;
  EXPECT_THAT(files(), ElementsAre("out/", "out/tiny.apng", "out/tiny.csv", "out/tiny.gif",
                                   "out/tiny.json", "out/tiny.poster.png", "out/tiny.webm",
                                   "out/tiny/", "out/tiny/frames.manifest", "out/tiny/scene.toml"));
  EXPECT_THAT(result.output,
              AllOf(HasSubstr("; encoder libvpx-vp9, gif, apng\n  threads: "),
                    HasSubstr("  wrote out/tiny.webm, out/tiny.gif, out/tiny.apng, "
                              "out/tiny.csv, out/tiny.json and out/tiny.poster.png\n")));
}

TEST_F(RenderCommand, RefusesAFormatThatThereIsNot) {
  const ChildResult result = run({"render", "tiny.toml", "--format", "mp4,wemb"});
  EXPECT_EQ(result.status, 2);
  EXPECT_EQ(result.error,
            "rotatebook: --format wemb: unknown; there are \"mp4\", \"webm\", \"gif\", \"apng\", "
            "\"prores\", "
            "\"hevc\" and \"av1\"; "
            "did you mean \"webm\"?\n");
  EXPECT_THAT(files(), IsEmpty());
}

TEST_F(RenderCommand, RefusesVideosThatLoseATransparentBackground) {
  const std::vector<std::string> render{"render", "tiny.toml", "--set",
                                        "look.background=transparent"};
  const ChildResult refused = run(render);
  EXPECT_EQ(refused.status, 2);
  EXPECT_EQ(refused.error,
            "rotatebook: tiny: mp4 can't hold the transparent background of look.background; use "
            "webm, apng or prores as --format, or --no-mp4 for PNGs alone\n");
  EXPECT_THAT(files(), IsEmpty());
  EXPECT_EQ(run(render + std::vector<std::string>{"--no-png", "--format", "webm"}).status, 0);
}

TEST_F(RenderCommand, LeavesTheClipOut) {
  const ChildResult result = run({"render", "tiny.toml", "--no-mp4", "--frames", "0:1"});
  EXPECT_EQ(result.status, 0) << result.error;
  EXPECT_THAT(files(), ElementsAre("out/", "out/tiny.csv", "out/tiny.json", "out/tiny/",
                                   "out/tiny/frame_00000.png", "out/tiny/frames.manifest",
                                   "out/tiny/frames.xxh128", "out/tiny/scene.toml"));
  EXPECT_THAT(withoutDistances(result.output),
              EndsWith("  wrote out/tiny.csv, out/tiny.json and 1 frame in out/tiny/\n"));
}

TEST_F(RenderCommand, DrawsARangeThatIsTheSameAsInTheWholeClip) {
  EXPECT_EQ(run({"render", "tiny.toml", "--no-mp4", "-o", "whole"}).status, 0);
  const ChildResult result = run({"render", "tiny.toml", "--frames", "2:5", "-o", "part"});
  EXPECT_EQ(result.status, 0) << result.error;
  std::vector<std::string> parts;
  for (const std::string& name : files()) {
    if (name.starts_with("part/")) parts.push_back(name);
  }
  EXPECT_THAT(parts, ElementsAre("part/", "part/tiny.csv", "part/tiny.json", "part/tiny/",
                                 "part/tiny/frame_00002.png", "part/tiny/frame_00003.png",
                                 "part/tiny/frame_00004.png", "part/tiny/frames.manifest",
                                 "part/tiny/frames.xxh128", "part/tiny/scene.toml",
                                 "part/tiny_00002-00005.mp4"));
  EXPECT_EQ(read("part/tiny/frame_00002.png"), read("whole/tiny/frame_00002.png"));
  EXPECT_NE(read("part/tiny/frame_00002.png"), read("whole/tiny/frame_00003.png"));
  EXPECT_EQ(video::testing::decodeVideo(folder() / "part/tiny_00002-00005.mp4").frames.size(), 3U);
}

TEST_F(RenderCommand, TakesSizeFolderAndOverrides) {
  const ChildResult result = run({"render", "tiny.toml", "-o", "a/b", "--size", "96x54", "--set",
                                  "clip.duration=0.1", "--set", "title=Other", "--no-png"});
  EXPECT_EQ(result.status, 0) << result.error;
  EXPECT_THAT(result.output, StartsWith("tiny: Other\n  96x54 at 60 frames/s, 0.1 s\n"));
  const video::testing::DecodedVideo clip = video::testing::decodeVideo(folder() / "a/b/tiny.mp4");
  EXPECT_EQ(clip.width, 96);
  EXPECT_EQ(clip.height, 54);
  EXPECT_EQ(clip.frames.size(), 6U);
  EXPECT_EQ(clip.metadata.at("title"), "Other");
}

TEST_F(RenderCommand, MakesTheVideosThatAreNamed) {
  const ChildResult result = run({"render", "tiny.toml", "-o", "clips/a.mp4", "-o", "clips/a.gif"});
  EXPECT_EQ(result.status, 0) << result.error;
  EXPECT_THAT(files(), ElementsAre("clips/", "clips/a.csv", "clips/a.gif", "clips/a.json",
                                   "clips/a.mp4", "clips/a.poster.png", "clips/a/",
                                   "clips/a/frames.manifest", "clips/a/scene.toml"));
  EXPECT_EQ(run({"render", "tiny.toml", "-o", "b.webm"}).status, 0);
  EXPECT_TRUE(has("b.webm") && has("b.csv"));
}

TEST_F(RenderCommand, TakesANameWithADotForAFolderThatIsThereOrEndsInASlash) {
  std::filesystem::create_directory(folder() / "takes.2");
  EXPECT_EQ(run({"render", "tiny.toml", "--no-png", "-o", "takes.2"}).status, 0);
  EXPECT_EQ(run({"render", "tiny.toml", "--no-png", "-o", "takes.3/"}).status, 0);
  EXPECT_TRUE(has("takes.2/tiny.mp4") && has("takes.3/tiny.mp4"));
}

TEST_F(RenderCommand, MakesVideosForEditorsAndReplacesItsOwnAlone) {
  const std::vector<std::string> words{"render", "tiny.toml", "-o", "a.hevc.mp4", "-o", "a.mov"};
  const ChildResult made = run(words);
  EXPECT_EQ(made.status, 0) << made.error;
  EXPECT_TRUE(has("a.hevc.mp4") && has("a.mov") && has("a.poster.png"));
  EXPECT_FALSE(has("a.mp4") || has("a.hevc.poster.png"));
  EXPECT_EQ(run(words).status, 0);
  write("a.mov", "an editor's own");
  std::filesystem::remove_all(folder() / "a");
  EXPECT_MESSAGE(run(words).error);
}

TEST_F(RenderCommand, RefusesVideosThatItCanNotMake) {
  write("b.toml", kTiny);
  const auto refusal = [this](const std::vector<std::string>& words) {
    std::vector<std::string> all{"render", "tiny.toml"};
    all.insert(all.end(), words.begin(), words.end());
    const ChildResult result = run(all);
    EXPECT_EQ(result.status, 2);
    return result.error;
  };
  EXPECT_EQ(
      refusal({"-o", "a.mkv"}),
      "rotatebook: a.mkv: no video ends in \".mkv\"; there are \".mp4\", \".webm\", "
      "\".gif\", \".apng\", \".mov\", \".hevc.mp4\" and \".av1.mp4\"; for a folder of this name, "
      "write a.mkv/; did you mean \".mov\"?\n");
  EXPECT_MESSAGE(refusal({"-o", "a.mp5"}));
  EXPECT_EQ(refusal({"-o", "A.B.MP4"}),
            "rotatebook: A.B.MP4: videos end in small letters; write A.B.mp4\n");
  EXPECT_EQ(refusal({"b.toml", "-o", "a.mp4"}),
            "rotatebook: --output a.mp4: one video for 2 scenes; name a folder\n");
  EXPECT_EQ(refusal({"-o", "a.mp4", "-o", "b.gif"}),
            "rotatebook: --output a.mp4 and --output b.gif: the videos of a render have one name, "
            "but for the ending\n");
  for (const auto& both : {std::vector<std::string>{"-o", "d/", "-o", "y.mp4"},
                           std::vector<std::string>{"-o", "y.mp4", "-o", "d/"}}) {
    EXPECT_EQ(refusal(both),
              "rotatebook: --output d/ and --output y.mp4: a render fills a folder, or makes the "
              "videos that are named; name the folder alone, with --format, or the videos alone\n");
  }
  EXPECT_MESSAGE(refusal({"-o", "a.mp4", "--frames", "0:2"}));
  EXPECT_THAT(files(), ElementsAre("b.toml"));
}

TEST_F(RenderCommand, LeavesExpectationsOut) {
  const ChildResult result =
      run({"render", "tiny.toml", "--no-png", "--no-expect", "--set", "expect.half_turns.min=1"});
  EXPECT_EQ(result.status, 0) << result.error;
  EXPECT_THAT(result.output, HasSubstr("expectations are left out (--no-expect)"));
  EXPECT_THAT(read("out/tiny/scene.toml"), HasSubstr("half_turns = { min = 1"));
}

TEST_F(RenderCommand, RendersSeveralScenes) {
  write("b.toml", kTiny);
  const ChildResult result = run({"render", "tiny.toml", "b.toml", "--no-png"});
  EXPECT_EQ(result.status, 0) << result.error;
  EXPECT_THAT(files(),
              ElementsAre("b.toml", "out/", "out/b.csv", "out/b.json", "out/b.mp4",
                          "out/b.poster.png", "out/b/", "out/b/frames.manifest", "out/b/scene.toml",
                          "out/tiny.csv", "out/tiny.json", "out/tiny.mp4", "out/tiny.poster.png",
                          "out/tiny/", "out/tiny/frames.manifest", "out/tiny/scene.toml"));
}

TEST_F(RenderCommand, RefusesTwoScenesOfOneName) {
  write("more/tiny.toml", kTiny);
  const ChildResult result = run({"render", "tiny.toml", "more/tiny.toml"});
  EXPECT_EQ(result.status, 2);
  EXPECT_EQ(result.error,
            "rotatebook: two scenes are named tiny; they would overwrite each other: render them "
            "into different folders\n");
  EXPECT_THAT(files(), ElementsAre("more/", "more/tiny.toml"));
}

TEST_F(RenderCommand, RefusesNamesThatItsOwnFilesHave) {
  const std::string longest(201, 'a');
  for (const auto& [name, words] :
       {std::pair<std::string, std::string>{"x.partial", "name \"x.partial\" ends in .partial, "},
        {"x.replaced", "name \"x.replaced\" ends in .replaced, "},
        {longest, "has 201 bytes; the limit is 200; rename the file"}}) {
    write(name + ".toml", kTiny);
    const ChildResult result = run({"render", name + ".toml"});
    EXPECT_EQ(result.status, 2);
    EXPECT_MESSAGE(result.error);
    EXPECT_FALSE(has("out/"));
  }
}

TEST_F(RenderCommand, WritesNothingIfTheLastSceneIsWrong) {
  write("wrong.toml", "titel = 'T'\n");
  const ChildResult result = run({"render", "tiny.toml", "wrong.toml"});
  EXPECT_EQ(result.status, 2);
  EXPECT_THAT(files(), ElementsAre("wrong.toml"));
}

TEST_F(RenderCommand, RefusesToMixFramesOfOtherSettings) {
  EXPECT_EQ(run({"render", "tiny.toml", "--no-mp4", "--frames", "0:1"}).status, 0);
  const auto other = [&](const std::string& mass) {
    return run(
        {"render", "tiny.toml", "--no-mp4", "--frames", "1:2", "--set", "body.mass=" + mass});
  };
  const ChildResult result = other("2");
  EXPECT_EQ(result.status, 2);
  EXPECT_EQ(
      result.error,
      "rotatebook: out/tiny holds frames with other settings: body.mass is 1.0 there, 2.0 here; "
      "render into another folder with -o, or remove it\n");
  EXPECT_FALSE(has("out/tiny/frame_00001.png"));
  EXPECT_EQ(other("1").status, 0);
  EXPECT_TRUE(has("out/tiny/frame_00000.png"));
}

TEST_F(RenderCommand, KeepsTheFilesOfAnUnmetExpectation) {
  const ChildResult result = run(std::vector<std::string>{"render", "tiny.toml"} + kUnmet);
  EXPECT_EQ(result.status, 1);
  EXPECT_THAT(result.output,
              HasSubstr("\n  not met  half_turns: expected at least 3; measured 0\n"));
  EXPECT_EQ(result.error, "rotatebook: expectations are not met; the files were kept\n");
  EXPECT_THAT(files(), AllOf(Contains("out/tiny.mp4"), Contains("out/tiny.csv"),
                             Contains("out/tiny/frame_00011.png")));
}

TEST_F(RenderCommand, SaysThatAnExpectationIsMet) {
  const ChildResult result =
      run({"render", "tiny.toml", "--no-png", "--set", "expect.half_turns={max = 0}"});
  EXPECT_EQ(result.status, 0);
  EXPECT_THAT(result.output, EndsWith("\n  met      half_turns: expected at most 0; measured 0\n"));
  EXPECT_THAT(result.error, IsEmpty());
}

TEST_F(RenderCommand, OneUnmetSceneOfSeveralIsEnough) {
  write("first.toml", std::string(kTiny) + "[expect]\nhalf_turns = { min = 3 }\n");
  const ChildResult result = run({"render", "first.toml", "tiny.toml", "--no-png"});
  EXPECT_EQ(result.status, 1);
  EXPECT_TRUE(has("out/tiny.mp4"));
}

TEST_F(RenderCommand, HoldsTheLastPictureWhenTheMotionDiverges) {
  // Undamped springs with such steps don't hold for a second.
  const ChildResult result =
      run({"render", "tiny.toml", "--no-png", "--set", "clip.duration=2", "--set",
           "simulation.model=particles", "--set", "simulation.substeps=1", "--set",
           "simulation.damping=0", "--set", "simulation.normalize=false"});
  EXPECT_EQ(result.status, 0) << result.error;
  EXPECT_THAT(result.output,
              MatchesRegex("(.|\n)*  the motion diverges at [0-9.e-]+ s, after [0-9]+ frames\n"));
  const auto frames = video::testing::decodeVideo(folder() / "out/tiny.mp4").frames.size();
  EXPECT_THAT(result.output, EndsWith("after " + std::to_string(frames - 60) + " frames\n"));
  EXPECT_LT(frames, 120U);
}

}  // namespace
}  // namespace rotatebook::cli::testing
