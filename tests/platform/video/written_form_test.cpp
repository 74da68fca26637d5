// Files that have players show another clip: whatever no muxer of this program writes is found.
#include "video/written_form.h"

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "base/error.h"
#include "video/decoded_video.h"
#include "video/part_tree.h"
#include "video/test_clip.h"

namespace rotatebook::video {
namespace {

namespace fs = std::filesystem;
using testing::bytesOfHex;
using testing::PartTree;

constexpr int kPictures = 5;

WrittenForm formOf(const VideoSettings& settings, int pictures = kPictures) {
  return {.width = settings.width,
          .height = settings.height,
          .frameRate = settings.frameRate,
          .frames = pictures,
          .transparent = settings.transparent};
}

/// Writes a clip with a title and a comment; returns its path.
fs::path writtenAs(VideoFormat format, VideoSettings settings = testing::smallSettings(),
                   int pictures = kPictures) {
  settings.comment = "# a record";
  const fs::path path = testing::outputFolder() / ("form." + std::string(nameOf(format)));
  VideoWriter writer(format, path, settings);
  for (int n = 0; n < pictures; ++n) writer.write(testing::barPicture(n).view());
  writer.finish();
  return path;
}

FormDifferences differencesIn(const std::string& content, VideoFormat format) {
  const fs::path path = testing::outputFolder() / ("form_changed." + std::string(nameOf(format)));
  std::ofstream(path, std::ios::binary) << content;
  return differencesFromWritten(path, formOf(testing::smallSettings()));
}

/// Returns whether a file is refused; some are no clips to FFmpeg any more.
bool isRefused(const std::string& content, VideoFormat format) {
  try {
    return !differencesIn(content, format).container.empty();
  } catch (const InputError&) {
    return true;
  }
}

TEST(WrittenForm, IsThatOfEachClip) {
  std::vector<VideoSettings> all(7, testing::smallSettings());
  all[1].frameRate = {30000, 1001};
  all[2].frameRate = {1001, 30};
  all[3].frameRate = {1000, 1};
  all[4].preset = "veryslow";
  all[4].title = "A title";
  all[5].preset = "ultrafast";
  all[5].threads = 2;
  all[6].keyFrameInterval = 0.03;
  for (const VideoSettings& settings : all) {
    for (const VideoFormat format : {VideoFormat::Mp4, VideoFormat::WebM}) {
      for (const int pictures : {1, 2, 3, kPictures, 24}) {
        const FormDifferences found = differencesFromWritten(writtenAs(format, settings, pictures),
                                                             formOf(settings, pictures));
        EXPECT_EQ(found.container, "") << settings.frameRate.text() << " " << pictures;
        EXPECT_EQ(found.stream, "") << settings.preset << " " << pictures;
      }
    }
  }
}

TEST(WrittenForm, IsThatOfClipsWithAlpha) {
  VideoSettings settings = testing::smallSettings();
  settings.transparent = true;
  const fs::path path = writtenAs(VideoFormat::WebM, settings);
  const FormDifferences found = differencesFromWritten(path, formOf(settings));
  EXPECT_EQ(found.container + found.stream, "");
  const FormDifferences opaque = differencesFromWritten(path, formOf(testing::smallSettings()));
  EXPECT_NE(opaque.container, "");
  const FormDifferences none =
      differencesFromWritten(writtenAs(VideoFormat::WebM), formOf(settings));
  EXPECT_NE(none.container, "");
}

TEST(WrittenForm, IsOfTheSizeRateAndLengthAskedFor) {
  for (const VideoFormat format : {VideoFormat::Mp4, VideoFormat::WebM}) {
    const fs::path path = writtenAs(format);
    const WrittenForm right = formOf(testing::smallSettings());
    std::vector<WrittenForm> others(4, right);
    others[0].width += 2;
    others[1].height += 2;
    others[2].frameRate = {50, 1};
    others[3].frames *= 2;
    for (const WrittenForm& other : others) {
      EXPECT_NE(differencesFromWritten(path, other).container, "");
    }
  }
}

/// A change of a box or element: other bytes in it, or parts beside those that it has.
struct Change {
  std::string path;
  std::size_t at = 0;  ///< Where `bytes` replace others, or kFront, kBack or kGone.
  std::string bytes;   ///< In hexadecimal digits; of a part, its content.
  std::string part{};  ///< Of a part, its id.
};

constexpr std::size_t kFront = 1'000'000, kBack = kFront + 1, kGone = kFront + 2;

void apply(const Change& change, PartTree& tree) {
  PartTree& outer = change.path.empty() ? tree : tree.at(change.path);
  const std::string bytes = bytesOfHex(change.bytes);
  if (change.at == kGone) {
    std::erase_if(outer.parts, [&](const PartTree& part) { return part.id == change.part; });
  } else if (change.at == kFront || change.at == kBack) {
    const PartTree part{change.part, bytes};
    outer.parts.insert(change.at == kFront ? outer.parts.begin() : outer.parts.end(), part);
  } else {
    outer.head.replace(change.at, bytes.size(), bytes);
  }
}

const std::string kStbl = "moov/trak/mdia/minf/stbl", kAvc1 = kStbl + "/stsd/avc1";

/// Boxes by which other players than FFmpeg, which doesn't report them, show another clip.
const std::vector<Change> kBoxChanges{
    {kAvc1, kFront, "0000000200000001", "pasp"},
    {kAvc1, kBack, "0000000200000001", "pasp"},
    {kAvc1, kFront, "6e636c7800090010000900", "colr"},
    {kAvc1, kFront, "6e636c7800010001000180", "colr"},
    {kAvc1, kBack, "7249434300000000", "colr"},
    {kAvc1 + "/colr", 10, "80"},
    {kAvc1, kBack, std::string(64, '0'), "clap"},
    {kAvc1, kBack, "00023333", "gama"},
    {kAvc1, kBack, "00000000", "clli"},
    {kAvc1, kBack, "0201", "fiel"},
    {kAvc1, kBack, "00000000", "sv3d"},
    {kAvc1, 24, "02800168"},
    {kAvc1, 74, "0028"},
    {kAvc1, 42, "01"},
    {kStbl + "/stsd", kBack, "", "mp4v"},
    {kStbl + "/stsd", 4, "00000002"},
    {"moov/trak/mdia/minf/dinf/dref", kFront, "00000000ff", "url "},
    {"moov/trak/mdia/minf/dinf/dref/url ", 3, "00"},
    {"moov/trak/mdia/minf/dinf/dref", kBack, "00000001", "alis"},
    {"moov/trak/mdia/minf/vmhd", 4, "0020"},
    {"moov/trak/mdia/minf/vmhd", 6, "ffff"},
    {"moov/trak/mdia/mdhd", 18, "0280"},
    {"moov/trak/mdia/mdhd", 12, "00007800"},
    {"moov/trak/mdia/hdlr", 8, "74657874"},
    {"moov/trak/tkhd", 3, "02"},
    {"moov/trak/tkhd", 20, "00000001"},
    {"moov/trak/tkhd", 32, "0001"},
    {"moov/trak/tkhd", 40, "ffff0000"},
    {"moov/trak/tkhd", 76, "0064"},
    {"moov/trak/edts/elst", 16, "0002"},
    {"moov/trak/edts/elst", 8, "00000001"},
    {"moov/trak", kBack, "00000008636c6970", "clip"},
    {"moov/trak", kBack, "", "matt"},
    {"moov/trak", kFront, "", "tapt"},
    {"moov/trak", kBack, "", "load"},
    {"moov/trak", kBack, "", "tref"},
    {"moov/mvhd", 20, "0002"},
    {"moov/mvhd", 36, "ffff0000"},
    {"moov/mvhd", 84, "00000010"},
    {"moov/mvhd", 92, "00000010"},
    {"moov/mvhd", 16, "00000001"},
    {"moov", kBack, "", "mvex"},
    {"moov", kBack, "", "iods"},
    {"moov", kFront, "", "udta"},
    {"moov/udta", kBack, "4c4f4f50", "LOOP"},
    {"moov/udta", kBack, "0100000000000000", "chpl"},
    {"moov/udta/meta/ilst", kFront, "0000001264617461000000010000000078", "\251cmt"},
    {"moov/udta/meta/ilst", kBack, "0000001264617461000000010000000078", "\251cmt"},
    {"moov/udta/meta/ilst", kBack, "", "covr"},
    {"moov/udta/meta/ilst/\251cmt", kFront, "000000010000000078", "data"},
    {kStbl, kBack, "000000000000000100000002", "stss"},
    {kStbl + "/stss", 4, "00000000"},
    {kStbl + "/stss", 8, "00000002"},
    {kStbl, kGone, "", "stss"},
    {kStbl, kBack, "00000000", "stps"},
    {kStbl, kBack, "00000000", "sdtp"},
    {kStbl, kBack, "0000000000000000", "cslg"},
    {kStbl, kFront, "000000000000000100000005000000ff", "stts"},
    {kStbl + "/stts", 12, "00000fff"},
    {kStbl + "/ctts", 0, "01"},
    {kStbl + "/ctts", 12, "ffffff00"},
    {kStbl + "/stsc", 16, "00000002"},
    {kStbl, kFront, "00000000", "stz2"},
    {kStbl + "/stsd/avc1/btrt", 8, "00ffffff"},
    {kStbl + "/ctts", 8, "00000002"},
    {"moov/trak/edts/elst", 15, "01"},
    {"moov/udta/meta/ilst/\251cmt/data", 18, "0078"},  // After an end of text
    {"", kFront, "", "styp"},
    {"", kBack, "", "moof"},
    {"", kBack, "", "uuid"},
    {"", kBack, "00", "free"},
    {"", kBack, "00", "mdat"},
    {"", kBack, "", "moov"},
    {"", kBack, "00000000", ""},
    {"ftyp", 0, "71742020"},
};

TEST(WrittenForm, HasNoOtherBoxes) {
  const PartTree honest = testing::treeOfMp4(testing::contentOf(writtenAs(VideoFormat::Mp4)));
  EXPECT_EQ(testing::mp4Of(honest), testing::contentOf(writtenAs(VideoFormat::Mp4)));
  EXPECT_EQ(differencesIn(testing::mp4Of(honest), VideoFormat::Mp4).container, "");
  for (const Change& change : kBoxChanges) {
    PartTree tree = honest;
    apply(change, tree);
    EXPECT_TRUE(isRefused(testing::mp4Of(tree), VideoFormat::Mp4))
        << change.path << " " << change.part << change.at;
  }
}

const std::string kTrack = "18538067/1654ae6b/ae", kVideo = kTrack + "/e0",
                  kColour = kVideo + "/55b0", kInfo = "18538067/1549a966";

/// A Chapters of an ordered edition: the second half, then the first.
const std::string kOrdered =
    "45b99c45bd010045dd0101b68973c4010191008092040ab689"
    "73c40102910000920400";

/// Elements by which other players show another clip.
const std::vector<Change> kElementChanges{
    {"18538067", kBack, kOrdered, "\x10\x43\xa7\x70"},
    {"18538067", kFront, kOrdered, "\x10\x43\xa7\x70"},
    {"18538067", kBack, "", "\x19\x41\xa4\x69"},  // Attachments
    {"18538067", kBack, "", "\xec"},
    {"18538067", kBack, "", "\xbf"},
    {"18538067", kFront, "", "\x16\x54\xae\x6b"},
    {"18538067", kBack, "", "\x12\x54\xc3\x67"},
    {"18538067", kBack, "", "\x1c\x53\xbb\x6b"},
    {"", kBack, "", "\x18\x53\x80\x67"},
    {"1a45dfa3/4282", 0, "6d6b7661"},
    {kInfo, kBack, "0000000000000001", "\x3e\xb9\x23"},  // Next-UID
    {kInfo, kBack, "78", "\x3e\x83\xbb"},                // Next file
    {kInfo, kBack, "0000000000000001", "\x73\xa4"},
    {kInfo, kBack, "", "\x69\x24"},  // Chapter translate
    {kInfo + "/2ad7b1", 0, "1e8480"},
    {kTrack, kFront, "b082028054b0820280", "\xe0"},  // A second Video, before the right one
    {kTrack, kBack, "b082028054b0820280", "\xe0"},
    {kTrack, kBack, "00", "\xb9"},                // Disabled
    {kTrack, kBack, "01", "\x55\xaa"},            // Forced
    {kTrack, kBack, "40000000", "\x23\x31\x4f"},  // Time scale
    {kTrack, kBack, "7fff", "\x53\x7f"},          // Offset
    {kTrack, kBack, "", "\x6d\x80"},              // Encodings
    {kTrack, kBack, "0f4240", "\x56\xaa"},        // Delay
    {kTrack, kBack, "0f4240", "\x56\xbb"},        // Pre-roll
    {kTrack, kBack, "", "\xe2"},                  // Operation
    {kTrack, kBack, "00", "\x63\xa2"},
    {kTrack + "/86", 4, "38"},
    {kTrack + "/23e383", 0, "ff"},
    {kVideo, kBack, "0280", "\x54\xb0"},          // Shown width
    {kVideo, kBack, "08", "\x54\xcc"},            // Crop
    {kVideo, kBack, "01", "\x9a"},                // Interlaced
    {kVideo, kBack, "06", "\x9d"},                // Field order
    {kVideo, kBack, "01", "\x53\xb8"},            // Stereo
    {kVideo, kBack, "01", "\x53\xc0"},            // Alpha
    {kVideo, kBack, "400ccccd", "\x2f\xb5\x23"},  // Gamma
    {kVideo, kBack, "", "\x76\x70"},              // Projection
    {kVideo, kFront, "55bb8109", "\x55\xb0"},     // A second Colour
    {kColour, kBack, "03e8", "\x55\xbc"},         // Light levels
    {kColour, kBack, "", "\x55\xd0"},
    {kColour + "/55b9", 0, "02"},
    {kColour + "/55bb", 0, "09"},
    {"18538067/1254c367/7373", kBack,
     "45a387434f4d4d454e54448781"
     "78",
     "\x67\xc8"},
    {"18538067/1254c367", kFront,
     "63c08067c88d45a387434f4d4d454e54448781"
     "78",
     "\x73\x73"},
    {"18538067/1254c367/7373/67c8", kBack, "78", "\x44\x87"},
    {"18538067/1254c367/7373/67c8", kBack, "656e", "\x44\x7a"},
    {"18538067/1f43b675/a3", 3, "88"},             // Invisible
    {"18538067/1f43b675/a3", 3, "82"},             // Laces
    {"18538067/1f43b675/a3", 0, "82"},             // Another track
    {"18538067/1f43b675", kBack, "", "\x58\x54"},  // Silent tracks
    {"18538067/1f43b675", kBack,
     "a18581000080"
     "00",
     "\xa0"},
    {"18538067/1f43b675/a3", 3, "00"},    // No key frame
    {"18538067/1f43b675/a3", 1, "0001"},  // Another time
    {"18538067/1f43b675/e7", 0, "01"},
    {kInfo + "/4489", 0, "41"},
    {"18538067/1254c367/7373/67c8/4487", 10, "0078"},  // After an end of text
    {"18538067/1c53bb6b/bb/b3", 0, "01"},
    {"18538067/1c53bb6b/bb/b7/f0", 0, "00"},
    {"18538067/ec", 0, "10"},
    {"18538067/114d9b74/4dbb/53ab", 0, "1043a770"},
    {"18538067/114d9b74/4dbb/53ac", 0, "42"},
    {"18538067/1c53bb6b/bb/b7/f1", 0, "ff"}};

TEST(WrittenForm, HasNoOtherElements) {
  const std::string content = testing::contentOf(writtenAs(VideoFormat::WebM));
  const PartTree honest = testing::treeOfWebm(content);
  EXPECT_EQ(testing::webmOf(honest), content);
  for (const Change& change : kElementChanges) {
    PartTree tree = honest;
    apply(change, tree);
    EXPECT_TRUE(isRefused(testing::webmOf(tree), VideoFormat::WebM))
        << change.path << " " << change.bytes;
  }
}

// Players that read a cluster as it arrives take another time for what is before its own.
TEST(WrittenForm, HasNoTimeAfterItsPictures) {
  PartTree tree = testing::treeOfWebm(testing::contentOf(writtenAs(VideoFormat::WebM)));
  std::vector<PartTree>& parts = tree.at("18538067/1f43b675").parts;
  std::rotate(parts.begin(), parts.begin() + 1, parts.end());
  EXPECT_EQ(parts.back().id, "\xe7");
  EXPECT_TRUE(isRefused(testing::webmOf(tree), VideoFormat::WebM));
}

// As the muxer states them where there are 4 GB of pictures.
TEST(WrittenForm, HasNoLongSizes) {
  std::string content = testing::contentOf(writtenAs(VideoFormat::Mp4));
  const std::size_t at = content.find("free") - 4;
  const std::string size = content.substr(at + 8, 4);
  content.replace(at, 16, bytesOfHex("000000016d64617400000000") + size);
  content[at + 15] = static_cast<char>(content[at + 15] + 8);
  EXPECT_TRUE(isRefused(content, VideoFormat::Mp4));
}

TEST(WrittenForm, NamesWhatDiffers) {
  const auto differenceWith = [](VideoFormat format, const Change& change) {
    const std::string content = testing::contentOf(writtenAs(format));
    PartTree tree =
        format == VideoFormat::Mp4 ? testing::treeOfMp4(content) : testing::treeOfWebm(content);
    apply(change, tree);
    return differencesIn(format == VideoFormat::Mp4 ? testing::mp4Of(tree) : testing::webmOf(tree),
                         format)
        .container;
  };
  EXPECT_EQ(differenceWith(VideoFormat::Mp4, {"moov/trak/tkhd", 3, "02"}),
            "moov/trak/tkhd differs");
  EXPECT_EQ(differenceWith(VideoFormat::Mp4, {"moov", kBack, "", "m\377\nx"}),
            "moov holds a foreign \"m\xef\xbf\xbd\\nx\"");
  EXPECT_EQ(differenceWith(VideoFormat::Mp4, {kStbl, kGone, "", "stss"}),
            "moov/trak/mdia/minf/stbl lacks stss");
  EXPECT_EQ(differenceWith(VideoFormat::WebM, {kTrack, kBack, "", "\xe0"}),
            "Segment/Tracks/TrackEntry holds one Video too many");
}

/// Calls `action` with each file in which two neighbours of `part`, or of one in it, changed
/// places.
template <typename Action>
void forEachSwap(const PartTree& whole, PartTree& part, const std::string& name,
                 const Action& action) {
  for (std::size_t i = 0; i < part.parts.size(); ++i) {
    forEachSwap(whole, part.parts[i], name + "/" + part.parts[i].id, action);
    if (i == 0) continue;
    std::swap(part.parts[i - 1], part.parts[i]);
    action(testing::mp4Of(whole), name + "/" + part.parts[i].id + " " + part.parts[i - 1].id);
    std::swap(part.parts[i - 1], part.parts[i]);
  }
}

// Some players read a box by those before it, or give up where one comes too early.
TEST(WrittenForm, HasItsBoxesInOrder) {
  PartTree tree = testing::treeOfMp4(testing::contentOf(writtenAs(VideoFormat::Mp4)));
  int swaps = 0;
  forEachSwap(tree, tree, "", [&](const std::string& content, const std::string& which) {
    EXPECT_TRUE(isRefused(content, VideoFormat::Mp4)) << which;
    ++swaps;
  });
  EXPECT_GT(swaps, 0);
  std::swap(tree.at("moov").parts[1], tree.at("moov").parts[2]);
  EXPECT_EQ(differencesIn(testing::mp4Of(tree), VideoFormat::Mp4).container,
            "moov has its udta before its trak");
}

}  // namespace
}  // namespace rotatebook::video
