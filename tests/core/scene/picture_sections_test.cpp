#include <string>

#include <gtest/gtest.h>

#include "base/document/toml_text.h"
#include "scene/names.h"
#include "scene/parse.h"
#include "scene/scene_text.h"

namespace rotatebook::scene {
namespace {

TEST(ClipSection, ReadsEveryKey) {
  const Scene scene = sceneFrom("[clip]\nsize = [640, 362]\nfps = 25\nduration = 1.5");
  EXPECT_EQ(scene.clip.width, 640);
  EXPECT_EQ(scene.clip.height, 362);
  EXPECT_EQ(scene.clip.frameRate, (FrameRate{25, 1}));
  EXPECT_EQ(scene.clip.duration, 1.5);
  EXPECT_EQ(scene.clip.frameCount(), 38);
}

TEST(ClipSection, ReadsTheSpeedOfTheMotion) {
  EXPECT_EQ(sceneFrom("").motions[0].simulation.timePerFrame, 1.0 / 60);
  const Scene slow = sceneFrom("clip.speed = 0.25\nclip.fps = 30");
  EXPECT_EQ(slow.motions[0].simulation.timePerFrame, 1.0 / 120);
  EXPECT_EQ(parseScene(sceneText(slow), "a.toml").motions[0].simulation.timePerFrame, 1.0 / 120);
  EXPECT_EQ(errorOf("[clip]\nspeed = 0"),
            "a.toml:2:9: clip.speed must be a number from 1e-6 to 1e6, not 0; to hold a picture, "
            "write a stretch, such as [{ from = 3, to = 5, value = 0 }]");
  EXPECT_EQ(errorOf("[simulation]\ntime_per_frame = 1\n[clip]\nspeed = 2"),
            "a.toml:2:18: both simulation.time_per_frame and clip.speed say how fast time goes; "
            "keep one of them");
}

TEST(ClipSection, IsOfAllPanels) {
  const Scene scene = parseScene(
      "[initial]\nangular_velocity = [0, 0, 6]\n[clip]\nspeed = 0.5\n[[panel]]\nlabel = 'one'\n"
      "[[panel]]\nlabel = 'two'\n",
      "a.toml");
  EXPECT_EQ(scene.motions[1].simulation.timePerFrame, 1.0 / 120);
  EXPECT_EQ(parseScene(sceneText(scene), "a.toml").motions, scene.motions);
}

TEST(ClipSection, TakesAnyTimeForThePoster) {
  EXPECT_EQ(sceneFrom("clip.poster = 2.5").clip.poster, 2.5);
  EXPECT_EQ(sceneFrom("clip.poster = 99\nclip.duration = 1").clip.poster, 99);
  EXPECT_EQ(sceneFrom("").clip.poster, std::nullopt);
  EXPECT_EQ(errorOf("[clip]\nposter = -1"),
            "a.toml:2:10: clip.poster must be a time in the clip, 0 or more seconds, not -1");
}

TEST(ClipSection, SaysThatThePosterIsAfterAnEndThatIsWrong) {
  const std::string duration = "a.toml:2:12: clip.duration must be a time over 0 s, not 0";
  EXPECT_EQ(errorOf("[clip]\nduration = 0\nposter = 99"),
            duration +
                "\n  a.toml:3:10: clip.poster is at 99 s, after the end of the clip, which is "
                "to last 0 s");
  EXPECT_EQ(errorOf("[clip]\nduration = 0\nposter = -1"),
            duration +
                "\n  a.toml:3:10: clip.poster must be a time in the clip, 0 or more seconds, "
                "not -1");
  EXPECT_EQ(errorOf("[clip]\nduration = 0\nposter = 0"), duration);
  EXPECT_EQ(errorOf("[clip]\nduration = 0\nposter = 'late'").find(duration), 0U);
}

TEST(ClipSection, ReducesRatesToLowestTerms) {
  EXPECT_EQ(sceneFrom("clip.fps = '30000/1001'").clip.frameRate, (FrameRate{30000, 1001}));
  EXPECT_EQ(sceneFrom("clip.fps = '60000/1000'").clip.frameRate, (FrameRate{60, 1}));
  EXPECT_EQ(sceneFrom("clip.fps = '48/2'").clip.frameRate, (FrameRate{24, 1}));
}

TEST(ClipSection, RefusesWhatIsNoRate) {
  const std::string must =
      "a.toml:2:7: clip.fps must be a frame rate from 1 to 1000, an integer or a fraction such "
      "as \"30000/1001\", not ";
  for (const std::string value :
       {"0", "-30", "1001", "4294967356", "29.97", "nan", "true", "\"30000/\"", "\"/2\"",
        "\"30000/1001x\"", "\"30/0\"", "\"-30/-1\"", "\"1/2\"", "\"2001/2\"", "\"2000000/1000001\"",
        "\"99999999999/1\"", "\"ntsc\"", "\"\"", "[30, 1]"}) {
    const std::string guess = value == "29.97" ? "; did you mean \"30000/1001\"?" : "";
    EXPECT_EQ(errorOf("[clip]\nfps = " + value), must + value + guess);
  }
  EXPECT_EQ(errorOf("[clip]\nfps = 23.976"), must + "23.976; did you mean \"24000/1001\"?");
  EXPECT_EQ(errorOf("[clip]\nfps = 60.0"), must + "60.0; did you mean 60?");
  EXPECT_EQ(errorOf("[clip]\nfps = 12.5"), must + "12.5");
  EXPECT_EQ(errorOf("[clip]\nfps = '2000/2'"), "no error");
  EXPECT_EQ(errorOf("[clip]\nfps = '60'"), "no error");
}

TEST(ClipSection, RefusesSizesThatNoVideoHas) {
  const std::string must = "clip.size must be an integer from 16 to 16384, not ";
  EXPECT_EQ(errorOf("[clip]\nsize = [641, 360]"),
            "a.toml:2:9: clip.size must be even, not 641; the nearest even sizes are 640 and 642");
  EXPECT_EQ(errorOf("[clip]\nsize = [640, 361]"),
            "a.toml:2:14: clip.size must be even, not 361; the nearest even sizes are 360 and 362");
  EXPECT_EQ(errorOf("[clip]\nsize = [14, 360]"), "a.toml:2:9: " + must + "14");
  EXPECT_EQ(errorOf("[clip]\nsize = [640, 16386]"), "a.toml:2:14: " + must + "16386");
  EXPECT_EQ(errorOf("[clip]\nsize = [640.0, 360]"), "a.toml:2:9: " + must + "640.0");
  EXPECT_EQ(errorOf("[clip]\nsize = [640]"),
            "a.toml:2:8: clip.size must be a width and a height, such as [1280, 720], not [640]");
  EXPECT_EQ(errorOf("[clip]\nsize = '640x360'"),
            "a.toml:2:8: clip.size must be a width and a height, such as [1280, 720], not "
            "\"640x360\"");
  EXPECT_EQ(errorOf("[clip]\nsize = [16, 16384]"), "no error");
}

TEST(ClipSection, RefusesPicturesThatTakeGigabytes) {
  EXPECT_EQ(errorOf("[clip]\nsize = [8192, 4352]"), "no error");
  EXPECT_EQ(errorOf("[clip]\nsize = [8192, 4354]"),
            "a.toml:2:8: clip.size has 35667968 pixels; the limit is 35651584, for example [8192, "
            "4352]");
}

TEST(ClipSection, RefusesDurationsWithoutAFrameOrWithoutEnd) {
  const std::string positive = "a.toml:2:12: clip.duration must be a time over 0 s, not ";
  EXPECT_EQ(errorOf("[clip]\nduration = 0"), positive + "0");
  EXPECT_EQ(errorOf("[clip]\nduration = -1"), positive + "-1");
  EXPECT_EQ(errorOf("[clip]\nduration = nan"), positive + "nan");
  EXPECT_EQ(errorOf("[clip]\nduration = inf"), positive + "inf");
  const std::string frames =
      "clip.duration must be long enough for 1 frame and short enough for 1000000 at ";
  EXPECT_EQ(errorOf("[clip]\nduration = 0.008"),
            "a.toml:2:12: " + frames + "60 frames a second, not 0.008");
  EXPECT_EQ(errorOf("[clip]\nduration = 1e300\nfps = '30000/1001'"),
            "a.toml:2:12: " + frames + "30000/1001 frames a second, not 1e+300");
  EXPECT_EQ(errorOf("[clip]\nfps = 1\nduration = 1000001"),
            "a.toml:3:12: " + frames + "1 frame a second, not 1000001");
  EXPECT_EQ(sceneFrom("clip.duration = 0.009").clip.frameCount(), 1);
  EXPECT_EQ(sceneFrom("clip.duration = 1000000\nclip.fps = 1").clip.frameCount(), 1'000'000);
}

TEST(VideoSection, ReadsEveryKey) {
  const Scene scene = sceneFrom("[video]\ncrf = 1\npreset = 'placebo'\nthreads = 64");
  EXPECT_EQ(scene.video.crf, 1);
  EXPECT_EQ(scene.video.preset, "placebo");
  EXPECT_EQ(scene.video.threads, 64);
}

TEST(VideoSection, KnowsThePresetsOfX264AndItsOwn) {
  for (const std::string preset : {"book", "ultrafast", "superfast", "veryfast", "faster", "fast",
                                   "medium", "slow", "slower", "veryslow", "placebo"}) {
    EXPECT_EQ(sceneFrom("video.preset = '" + preset + "'").video.preset, preset);
  }
}

TEST(VideoSection, RefusesWhatTheEncoderHasNot) {
  EXPECT_EQ(errorOf("[video]\ncrf = 52"),
            "a.toml:2:7: video.crf must be an integer from 1 to 51, not 52");
  EXPECT_EQ(errorOf("[video]\ncrf = 0"),
            "a.toml:2:7: video.crf must be an integer from 1 to 51, not 0");
  EXPECT_EQ(errorOf("[video]\nthreads = 0"),
            "a.toml:2:11: video.threads must be an integer from 1 to 64, not 0");
  EXPECT_EQ(errorOf("[video]\nthreads = 65"),
            "a.toml:2:11: video.threads must be an integer from 1 to 64, not 65");
  const std::string must =
      "a.toml:2:10: video.preset must be \"book\", \"ultrafast\", \"superfast\", \"veryfast\", "
      "\"faster\", "
      "\"fast\", \"medium\", \"slow\", \"slower\", \"veryslow\" or \"placebo\", not ";
  EXPECT_EQ(errorOf("[video]\npreset = 'veryfats'"),
            must + "\"veryfats\"; did you mean \"veryfast\"?");
  EXPECT_EQ(errorOf("[video]\npreset = 'best'"), must + "\"best\"");
  EXPECT_EQ(errorOf("[video]\nprofile = 'high'"),
            "a.toml:2:1: unknown key \"profile\" in [video]; valid are \"crf\", \"preset\" and "
            "\"threads\"");
}

TEST(CameraSection, ReadsEveryKey) {
  const Scene scene = sceneFrom(
      "[camera]\nposition = [1, 2, 3]\ntarget = [0, 0.5, 0]\nup = [1, 0, 0]\n"
      "field_of_view_deg = 45\nframe = 'momentum'");
  EXPECT_EQ(scene.cameraPosition, Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(scene.camera.target, Eigen::Vector3d(0, 0.5, 0));
  EXPECT_EQ(scene.camera.up, Eigen::Vector3d(1, 0, 0));
  EXPECT_EQ(scene.camera.fieldOfViewDeg, 45);
  EXPECT_EQ(scene.camera.frame, ReferenceFrame::Momentum);
  EXPECT_EQ(sceneFrom("").camera.frame, ReferenceFrame::World);
}

TEST(CameraSection, RefusesAnUnknownFrame) {
  EXPECT_EQ(errorOf("[camera]\nframe = 'boddy'"),
            "a.toml:2:9: camera.frame must be \"world\", \"body\", \"momentum\" or \"turning\", "
            "not \"boddy\"; did "
            "you mean \"body\"?");
}

TEST(CameraSection, RefusesNumbersOutOfRange) {
  EXPECT_EQ(errorOf("[camera]\nposition = [1, 2, nan]"),
            "a.toml:2:19: camera.position must be three numbers from -1e9 to 1e9, not nan");
  EXPECT_EQ(errorOf("[camera]\ntarget = [1, 2]"),
            "a.toml:2:10: camera.target must be three numbers from -1e9 to 1e9, not [1, 2]");
  EXPECT_EQ(errorOf("[camera]\nup = [0, 0, 0]"),
            "a.toml:2:6: camera.up must be three numbers from -1e9 to 1e9, at least one other than "
            "0, not "
            "[0, 0, 0]");
  for (const std::string angle : {"0", "0.9", "171", "-30", "nan", "inf", "\"wide\""}) {
    EXPECT_EQ(errorOf("[camera]\nfield_of_view_deg = " + angle),
              "a.toml:2:21: camera.field_of_view_deg must be an angle from 1 to 170 degrees, not " +
                  angle);
  }
}

TEST(CameraSection, RefusesToLookNowhere) {
  const std::string must = ": camera.position and camera.target must be different points";
  EXPECT_EQ(errorOf("[camera]\nposition = [0, 0, 0]"), "a.toml:2:12" + must);
  EXPECT_EQ(errorOf("[camera]\ntarget = [1, 2, 3]\nposition = [1, 2, 3]"), "a.toml:3:12" + must);
  // The default position, as the file's target.
  const Eigen::Vector3d p = sceneFrom("").cameraPosition;
  const std::string target = "[" + document::tomlNumber(p.x()) + ", " +
                             document::tomlNumber(p.y()) + ", " + document::tomlNumber(p.z()) + "]";
  EXPECT_EQ(errorOf("[camera]\ntarget = " + target), "a.toml:2:10" + must);
}

TEST(CameraSection, RefusesAnUpAlongTheView) {
  const std::string must =
      ": camera.up must not be parallel to the direction from camera.position to camera.target";
  EXPECT_EQ(errorOf("[camera]\nup = [0, 0, 4]\nposition = [0, 0, 3]"), "a.toml:2:6" + must);
  EXPECT_EQ(errorOf("[camera]\nup = [0, 0, -1e-20]\nposition = [0, 0, 3]"), "a.toml:2:6" + must);
  EXPECT_EQ(errorOf("[camera]\nposition = [0, 3, 0]"), "a.toml:2:12" + must);
  EXPECT_EQ(errorOf("[camera]\nposition = [0, 3, 0]\nup = [0, 0, -1]"), "no error");
  // Up needn't be square to the view.
  EXPECT_EQ(errorOf("[camera]\nposition = [0, 3, 0.01]"), "no error");
}

TEST(BookSection, ReadsEveryTexture) {
  const Scene scene = sceneFrom("[book]\nfront = 'f.png'\nspine = '../s.png'\nback = 'builtin'");
  EXPECT_EQ(scene.book.front, "f.png");
  EXPECT_EQ(scene.book.spine, "../s.png");
  EXPECT_EQ(scene.book.back, kBuiltin);
}

TEST(BookSection, MayHaveAColour) {
  EXPECT_FALSE(sceneFrom("").book.colour);
  EXPECT_EQ(sceneFrom("book.color = '#2b5d8a'").book.colour, (Rgb{0x2b, 0x5d, 0x8a}));
  EXPECT_EQ(errorOf("book.color = 'blue'"),
            "a.toml:1:14: book.color must be \"white\", \"black\" or a colour such as \"#2b5d8a\", "
            "not \"blue\"");
  EXPECT_EQ(errorOf("book.color = 0x2b5d8a"),
            "a.toml:1:14: book.color must be \"white\", \"black\" or a colour such as \"#2b5d8a\", "
            "not 2841994");
}

TEST(BookSection, RefusesPathsThatOnlyOneMachineHas) {
  const std::string must = " must be \"builtin\" or a path relative to the scene's folder, not ";
  EXPECT_EQ(errorOf("[book]\nfront = '/tmp/a.png'"),
            "a.toml:2:9: book.front" + must + "\"/tmp/a.png\"");
  EXPECT_EQ(errorOf("[book]\nspine = ''"), "a.toml:2:9: book.spine" + must + "\"\"");
  EXPECT_EQ(errorOf("[book]\nback = 3"), "a.toml:2:8: book.back must be a string in quotes, not 3");
}

TEST(OverlaySection, ReadsWhatIsShown) {
  EXPECT_TRUE(sceneFrom("").overlay.show.empty());
  EXPECT_EQ(sceneFrom("").overlay.font, "builtin");
  const Scene scene = sceneFrom("[overlay]\nshow = ['clock', 'caption']\nfont = 'Lato'");
  EXPECT_EQ(scene.overlay.show, (std::vector{Overlay::Clock, Overlay::Caption}));
  EXPECT_EQ(scene.overlay.font, "Lato");
  EXPECT_TRUE(sceneFrom("overlay.show = []").overlay.show.empty());
}

TEST(OverlaySection, KeepsTheWordsOfTheOverlays) {
  // Written out, as scenes have them: renamed, they would no longer be read.
  const Scene scene = sceneFrom(
      "simulation.model = 'particles'\n[overlay]\nshow = ['caption', 'clock', 'axes', 'omega', "
      "'momentum', 'trail', 'polhode', 'energy', 'error', 'half_turns', 'springs', 'ghost', "
      "'energy_ladder']");
  EXPECT_TRUE(shows(sceneFrom("overlay.show = ['poinsot']"), Overlay::Poinsot));
  EXPECT_TRUE(shows(scene, Overlay::Ghost));
  EXPECT_FALSE(shows(sceneFrom(""), Overlay::Caption));
}

TEST(OverlaySection, RefusesUnknownAndRepeatedOnes) {
  EXPECT_EQ(errorOf("[overlay]\nshow = ['caption', 'clok']"),
            "a.toml:2:20: overlay.show must be " + listOfOverlays("or") +
                ", not \"clok\"; did you mean \"clock\"?");
  EXPECT_EQ(errorOf("[overlay]\nshow = ['clock', 'clock']"),
            "a.toml:2:18: overlay.show has clock twice");
  EXPECT_EQ(
      errorOf("[overlay]\nshow = 'clock'"),
      "a.toml:2:8: overlay.show must be a list of overlays, such as [\"caption\", \"clock\"], "
      "not \"clock\"");
}

TEST(OverlaySection, RefusesWhatTheModelHasNot) {
  const std::string springs =
      "overlay.show: springs exist only in the particles model; this scene's is ";
  EXPECT_EQ(errorOf("[overlay]\nshow = ['clock', 'springs']"),
            "a.toml:2:18: " + springs + "quaternion");
  EXPECT_EQ(errorOf("overlay.show = ['springs']\nsimulation.model = 'exact'"),
            "a.toml:1:17: " + springs + "exact");
  EXPECT_EQ(errorOf("overlay.show = ['springs']\nsimulation.model = 'particles'"), "no error");
  for (const std::string name : {"error", "ghost"}) {
    EXPECT_EQ(
        errorOf("overlay.show = ['" + name + "']\nsimulation.model = 'exact'"),
        "a.toml:1:17: overlay.show: " + name +
            " shows how far a motion is from the exact one, and this scene's is the exact one");
    EXPECT_EQ(errorOf("overlay.show = ['" + name + "']"), "no error");
  }
  EXPECT_EQ(errorOf("overlay.show = ['poinsot']\nsimulation.model = 'particles'"),
            "a.toml:1:17: overlay.show: poinsot is for rigid bodies; set simulation.model to "
            "\"exact\", \"quaternion\" or \"matrix\"");
  EXPECT_EQ(errorOf("overlay.show = ['poinsot']"), "no error");
}

}  // namespace
}  // namespace rotatebook::scene
