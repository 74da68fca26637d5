// Every bit of a clip's file but its coded pictures, changed one by one: none is free.
#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "video/decoded_video.h"
#include "video/layout.h"
#include "video/test_clip.h"
#include "video/written_form.h"

namespace rotatebook::video {
namespace {

namespace fs = std::filesystem;

constexpr int kSwept = 6;  // Pictures of a clip.

VideoSettings sweptSettings(bool transparent) {
  VideoSettings settings = testing::smallSettings();
  settings.transparent = transparent;
  settings.title = "T";
  settings.comment = "# c";
  settings.keyFrameInterval = 0.05;
  return settings;
}

fs::path pathOf(const std::string& name, VideoFormat format) {
  return testing::outputFolder() / (name + "." + std::string(nameOf(format)));
}

std::string sweptClip(VideoFormat format, bool transparent) {
  const fs::path path = pathOf("sweep", format);
  VideoWriter writer(format, path, sweptSettings(transparent));
  for (int n = 0; n < kSwept; ++n) writer.write(testing::barPicture(n).view());
  writer.finish();
  return testing::contentOf(path);
}

/// A clip, and all that verify compares of it with the scene.
struct Swept {
  VideoFormat format = VideoFormat::Mp4;
  bool transparent = false;
  std::string content{};
  testing::DecodedVideo decoded{};
};

/// Returns whether texts, pictures, their times or the length are others.
bool isDecodedOtherwise(const fs::path& path, const Swept& clip) {
  const testing::DecodedVideo decoded = testing::decodeVideo(path);
  return decoded.metadata != clip.decoded.metadata || decoded.frames != clip.decoded.frames ||
         decoded.duration != clip.decoded.duration;
}

bool isNoticed(const std::string& content, const Swept& clip) {
  const fs::path path = pathOf("swept", clip.format);
  fs::remove(path);  // File systems flush a file that is replaced, not a new one.
  std::ofstream(path, std::ios::binary) << content;
  const VideoSettings settings = sweptSettings(clip.transparent);
  try {
    const FormDifferences found = differencesFromWritten(path, {.width = settings.width,
                                                                .height = settings.height,
                                                                .frameRate = settings.frameRate,
                                                                .frames = kSwept,
                                                                .transparent = clip.transparent});
    return !(found.container + found.stream).empty() || isDecodedOtherwise(path, clip);
  } catch (const std::runtime_error&) {
    return true;
  }
}

/// Marks what the file holds of coded pictures in `outer`.
void markPictures(std::istream& file, const Part& outer, std::vector<bool>& arePictures) {
  constexpr std::uint64_t kHead = 4;  // Of a block: its track, time and flags. [bytes]
  auto part = partAt(file, webmElement, outer.content, outer.end);
  for (; part; part = partAt(file, webmElement, part->end, outer.end)) {
    const bool isBlock = part->id == "a3" || part->id == "a1", isAlpha = part->id == "a5";
    if (isBlock || isAlpha) {
      const std::uint64_t begin = part->content + (isBlock ? kHead : 0);
      std::fill(arePictures.begin() + static_cast<std::ptrdiff_t>(begin),
                arePictures.begin() + static_cast<std::ptrdiff_t>(part->end), true);
    }
    const std::vector<std::string> outers{"18538067", "1f43b675", "a0", "75a1", "a6"};
    if (std::ranges::find(outers, part->id) != outers.end()) markPictures(file, *part, arePictures);
  }
}

std::vector<bool> picturesIn(const std::string& content, VideoFormat format) {
  std::vector<bool> arePictures(content.size());
  if (format == VideoFormat::Mp4) {
    const auto begin = static_cast<std::ptrdiff_t>(content.find("mdat") + 4);
    std::fill(arePictures.begin() + begin, arePictures.end(), true);
  } else {
    std::istringstream file(content);
    markPictures(file, {"", 0, 0, content.size()}, arePictures);
  }
  return arePictures;
}

/// Expects that each bit counts; returns how many bytes there are.
int sweep(VideoFormat format, bool transparent = false) {
  Swept clip{format, transparent, sweptClip(format, transparent)};
  clip.decoded = testing::decodeVideo(pathOf("sweep", format));
  EXPECT_FALSE(isNoticed(clip.content, clip));
  const std::vector<bool> arePictures = picturesIn(clip.content, format);
  int count = 0;
  for (std::size_t at = 0; at < clip.content.size(); ++at) {
    if (arePictures[at]) continue;
    ++count;
    for (int bit = 0; bit < 8; ++bit) {
      std::string changed = clip.content;
      changed[at] = static_cast<char>(changed[at] ^ 1 << bit);
      EXPECT_TRUE(isNoticed(changed, clip)) << "bit " << bit << " of byte " << at;
    }
  }
  return count;
}

TEST(ByteSweep, OfAnMp4FindsNoFreeBit) {
  EXPECT_GT(sweep(VideoFormat::Mp4), 900);  // measured 986
}

TEST(ByteSweep, OfAWebmFindsNoFreeBit) {
  EXPECT_GT(sweep(VideoFormat::WebM), 500);  // measured 515
}

TEST(ByteSweep, OfAWebmWithAlphaFindsNoFreeBit) {
  EXPECT_GT(sweep(VideoFormat::WebM, true), 500);  // measured 620
}

}  // namespace
}  // namespace rotatebook::video
