// The keys of [clip]: the video's format, and how fast the motion goes in it.
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "base/clip_limits.h"
#include "base/number_text.h"
#include "scene/keys/keys.h"
#include "scene/keys/kinds.h"
#include "scene/keys/moments.h"
#include "scene/sections.h"

namespace rotatebook::scene {
namespace {

using document::kPositive;
using document::kPositiveTime;
using document::TomlNode;

constexpr int kSmallestPicture = 16;
constexpr const char* kPictureSizes = "a width and a height, such as [1280, 720]";
constexpr const char* kFrameRates =
    "a frame rate from 1 to 1000, an integer or a fraction such as \"30000/1001\"";
constexpr ValueForm kSideForm = integerForm(kSmallestPicture, kMaxPictureSide);
constexpr NumberRange kTimes{"a time in the clip, 0 or more seconds", 0, kPositive.max,
                             Dimension::Time};
constexpr NumberRange kSpeeds{"a number from 1e-6 to 1e6", 1e-6, 1e6};
constexpr NumberRange kStretchSpeeds{"0, which holds the picture, or a number up to 1e6", 0, 1e6};
constexpr const char* kExpectedSpeeds =
    "a number from 1e-6 to 1e6, or stretches such as [{ from = 3, to = 5, value = 0.2 }]";

// H.264 with 4:2:0 chroma has no odd sizes.
int pictureSide(const ValueReader& value) {
  const int side = value.integer(kSmallestPicture, kMaxPictureSide);
  if (side % 2 != 0) {
    value.fail(value.name() + " must be even, not " + std::to_string(side) +
               "; the nearest even sizes are " + std::to_string(side - 1) + " and " +
               std::to_string(side + 1));
  }
  return side;
}

void readPictureSize(const ValueReader& value, ClipSettings& clip) {
  const auto sides = value.elements(2, kPictureSizes);
  std::vector<int> read;
  readEach(sides, [&](const ValueReader& side) { read.push_back(pictureSide(side)); });
  clip.width = read[0];
  clip.height = read[1];
  const int pixels = clip.width * clip.height;  // At most 16384 * 16384 < 2^31.
  if (pixels > kMaxPicturePixels) {
    value.fail(value.name() + " has " + std::to_string(pixels) + " pixels; the limit is " +
               std::to_string(kMaxPicturePixels) + ", for example [8192, 4352]");
  }
}

std::string pictureSizeText(const ClipSettings& clip) {
  return "[" + std::to_string(clip.width) + ", " + std::to_string(clip.height) + "]";
}

/// Returns the rate that a decimal number stands for, as a scene states it: "30000/1001" in quotes
/// for 29.97, 60 for 60.0; empty if there is none.
std::string nearestRate(const TomlNode& node) {
  const double* number = std::get_if<double>(&node.value);
  if (number == nullptr || !(*number >= 1 && *number <= 1000)) return "";
  const double whole = std::round(*number);
  if (whole == *number) return std::to_string(std::llround(whole));
  constexpr double kRounding = 0.006;  // of "23.98" and "29.97"
  if (std::fabs(*number - whole / 1.001) > kRounding) return "";
  return tomlString(std::to_string(std::llround(whole)) + "000/1001");
}

FrameRate frameRateFrom(const ValueReader& value) {
  std::string text;
  if (const auto* whole = std::get_if<std::int64_t>(&value.node().value)) {
    text = std::to_string(*whole);
  } else if (const auto* fraction = std::get_if<std::string>(&value.node().value)) {
    text = *fraction;
  }
  const std::optional<FrameRate> rate = parseFrameRate(text);
  if (rate) return *rate;
  const std::string near = nearestRate(value.node());
  value.fail(value.name() + " must be " + kFrameRates + ", not " + describe(value.node()) +
             (near.empty() ? "" : "; did you mean " + near + "?"));
}

std::string frameRateText(const FrameRate& rate) {
  return rate.denominator == 1 ? rate.text() : tomlString(rate.text());
}

SpeedStretch stretchFrom(const ValueReader& table) {
  SpeedStretch stretch;
  const auto readInto = [](double& number, const NumberRange& range) {
    return [&number, &range](const ValueReader& value) { number = value.number(range); };
  };
  const auto readTime = [](double& time, std::optional<Moment>& moment) {
    return [&time, &moment](const ValueReader& value) {
      isOfEvent(value) ? void(moment = momentFrom(value)) : void(time = value.number(kTimes));
    };
  };
  table.readTable({{"from", readTime(stretch.from, stretch.begin)},
                   {"to", readTime(stretch.to, stretch.end)},
                   {"value", readInto(stretch.value, kStretchSpeeds)}});
  for (const char* key : {"from", "to", "value"}) {
    if (!table.find(key)) table.fail(table.name() + " needs from, to and value");
  }
  if (stretch.end && stretch.value == 0) {
    table.fail(table.name() +
               " holds the motion, so that it never comes to the event in `to`; state "
               "seconds of the video");
  }
  if (stretch.hasMoments() || stretch.to > stretch.from) return stretch;
  table.fail(table.name() + " must end after it begins, not go from " + shortestText(stretch.from) +
             " s to " + shortestText(stretch.to) + " s");
}

PlaybackSpeed speedFrom(const ValueReader& value) {
  const auto& stated = value.node().value;
  PlaybackSpeed speed;
  if (std::holds_alternative<double>(stated) || std::holds_alternative<std::int64_t>(stated)) {
    const double number = value.number(document::kNumber);
    if (number == 0) {
      value.fail(value.name() + " must be " + std::string(kSpeeds.expected) +
                 ", not 0; to hold a picture, write a stretch, such as "
                 "[{ from = 3, to = 5, value = 0 }]");
    }
    speed.constant = value.number(kSpeeds);
    return speed;
  }
  double end = 0;
  readEach(value.tables(kExpectedSpeeds), [&](const ValueReader& table) {
    const SpeedStretch stretch = stretchFrom(table);
    if (!stretch.begin && stretch.from < end) {
      table.fail("the stretches of " + value.name() +
                 " must follow each other, but one begins at " + shortestText(stretch.from) +
                 " s, before the last has ended at " + shortestText(end) + " s");
    }
    end = stretch.end ? 0 : stretch.to;
    speed.stretches.push_back(stretch);
  });
  return speed;
}

std::string speedText(const PlaybackSpeed& speed) {
  if (speed.stretches.empty()) return tomlNumber(speed.constant);
  return listText(speed.stretches, [](const SpeedStretch& stretch) {
    return "{ from = " + (stretch.begin ? momentText(*stretch.begin) : tomlNumber(stretch.from)) +
           ", to = " + (stretch.end ? momentText(*stretch.end) : tomlNumber(stretch.to)) +
           ", value = " + tomlNumber(stretch.value) + " }";
  });
}

}  // namespace

Keys<ClipSettings> clipKeys() {
  static constexpr std::array keys{
      keyOf<ClipSettings, readPictureSize, pictureSizeText>(
          "size", listForm(kPictureSizes, kSideForm, 2),
          {.comment = "pixels, width and height, even",
           .meaning = "each even, 16 to 16384",
           .unit = "pixels",
           .affects = Affects::Picture}),
      own<&ClipSettings::frameRate, frameRateFrom, frameRateText>(
          "fps", kNumberOrText, kFrameRates,
          {.comment = "frames a second", .meaning = "of the video", .unit = "frames/s"}),
      number<&ClipSettings::duration>("duration", kPositiveTime,
                                      {.comment = "s of video", .meaning = "of the video"}),
      number<&ClipSettings::poster>(
          "poster", kTimes,
          {.comment = "s, time of the poster in the video",
           .meaning = "time of the poster, the picture that represents the clip",
           .byDefault = "the clip's middle",
           .affects = Affects::Picture}),
      own<&ClipSettings::speed, speedFrom, speedText>(
          "speed", {.number = true, .list = true}, kExpectedSpeeds,
          {.comment = "of the motion in the video; 0.25 is slow motion",
           .meaning = "of the motion in the video: 0.25 is slow motion, four times as long; "
                      "see [slow motion](#slow-motion)",
           .byDefault = "`1.0`, or as `time_per_frame` says"}),
  };
  return keys;
}

}  // namespace rotatebook::scene
