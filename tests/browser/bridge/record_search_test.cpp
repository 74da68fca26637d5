// The record that rb_record() finds; tests/browser/player/record_test.cjs has hostile clips.
#include <cstring>
#include <string>
#include <string_view>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "bridge/bridge.h"

namespace rotatebook::bridge {
namespace {

using ::testing::AnyOf;
using ::testing::HasSubstr;

const std::string kText =
    "# Made by rotatebook 1.0 from the scene x\n\ntitle = \"Ein schönes Buch\"\n";

std::string sizeBytes(std::size_t size) {
  std::string bytes;
  for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(size >> shift & 0xff);
  return bytes;
}

std::string box(const std::string& type, const std::string& content) {
  return sizeBytes(content.size() + 8) + type + content;
}

std::string element(const std::string& id, const std::string& content) {
  return id + sizeBytes(0x10000000 + content.size()) + content;
}

std::string mp4(const std::string& text, std::size_t pictures = 10) {
  const std::string comment = box("\251cmt", box("data", std::string(8, '\0') + text));
  return box("ftyp", "isom") + box("mdat", std::string(pictures, 'x')) +
         box("moov", box("udta", box("meta", std::string(4, '\0') + box("ilst", comment))));
}

std::string webm(const std::string& text, std::size_t pictures = 10) {
  const std::string tag =
      element("\x67\xc8", element("\x45\xa3", "COMMENT") + element("\x44\x87", text));
  return element("\x1a\x45\xdf\xa3", "webm") +
         element("\x18\x53\x80\x67", element("\x1f\x43\xb6\x75", std::string(pictures, 'x')) +
                                         element("\x12\x54\xc3\x67", element("\x73\x73", tag)));
}

/// Returns the record in a file, or the message.
std::string recordIn(std::string_view file) {
  rb_clip(context(), static_cast<double>(file.size()));
  std::int32_t length = 0;
  while (length == 0) {
    const std::string_view piece =
        file.substr(static_cast<std::size_t>(rb_clip_offset(context())), kRecordPiece);
    std::memcpy(rb_buffer(context()), piece.data(), piece.size());
    length = rb_record(context(), static_cast<std::int32_t>(piece.size()));
  }
  return {rb_buffer(context()), static_cast<std::size_t>(std::abs(length))};
}

TEST(RecordSearch, FindsItAfterAnyPictures) {
  for (const auto clip : {mp4, webm}) {
    EXPECT_EQ(recordIn(clip(kText, 10)), kText);
    // The heads of what comes after them lie at, and across, the end of the first piece.
    for (std::size_t pictures = kRecordPiece - 300; pictures < kRecordPiece + 50; ++pictures) {
      ASSERT_EQ(recordIn(clip(kText, pictures)), kText) << pictures;
    }
    EXPECT_EQ(recordIn(clip(kText, 10'000'000)), kText);
  }
}

TEST(RecordSearch, RefusesWhatIsCutOff) {
  for (const std::string& clip : {mp4(kText), webm(kText)}) {
    for (std::size_t size = 0; size < clip.size(); ++size) {
      ASSERT_THAT(recordIn(clip.substr(0, size)),
                  AnyOf(HasSubstr("cut off"), HasSubstr("too short"), HasSubstr("no record")))
          << size;
    }
  }
}

TEST(RecordSearch, RefusesPiecesThatAreShorter) {
  rb_clip(context(), 100);
  EXPECT_LT(rb_record(context(), 99), 0);
  EXPECT_THAT(std::string(rb_buffer(context()), 30), HasSubstr("cut off"));
}

TEST(RecordSearch, TakesAnyBytes) {
  for (const std::string& clip : {mp4(kText), webm(kText)}) {
    for (std::size_t at = 0; at < clip.size(); ++at) {
      for (const char value : {'\x00', '\x01', '\x7f', '\xff'}) {
        std::string damaged = clip;
        damaged[at] = value;
        ASSERT_NE(recordIn(damaged), "");
      }
    }
  }
}

}  // namespace
}  // namespace rotatebook::bridge
