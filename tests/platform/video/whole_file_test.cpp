#include "video/whole_file.h"

#include <sstream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "video/decoded_video.h"
#include "video/test_clip.h"

namespace rotatebook::video {
namespace {

using ::testing::StartsWith;

std::string wholeClip(VideoFormat format) {
  const auto path = testing::outputFolder() / ("whole." + std::string(nameOf(format)));
  VideoWriter writer(format, path, testing::smallSettings());
  for (int n = 0; n < 3; ++n) writer.write(testing::barPicture(n).view());
  writer.finish();
  return testing::contentOf(path);
}

/// Returns the judgement of the bytes; "whole" if there is none.
std::string judgementOf(const std::string& content) {
  try {
    std::istringstream file(content);
    requireWholeFile(file, "x");
    return "whole";
  } catch (const InputError& error) {
    return error.what();
  }
}

class WholeFile : public ::testing::TestWithParam<VideoFormat> {};

TEST_P(WholeFile, IsNotCutAnywhere) {
  const std::string content = wholeClip(GetParam());
  EXPECT_EQ(judgementOf(content), "whole");
  constexpr std::size_t kNamed = 12;  // A file that is shorter doesn't tell what it is.
  for (std::size_t size = kNamed; size < content.size(); ++size) {
    ASSERT_THAT(judgementOf(content.substr(0, size)), StartsWith("x ends early, or is damaged: "))
        << size;
  }
  EXPECT_EQ(judgementOf(content.substr(0, content.size() - 1)),
            "x ends early, or is damaged: it has " + std::to_string(content.size() - 1) +
                " of at least " + std::to_string(content.size()) +
                " bytes; copy it again, or render it again");
}

TEST_P(WholeFile, MayBeFollowedByOther) {
  EXPECT_EQ(judgementOf(wholeClip(GetParam()) + std::string(1000, '\xff')), "whole");
}

TEST_P(WholeFile, MayBeDamagedInAnyWay) {
  const std::string content = wholeClip(GetParam());
  for (std::size_t at = 0; at < content.size(); ++at) {
    for (const char value : {'\x00', '\x01', '\xff'}) {
      std::string damaged = content;
      damaged[at] = value;
      judgementOf(damaged);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Formats, WholeFile,
                         ::testing::Values(VideoFormat::Mp4, VideoFormat::WebM));

TEST(WholeFileOf, OtherKindsIsNotJudged) {
  for (const std::string content : {"", "x", "GIF89a", "title = 'x'\n"}) {
    EXPECT_EQ(judgementOf(content), "whole");
  }
  EXPECT_NO_THROW(requireWholeFile(testing::outputFolder()));
  EXPECT_NO_THROW(requireWholeFile("no such file.mp4"));
}

}  // namespace
}  // namespace rotatebook::video
