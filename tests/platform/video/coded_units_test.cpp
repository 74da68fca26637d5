// Coded pictures that have players show another clip.
#include "video/coded_units.h"

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "video/bit_reader.h"
#include "video/clip_reader.h"
#include "video/forged_stream.h"
#include "video/part_tree.h"
#include "video/test_clip.h"
#include "video/written_form.h"

namespace rotatebook::video {
namespace {

using testing::bytesOfHex;
using ::testing::Each;
using ::testing::HasSubstr;
using Change = std::function<void(std::string& packet, int index)>;

const WrittenForm kForm{.width = testing::kWidth, .height = testing::kHeight, .frames = 5};

/// Of pictures that wait for two others to be decoded.
const Payload kWaiting{.sizes = std::vector<std::uint64_t>(5), .delay = 2};

FormDifferences differencesWith(VideoFormat format, const Change& change) {
  const auto path = testing::outputFolder() / ("units." + std::string(nameOf(format)));
  testing::writeChangedStream(path, format, change);
  return differencesFromWritten(path, kForm);
}

/// libx264's packets have start codes, of four bytes or three, in front of units.
const std::string kStart("\0\0\0\1", 4);

TEST(CodedUnits, OfAClipAreThoseOfItsEncoder) {
  for (const VideoFormat format : {VideoFormat::Mp4, VideoFormat::WebM}) {
    const FormDifferences found = differencesWith(format, [](std::string&, int) {});
    EXPECT_EQ(found.container + found.stream, "");
  }
}

// Of other types than slices, some have decoders show other pictures, or show none.
TEST(CodedUnits, OfOtherTypesAreRefused) {
  for (int type = 0; type < 32; ++type) {
    for (const bool isBefore : {false, true}) {
      const std::string unit = kStart + std::string(1, static_cast<char>(0x60 | type)) + "\x8a\x80";
      const FormDifferences found =
          differencesWith(VideoFormat::Mp4, [&](std::string& packet, int n) {
            if (n == 2) packet = isBefore ? unit + packet : packet + unit;
          });
      EXPECT_THAT(found.stream, HasSubstr("picture 2, as coded, holds ")) << type;
    }
  }
}

TEST(CodedUnits, OfTwoPicturesAreRefused) {
  std::string before;
  const FormDifferences found = differencesWith(VideoFormat::Mp4, [&](std::string& packet, int n) {
    const std::string own = packet;
    if (n == 3) packet += before;
    if (n == 4) packet = before + packet;
    before = own;
  });
  EXPECT_THAT(found.stream, HasSubstr("picture 3, as coded, holds a NAL unit of type 1"));
}

// Full-frame freeze, pan-scan, tone mapping, frame packing, display orientation, and a note of
// another program.
TEST(CodedUnits, WithMessagesAreRefused) {
  for (const std::string message :
       {"0d0180", "02048000008080", "1704ffffffff80", "2d0441234580", "2f0380000080",
        "051000000000000000000000000000000000"
        "80"}) {
    for (const int index : {0, 1}) {
      const FormDifferences found =
          differencesWith(VideoFormat::Mp4, [&](std::string& packet, int n) {
            if (n == index) packet = kStart + bytesOfHex("06" + message) + packet;
          });
      EXPECT_NE(found.stream, "") << message << " " << index;
    }
  }
}

// Of an old libx264's pictures, FFmpeg repeats mistakes that other decoders don't make.
TEST(CodedUnits, AreOfNoOldLibx264) {
  const auto streamWith = [](const std::string& version) {
    return differencesWith(VideoFormat::Mp4,
                           [&](std::string& packet, int n) {
                             if (n == 0)
                               packet.replace(packet.find("core ") + 5, version.size(), version);
                           })
        .stream;
  };
  EXPECT_EQ(streamWith("164"), "");
  EXPECT_EQ(streamWith("033"), "picture 0, as coded, holds a foreign message");
  EXPECT_EQ(streamWith("150"), "picture 0, as coded, holds a foreign message");
  EXPECT_EQ(streamWith("x64"), "picture 0, as coded, holds a foreign message");
}

TEST(CodedUnits, HaveNoWordsButLibx264s) {
  const auto streamWith = [](const std::string& there, const std::string& changed) {
    return differencesWith(VideoFormat::Mp4,
                           [&](std::string& packet, int n) {
                             if (n == 0) packet.replace(packet.find(there), there.size(), changed);
                           })
        .stream;
  };
  EXPECT_EQ(streamWith(" ref=", " ref="), "");
  EXPECT_EQ(streamWith("2003-20", "2003-21"), "picture 0, as coded, holds a foreign message");
  const std::vector<std::pair<std::string, std::string>> words{
      {"cabac", "kabac"}, {"Copy", "Kopy"},     {"www.", "wwww"},
      {" ref", "_ref"},   {"qpmin=", "qpmax="}, {"rc=crf", "rc=hey"}};
  for (const auto& [there, changed] : words) {
    EXPECT_EQ(streamWith(there, changed), "picture 0, as coded, holds a foreign message") << there;
  }
}

// A unit in a unit, which decoders find that look for start codes.
TEST(CodedUnits, HideNoUnits) {
  const FormDifferences found = differencesWith(VideoFormat::Mp4, [](std::string& packet, int n) {
    if (n == 1) packet += std::string("\0\0\1\x41\x9a", 5);
  });
  EXPECT_NE(found.stream, "");
  const std::vector<std::uint8_t> hiding{0, 0, 0, 7, 0x41, 0x9a, 0x24, 0, 0, 1, 0x41};
  EXPECT_THAT(h264Picture(hiding, false, {}).difference, HasSubstr("isn't a whole picture"));
}

// By such numbers some decoders order pictures, or show none of those that still wait.
TEST(CodedUnits, HaveTheNumbersOfTheirTimes) {
  const auto streamWith = [](int picture, std::string unit, std::size_t at, int bit) {
    return differencesWith(VideoFormat::Mp4,
                           [&](std::string& packet, int n) {
                             const std::size_t begin = packet.find(unit) + unit.size() + at;
                             if (n == picture)
                               packet.at(begin) = static_cast<char>(packet.at(begin) ^ 1 << bit);
                           })
        .stream;
  };
  // A key frame's slice: type, parameters, number, order, whether those before it are left out.
  const std::string key("\0\0\1\x65\x88", 5), other("\0\0\1\x41", 4);
  EXPECT_EQ(streamWith(0, key, 1, 3), "picture 0, as coded, holds the numbers of another order");
  EXPECT_EQ(streamWith(0, key, 1, 4), "picture 0, as coded, holds the numbers of another order");
  EXPECT_EQ(streamWith(0, key, 1, 5), "picture 0, as coded, holds the numbers of another order");
  // Its number, and then its order.
  EXPECT_EQ(streamWith(1, other, 0, 0), "picture 1, as coded, holds the numbers of another order");
  EXPECT_EQ(streamWith(1, other, 1, 3), "picture 1, as coded, holds the numbers of another order");
}

Bytes bytesIn(const std::string& text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

TEST(CodedUnits, OfOtherParametersAreRefused) {
  const auto differenceWith = [&](const std::string& parameters, const std::string& filter) {
    return h264Difference(bytesIn(testing::forgedParameters(parameters, filter)), kForm, kWaiting);
  };
  EXPECT_EQ(differenceWith("bframes=2", "null"), "");
  for (const std::string change :
       {"overscan_appropriate_flag=1", "video_format=1", "video_full_range_flag=1",
        "colour_primaries=9", "sample_aspect_ratio=2", "chroma_sample_loc_type=2", "tick_rate=50",
        "crop_left=2", "crop_bottom=4"}) {
    EXPECT_NE(differenceWith("bframes=2", "h264_metadata=" + change), "") << change;
  }
  EXPECT_NE(differenceWith("tff=1", "null"), "");
  EXPECT_NE(differenceWith("nal-hrd=vbr:vbv-maxrate=900:vbv-bufsize=900", "null"), "");
  EXPECT_NE(differenceWith("pic-struct=1", "null"), "");
  const std::string right = testing::forgedParameters("bframes=2", "null");
  EXPECT_NE(h264Difference(bytesIn(right + "x"), kForm, kWaiting), "");
  EXPECT_NE(h264Difference(bytesIn(right.substr(0, right.size() - 1)), kForm, kWaiting), "");
}

/// Returns the packets of a WebM.
std::vector<std::string> vp9Packets() {
  std::vector<std::string> packets;
  differencesWith(VideoFormat::WebM, [&](std::string& packet, int) { packets.push_back(packet); });
  return packets;
}

TEST(CodedUnits, OfVp9AreOneFrameToShow) {
  const std::vector<std::string> packets = vp9Packets();
  const auto differenceOf = [](const std::string& packet) {
    return vp9Picture(bytesIn(packet), kForm).difference;
  };
  const auto superframe = [](const std::string& first, const std::string& second) {
    std::string sizes;
    for (const std::string& frame : {first, second}) {
      sizes += static_cast<char>(frame.size() & 0xff);
      sizes += static_cast<char>(frame.size() >> 8);
    }
    return first + second + "\xc9" + sizes + "\xc9";
  };
  std::string hidden = packets[1];
  hidden[0] = static_cast<char>(hidden[0] & ~2);
  EXPECT_EQ(differenceOf(packets[2]), "");
  EXPECT_EQ(differenceOf(hidden), "not one frame to show");
  EXPECT_EQ(differenceOf(superframe(packets[1], packets[2])), "not one frame to show");
  EXPECT_EQ(differenceOf(superframe(packets[2], hidden)), "not one frame to show");
  EXPECT_EQ(differenceOf(superframe(hidden, packets[2])), "");
  EXPECT_EQ(differenceOf("x" + superframe(hidden, packets[2])), "bytes in no frame");
}

// FFmpeg's own decoder ignores bytes after a frame; to libvpx, and thus to browsers, they are the
// next frame, which it shows in its place.
TEST(CodedUnits, OfVp9AreTheSamePictureToEachDecoder) {
  const auto path = testing::outputFolder() / "units_trailing.webm";
  const auto messagesWith = [&](const Change& change) {
    testing::writeChangedStream(path, VideoFormat::WebM, change);
    std::vector<std::string> messages;
    for (ClipReader reader(path); reader.next();) {
      messages.push_back(reader.pictureFacts().messages);
    }
    return messages;
  };
  EXPECT_THAT(messagesWith([](std::string&, int) {}), Each(""));
  std::string key;
  const std::vector<std::string> messages = messagesWith([&](std::string& packet, int n) {
    if (n == 0) key = packet;
    if (n == 4) packet += key;  // Before, the decoders would part for good.
  });
  ASSERT_EQ(messages.size(), 5U);
  EXPECT_EQ(messages[3], "");
  EXPECT_EQ(messages[4], "another picture for another decoder");
}

// Where a frame may ask to be shown in another size, players may stretch it.
TEST(CodedUnits, OfVp9AreOfTheClipsSizeAndColours) {
  const std::string key = vp9Packets().front();
  const auto differenceOf = [](const std::string& bytes) {
    return vp9Picture(bytesIn(bytes), kForm).difference;
  };
  EXPECT_EQ(differenceOf(key), "");
  // After a byte, the sync code, three bits of the matrix, one of the range, 16 of width and of
  // height.
  for (const auto& [at, bit] :
       std::vector<std::pair<std::size_t, int>>{{1, 0}, {4, 7}, {4, 4}, {6, 4}, {8, 4}, {8, 3}}) {
    std::string changed = key;
    changed[at] = static_cast<char>(changed[at] ^ 1 << bit);
    EXPECT_NE(differenceOf(changed), "") << at << ", " << bit;
  }
}

TEST(CodedUnits, OfAnyBytesAreRead) {
  for (int seed = 0; seed < 2000; ++seed) {
    std::vector<std::uint8_t> bytes(static_cast<std::size_t>(seed % 50));
    unsigned value = static_cast<unsigned>(seed);
    for (std::uint8_t& byte : bytes)
      byte = static_cast<std::uint8_t>((value = value * 1664525U + 1013904223U) >> 24);
    EXPECT_NE(h264Difference(bytes, kForm, {}), "");
    h264Picture(bytes, true, {});
    PictureOrder(bytes).isPlain(bytes, seed);
    vp9Picture(bytes, kForm);
  }
}

TEST(BitReader, ReadsNumbersOfH264) {
  const std::vector<std::uint8_t> bytes{0b10100011, 0b00010000};
  BitReader in(bytes);
  EXPECT_EQ(in.golomb(), 0U);
  EXPECT_EQ(in.golomb(), 1U);
  EXPECT_EQ(in.golomb(), 5U);
  EXPECT_EQ(in.golomb(), 3U);
}

}  // namespace
}  // namespace rotatebook::video
