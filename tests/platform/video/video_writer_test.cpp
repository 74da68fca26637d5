#include "video/video_writer.h"

#include <csignal>
#include <cstdint>
#include <filesystem>
#include <random>
#include <string>
#include <sys/resource.h>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "messages.h"
#include "video/decoded_video.h"
#include "video/test_clip.h"

namespace rotatebook::video {
namespace {

namespace fs = std::filesystem;
using testing::barPicture;
using testing::contentOf;
using testing::decodeVideo;
using ::testing::HasSubstr;
using testing::outputFolder;
using testing::smallSettings;
using testing::writeClip;

// Calls `action`, which must throw a Failure, and returns its message.
template <typename Failure, typename Action>
std::string messageOf(Action action) {
  try {
    action();
    return "";
  } catch (const Failure& error) {
    return error.what();
  }
}

std::string refusalOf(const VideoSettings& settings) {
  return messageOf<InputError>(
      [&] { VideoWriter(VideoFormat::Mp4, outputFolder() / "refused.mp4", settings); });
}

TEST(Mp4Writer, RefusesOddSizesNamingTheEvenOnes) {
  VideoSettings settings = smallSettings();
  settings.width = 1279;
  EXPECT_EQ(refusalOf(settings),
            "video width 1279 is odd, and H.264's 4:2:0 colour needs it even: take 1278 or 1280");
  settings = smallSettings();
  settings.height = 721;
  EXPECT_EQ(refusalOf(settings),
            "video height 721 is odd, and H.264's 4:2:0 colour needs it even: take 720 or 722");
}

TEST(Mp4Writer, RefusesSizesBelowTheSmallest) {
  VideoSettings settings = smallSettings();
  settings.width = 14;
  EXPECT_EQ(refusalOf(settings), "video width 14: the smallest is 16");
  settings.width = -2;
  EXPECT_EQ(refusalOf(settings), "video width -2: the smallest is 16");
  settings.width = 16;
  settings.height = 16;
  EXPECT_EQ(refusalOf(settings), "");
}

TEST(Mp4Writer, RefusesAnUnknownPresetNamingTheKnownOnes) {
  VideoSettings settings = smallSettings();
  settings.preset = "quick";
  EXPECT_EQ(refusalOf(settings),
            "unknown video preset \"quick\"; valid are book, ultrafast, superfast, veryfast, "
            "faster, fast, "
            "medium, slow, slower, veryslow, placebo");
}

TEST(Mp4Writer, TakesEveryPresetItNames) {
  for (const char* preset : {"book", "ultrafast", "superfast", "veryfast", "faster", "fast",
                             "medium", "slow", "slower", "veryslow", "placebo"}) {
    VideoSettings settings = smallSettings();
    settings.preset = preset;
    EXPECT_EQ(refusalOf(settings), "") << preset;
  }
}

TEST(Mp4Writer, RefusesNumbersOutOfRange) {
  VideoSettings settings = smallSettings();
  settings.crf = 0;
  EXPECT_EQ(refusalOf(settings), "video crf 0 is outside 1 to 51");
  settings.crf = 52;
  EXPECT_EQ(refusalOf(settings), "video crf 52 is outside 1 to 51");
  settings = smallSettings();
  settings.threads = 0;
  EXPECT_EQ(refusalOf(settings), "video threads 0: at least 1");
  settings = smallSettings();
  settings.frameRate = {0, 1};
  EXPECT_EQ(refusalOf(settings), "video frame rate 0 isn't above 0");
}

TEST(Mp4Writer, CreatesNoFileForRefusedSettings) {
  const fs::path path = outputFolder() / "never.mp4";
  VideoSettings settings = smallSettings();
  settings.width = 31;
  EXPECT_THROW(VideoWriter(VideoFormat::Mp4, path, settings), InputError);
  EXPECT_FALSE(fs::exists(path));
}

TEST(Mp4Writer, NamesItsEncoder) {
  EXPECT_EQ(VideoWriter(VideoFormat::Mp4, outputFolder() / "a.mp4", smallSettings()).encoderName(),
            "libx264");
}

TEST(Mp4Writer, NamesThePathItCanNotWrite) {
  EXPECT_EQ(messageOf<MachineError>(
                [] { VideoWriter(VideoFormat::Mp4, "/missing/a.mp4", smallSettings()); }),
            "can't write /missing/a.mp4: No such file or directory");
}

TEST(Mp4Writer, TakesNamesThatLookLikeProtocols) {
  const fs::path before = fs::current_path();
  fs::current_path(outputFolder());
  writeClip("take:2.tmp", smallSettings(), 2);
  fs::current_path(before);
  EXPECT_EQ(decodeVideo(outputFolder() / "take:2.tmp").frames.size(), 2U);
}

TEST(Mp4Writer, PassesTheLibrarysWordsOnOnce) {
  VideoSettings huge = smallSettings();
  huge.width = huge.height = 40000;
  EXPECT_EQ(messageOf<MachineError>(
                [&] { VideoWriter(VideoFormat::Mp4, outputFolder() / "huge.mp4", huge); }),
            "the H.264 encoder libx264 doesn't start: Invalid argument (Picture size 40000x40000 "
            "is invalid)");
  EXPECT_EQ(messageOf<MachineError>(
                [] { VideoWriter(VideoFormat::Mp4, "/missing/a.mp4", smallSettings()); }),
            "can't write /missing/a.mp4: No such file or directory");
}

TEST(Mp4Writer, NamesAFullDisk) {
  const std::string message =
      messageOf<MachineError>([] { writeClip("/dev/full", smallSettings(), 20); });
  EXPECT_MESSAGE(message);
}

// While it lives no file of this process can grow beyond a size, as on a disk that fills up.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(rlim_t bytes) : oldHandler_(std::signal(SIGXFSZ, SIG_IGN)) {
    getrlimit(RLIMIT_FSIZE, &oldLimit_);
    const rlimit limit = {bytes, oldLimit_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  FileSizeLimit(const FileSizeLimit&) = delete;
  FileSizeLimit& operator=(const FileSizeLimit&) = delete;
  ~FileSizeLimit() {
    setrlimit(RLIMIT_FSIZE, &oldLimit_);
    std::signal(SIGXFSZ, oldHandler_);
  }

 private:
  rlimit oldLimit_{};
  void (*oldHandler_)(int);
};

TEST(Mp4Writer, NoticesADiskThatFillsUpAtAnyByte) {
  const fs::path path = outputFolder() / "filling.mp4";
  writeClip(path, smallSettings(), 20);
  const std::uintmax_t size = fs::file_size(path);
  for (std::uintmax_t limit = size - 1; limit > 100; limit -= 97) {
    std::string message;
    {
      const FileSizeLimit filling(limit);
      message = messageOf<MachineError>([&] { writeClip(path, smallSettings(), 20); });
    }
    ASSERT_EQ(message, "can't write " + path.string() + ": File too large") << limit;
  }
}

TEST(Mp4Writer, FailsAtThePictureThatFindsTheDiskFull) {
  VideoWriter writer(VideoFormat::Mp4, outputFolder() / "filling.mp4", smallSettings());
  std::mt19937 generator(7);
  image::Image noise = barPicture(0);
  const auto writeNoise = [&] {
    for (int i = 0; i < noise.stride(); ++i) {
      for (int y = 0; y < noise.height(); ++y) {
        noise.row(y)[i] = static_cast<std::uint8_t>(generator());
      }
    }
    writer.write(noise.view());
  };
  const FileSizeLimit filling(50'000);
  EXPECT_MESSAGE(messageOf<MachineError>([&] {
    for (int n = 0; n < 1000; ++n) writeNoise();
  }));
}

TEST(Mp4Writer, NoticesThatTheIndexCanNotBeMoved) {
  const fs::path path = outputFolder() / "vanished.mp4";
  VideoWriter writer(VideoFormat::Mp4, path, smallSettings());
  writer.write(barPicture(0).view());
  fs::remove(path);
  EXPECT_MESSAGE(messageOf<MachineError>([&] { writer.finish(); }));
}

TEST(Mp4Writer, LeavesAnUnplayableFileIfNotFinished) {
  const fs::path path = outputFolder() / "unfinished.mp4";
  {
    VideoWriter writer(VideoFormat::Mp4, path, smallSettings());
    for (int n = 0; n < 20; ++n) writer.write(barPicture(n).view());
  }
  EXPECT_TRUE(fs::exists(path));
  EXPECT_THROW(decodeVideo(path), MachineError);
}

TEST(Mp4Writer, RefusesAVideoWithoutPictures) {
  VideoWriter writer(VideoFormat::Mp4, outputFolder() / "empty.mp4", smallSettings());
  EXPECT_EQ(messageOf<MachineError>([&] { writer.finish(); }),
            "can't write " + (outputFolder() / "empty.mp4").string() + ": a video needs a picture");
}

TEST(Mp4Writer, RefusesAPictureOfAnotherSize) {
  VideoWriter writer(VideoFormat::Mp4, outputFolder() / "size.mp4", smallSettings());
  const image::Image wide(98, 64, image::PixelFormat::Rgba8);
  EXPECT_EQ(messageOf<InputError>([&] { writer.write(wide.view()); }),
            "can't encode a picture of 98x64: the video is 96x64");
}

TEST(Mp4Writer, TakesNoPictureAfterTheEnd) {
  VideoWriter writer(VideoFormat::Mp4, outputFolder() / "ended.mp4", smallSettings());
  writer.write(barPicture(0).view());
  writer.finish();
  EXPECT_THROW(writer.write(barPicture(1).view()), MachineError);
}

TEST(Mp4Writer, MovesWithItsFile) {
  const fs::path path = outputFolder() / "moved.mp4";
  VideoWriter first(VideoFormat::Mp4, path, smallSettings());
  first.write(barPicture(0).view());
  VideoWriter second = std::move(first);
  second.write(barPicture(1).view());
  second.finish();
  EXPECT_EQ(decodeVideo(path).frames.size(), 2U);
}

TEST(Mp4Writer, EncodesOnAsManyThreadsAsAsked) {
  for (const int threads : {1, 3}) {
    VideoSettings settings = smallSettings();
    settings.threads = threads;
    writeClip(outputFolder() / "threads.mp4", settings, 20);
    EXPECT_EQ(decodeVideo(outputFolder() / "threads.mp4").frames.size(), 20U);
    // x264 writes its settings into the stream.
    EXPECT_THAT(contentOf(outputFolder() / "threads.mp4"),
                HasSubstr(" threads=" + std::to_string(threads) + " "));
  }
}

TEST(Mp4Writer, PrintsNothing) {
  ::testing::internal::CaptureStderr();
  ::testing::internal::CaptureStdout();
  writeClip(outputFolder() / "quiet.mp4", smallSettings(), 3);
  EXPECT_THROW(VideoWriter(VideoFormat::Mp4, "/missing/a.mp4", smallSettings()), MachineError);
  EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");
  EXPECT_EQ(::testing::internal::GetCapturedStdout(), "");
}

}  // namespace
}  // namespace rotatebook::video
