// The keys of the title, [clip], [video], [camera], [book], [look] and [overlay]: how the motion is
// shown.
#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "base/clip_limits.h"
#include "base/number_text.h"
#include "scene/keys/keys.h"
#include "scene/keys/kinds.h"
#include "scene/sections.h"

namespace rotatebook::scene {
namespace {

using document::kPositive;
using document::TomlNode;

constexpr int kSmallestPicture = 16;
constexpr int kMaxThreads = 64;
constexpr int kMaxSupersample = 2;
constexpr unsigned kMaxMoments = 16;  // For motion blur.

constexpr const char* kPictureSizes = "a width and a height, such as [1280, 720]";
constexpr const char* kFrameRates =
    "a frame rate from 1 to 1000, an integer or a fraction such as \"30000/1001\"";
constexpr const char* kExpectedPresets = "\"book\" or x264's \"ultrafast\" to \"placebo\"";
constexpr const char* kTextures = "\"builtin\" or a path relative to the scene's folder";
constexpr const char* kBackgroundTexts =
    "\"studio\", \"stars\", \"transparent\", \"white\", \"black\" or a colour such as \"#2b5d8a\"";
constexpr const char* kBlurMoments = "1, 2, 4, 8 or 16";

constexpr NumberRange kPoints{"three numbers from -1e9 to 1e9", -1e9, 1e9, Dimension::Length};
constexpr NumberRange kTimes{"a time in the clip, 0 or more seconds", 0, kPositive.max,
                             Dimension::Time};
constexpr NumberRange kDurations{kPositive.expected, kPositive.min, kPositive.max, Dimension::Time};
constexpr NumberRange kSpeeds{"a number from 1e-6 to 1e6", 1e-6, 1e6};
constexpr const char* kExpectedSpeeds =
    "a number from 1e-6 to 1e6, or stretches such as [{ from = 3, to = 5, value = 0.2 }]";
constexpr NumberRange kOverlayScales{"a number from 0.5 to 3", 0.5, 3};
constexpr NumberRange kAngles{"an angle from 1 to 170 degrees", 1, 170};

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
  clip.width = pictureSide(sides[0]);
  clip.height = pictureSide(sides[1]);
  const int pixels = clip.width * clip.height;  // At most 16384 * 16384 < 2^31.
  if (pixels > kMaxPicturePixels) {
    value.fail(value.name() + " has " + std::to_string(pixels) + " pixels; the limit is " +
               std::to_string(kMaxPicturePixels) + ", for example [8192, 4352]");
  }
}

std::string pictureSizeText(const ClipSettings& clip) {
  return "[" + std::to_string(clip.width) + ", " + std::to_string(clip.height) + "]";
}

FrameRate frameRateFrom(const ValueReader& value) {
  std::string text;
  if (const auto* whole = std::get_if<std::int64_t>(&value.node().value)) {
    text = std::to_string(*whole);
  } else if (const auto* fraction = std::get_if<std::string>(&value.node().value)) {
    text = *fraction;
  }
  const std::optional<FrameRate> rate = parseFrameRate(text);
  if (!rate) value.mismatch(kFrameRates);
  return *rate;
}

std::string frameRateText(const FrameRate& rate) {
  return rate.denominator == 1 ? rate.text() : tomlString(rate.text());
}

std::string presetFrom(const ValueReader& value) {
  return std::string(kVideoPresets[value.choice(kVideoPresets)]);
}

// Accepts only relative paths, so that a clip names no folder of the machine it was made on.
std::string textureFrom(const ValueReader& value) {
  std::string texture = value.text(kLongestPath);
  if (texture.empty() || std::filesystem::path(texture).is_absolute()) {
    value.mismatch(kTextures);
  }
  return texture;
}

Key<BookSettings> textureKey(std::string_view name, std::string BookSettings::*texture,
                             const std::string& comment = "") {
  return key(name, texture, Kind<std::string>{textureFrom, tomlString, kTextures},
             {.comment = comment, .meaning = "a PNG, JPEG or WebP"});
}

void readBackground(const ValueReader& value, LookSettings& look) {
  const auto* text = std::get_if<std::string>(&value.node().value);
  if (text == nullptr) value.mismatch(kBackgroundTexts);
  if (const std::optional<Rgb> colour = parseRgb(*text)) {
    look.background = Background::Plain;
    look.plainColour = *colour;
    return;
  }
  const auto named = std::ranges::find(kBackgrounds, *text, &Named<Background>::name);
  if (named == kBackgrounds.end()) {
    value.fail(value.name() + " must be " + kBackgroundTexts + ", not " + describe(value.node()) +
               didYouMean(*text, namesOf(kBackgrounds)));
  }
  look.background = named->value;
}

std::string backgroundText(const LookSettings& look) {
  if (look.background == Background::Plain) return tomlString(textOf(look.plainColour));
  return quotedName(kBackgrounds, look.background);
}

// Accepts only powers of two, by which times divide without rounding: blurred or not, the motion is
// the same.
int momentsFrom(const ValueReader& value) {
  const int moments = value.integer(1, kMaxMoments);
  if (!std::has_single_bit(static_cast<unsigned>(moments))) value.mismatch(kBlurMoments);
  return moments;
}

std::vector<Overlay> overlaysFrom(const ValueReader& value) {
  const auto* array = std::get_if<TomlNode::Array>(&value.node().value);
  if (array == nullptr) value.mismatch("a list of overlays, such as [\"caption\", \"clock\"]");
  std::vector<Overlay> overlays;
  for (const ValueReader& element : value.elements(array->size(), "a list of overlays")) {
    const auto overlay = choiceFrom(element, kOverlays);
    if (std::ranges::count(overlays, overlay) > 0) {
      element.fail(element.name() + " has " + std::string(nameOf(kOverlays, overlay)) + " twice");
    }
    overlays.push_back(overlay);
  }
  return overlays;
}

std::string overlaysText(const std::vector<Overlay>& overlays) {
  return listText(overlays, [](Overlay overlay) { return quotedName(kOverlays, overlay); });
}

constexpr std::array<std::string_view, 2> kLanguages{"english", "german"};
constexpr std::string_view kDecimalMark = "decimal_mark";
constexpr const char* kExpectedWords =
    "\"english\", \"german\", a table of words, such as { \"Flips\" = \"Retournements\" }, or a "
    "TOML file of one, such as \"french.words\"";
constexpr std::size_t kLongestWord = 60;

Words wordsFrom(const ValueReader& value) {
  if (const auto* language = std::get_if<std::string>(&value.node().value)) {
    if (*language == kLanguages[0]) return {};
    if (*language == kLanguages[1]) return germanWords();
    value.fail(value.name() + " must be " + kExpectedWords + ", not " + describe(value.node()) +
               didYouMean(*language, kLanguages));
  }
  if (!std::holds_alternative<TomlNode::Table>(value.node().value)) value.mismatch(kExpectedWords);
  Words words;
  const auto fieldOf = [](std::string_view key, std::string& into) {
    return document::Field{key,
                           [&into](const ValueReader& word) { into = word.text(kLongestWord); }};
  };
  std::vector<document::Field> fields{fieldOf(kDecimalMark, words.decimalMark)};
  for (std::size_t i = 0; i < kEnglishWords.size(); ++i) {
    fields.push_back(fieldOf(kEnglishWords[i], words.texts[i]));
  }
  value.readTable(fields);
  return words;
}

std::string wordsText(const Words& words) {
  if (words == Words{}) return tomlString(kLanguages[0]);
  if (words == germanWords()) return tomlString(kLanguages[1]);
  std::vector<std::string> entries{std::string(kDecimalMark) + " = " +
                                   tomlString(words.decimalMark)};
  for (std::size_t i = 0; i < kEnglishWords.size(); ++i) {
    if (words.texts[i] == kEnglishWords[i]) continue;
    entries.push_back(tomlString(kEnglishWords[i]) + " = " + tomlString(words.texts[i]));
  }
  return "{ " + joined(entries) + " }";
}

SpeedStretch stretchFrom(const ValueReader& table) {
  SpeedStretch stretch;
  const auto readInto = [](double& number, const NumberRange& range) {
    return [&number, &range](const ValueReader& value) { number = value.number(range); };
  };
  table.readTable({{"from", readInto(stretch.from, kTimes)},
                   {"to", readInto(stretch.to, kTimes)},
                   {"value", readInto(stretch.value, kSpeeds)}});
  for (const char* key : {"from", "to", "value"}) {
    if (!table.find(key)) table.fail(table.name() + " needs from, to and value");
  }
  if (stretch.to > stretch.from) return stretch;
  table.fail(table.name() + " must end after it begins, not go from " + shortestText(stretch.from) +
             " s to " + shortestText(stretch.to) + " s");
}

PlaybackSpeed speedFrom(const ValueReader& value) {
  const auto& stated = value.node().value;
  PlaybackSpeed speed;
  if (std::holds_alternative<double>(stated) || std::holds_alternative<std::int64_t>(stated)) {
    speed.constant = value.number(kSpeeds);
    return speed;
  }
  double end = 0;
  for (const ValueReader& table : value.tables(kExpectedSpeeds)) {
    const SpeedStretch stretch = stretchFrom(table);
    if (stretch.from < end) {
      table.fail("the stretches of " + value.name() +
                 " must follow each other, but one begins at " + shortestText(stretch.from) +
                 " s, before the last has ended at " + shortestText(end) + " s");
    }
    end = stretch.to;
    speed.stretches.push_back(stretch);
  }
  return speed;
}

std::string speedText(const PlaybackSpeed& speed) {
  if (speed.stretches.empty()) return tomlNumber(speed.constant);
  return listText(speed.stretches, [](const SpeedStretch& stretch) {
    return "{ from = " + tomlNumber(stretch.from) + ", to = " + tomlNumber(stretch.to) +
           ", value = " + tomlNumber(stretch.value) + " }";
  });
}

}  // namespace

const Keys<Scene>& titleKeys() {
  static const Keys<Scene> keys{
      key("title", &Scene::title, text(kLongestTitle),
          {.meaning = "stored in the clip, shown by the overlay `caption`",
           .byDefault = "the file's name"}),
      key("caption", &Scene::caption, lines(kLongestCaption),
          {.meaning = "likewise", .byDefault = "empty"}),
  };
  return keys;
}

const Keys<ClipSettings>& clipKeys() {
  static const Keys<ClipSettings> keys{
      {"size",
       readPictureSize,
       pictureSizeText,
       {.comment = "pixels, width and height, even",
        .meaning = "each even, 16 to 16384 [pixels]",
        .allowed = kPictureSizes}},
      key("fps", &ClipSettings::frameRate,
          Kind<FrameRate>{frameRateFrom, frameRateText, kFrameRates},
          {.comment = "frames a second", .meaning = "of the video [frames/s]"}),
      key("duration", &ClipSettings::duration, number(kDurations),
          {.comment = "s of video", .meaning = "of the video [s]"}),
      key("poster", &ClipSettings::poster, number(kTimes),
          {.comment = "s, time of the poster in the video",
           .meaning = "time of the poster, the picture that represents the clip [s]",
           .byDefault = "the clip's middle"}),
      key("speed", &ClipSettings::speed, Kind<PlaybackSpeed>{speedFrom, speedText, kExpectedSpeeds},
          {.comment = "of the motion in the video; 0.25 is slow motion",
           .meaning = "of the motion in the video: 0.25 is slow motion, four times as long; "
                      "see [slow motion](#slow-motion)",
           .byDefault = "as `time_per_frame` says"}),
  };
  return keys;
}

const Keys<EncodingSettings>& videoKeys() {
  static const Keys<EncodingSettings> keys{
      key("crf", &EncodingSettings::crf, integer(kBestCrf, kWorstCrf),
          {.comment = "1 to 51, smaller is better and takes more space",
           .meaning = "x264's rate factor; smaller is better, in larger files"}),
      key("preset", &EncodingSettings::preset,
          Kind<std::string>{presetFrom, tomlString, kExpectedPresets},
          {.comment = kExpectedPresets, .meaning = "`\"book\"` is made for these clips"}),
      key("threads", &EncodingSettings::threads, integer(1, kMaxThreads),
          {.comment = "encoder threads; another number gives other bytes"}),
  };
  return keys;
}

const Keys<CameraSettings>& cameraKeys() {
  static const Keys<CameraSettings> keys{
      key("position", &CameraSettings::position, vector(kPoints),
          {.comment = "m",
           .meaning = "[m]",
           .byDefault = "such that the whole book is seen in any attitude"}),
      key("target", &CameraSettings::target, vector(kPoints),
          {.comment = "m, the point in the middle of the picture",
           .meaning = "the point in the middle of the picture [m]",
           .byDefault = "the origin"}),
      key("up", &CameraSettings::up, direction(),
          {.meaning = "the direction that is up in the picture", .byDefault = "+y"}),
      key("field_of_view_deg", &CameraSettings::fieldOfViewDeg, number(kAngles),
          {.comment = "degrees, from bottom to top",
           .meaning = "from the picture's bottom to its top"}),
      key("frame", &CameraSettings::frame, oneOf(kFrames),
          {.meaning = "the reference frame that the camera turns with"}),
      key("follow", &CameraSettings::follow, oneOf(kFollows),
          {.meaning = "size: the camera draws back when the body grows"}),
      key("fit", &CameraSettings::fit, oneOf(kFits),
          {.meaning =
               "each: in panels each body is seen from a distance in proportion to its size"}),
  };
  return keys;
}

const Keys<BookSettings>& bookKeys() {
  static const Keys<BookSettings> keys{
      textureKey("front", &BookSettings::front, kTextures),
      textureKey("spine", &BookSettings::spine),
      textureKey("back", &BookSettings::back),
      key("color", &BookSettings::colour, colour(),
          {.comment = "of plain cloth on the sides that are \"builtin\"",
           .meaning = "of plain cloth on the sides that are `\"builtin\"`",
           .byDefault = "that of the built-in pictures"}),
  };
  return keys;
}

const Keys<LookSettings>& lookKeys() {
  static const Keys<LookSettings> keys{
      {"background",
       readBackground,
       backgroundText,
       {.comment = kBackgroundTexts,
        .meaning = "transparent: PNGs with an alpha channel; of a colour: flat",
        .allowed = kBackgroundTexts}},
      key("supersample", &LookSettings::supersample, integer(1, kMaxSupersample),
          {.comment = "1, or 2 to draw with twice as many pixels across and down",
           .meaning = "2 draws twice as many pixels across and down, in four times the time",
           .allowed = "1 or 2"}),
      key("motion_blur", &LookSettings::motionBlur,
          Kind<int>{momentsFrom, [](int moments) { return std::to_string(moments); }, kBlurMoments},
          {.comment = "moments averaged in a picture: " + std::string(kBlurMoments),
           .meaning = "number of moments averaged in a picture"}),
  };
  return keys;
}

const Keys<OverlaySettings>& overlayKeys() {
  static const Keys<OverlaySettings> keys{
      key("show", &OverlaySettings::show,
          Kind<std::vector<Overlay>>{overlaysFrom, overlaysText, {}},
          {.comment = "of " + quotedList(namesOf(kOverlays), "and"),
           .meaning = "drawn over the pictures",
           .allowed = "a list of [overlays](panels-and-overlays.md#overlays)"}),
      key("font", &OverlaySettings::font, text(kLongestName),
          {.comment = "\"builtin\" or an installed family",
           .meaning = "the built-in font is Inter",
           .allowed = "\"builtin\" or an installed family"}),
      key("scale", &OverlaySettings::scale, number(kOverlayScales),
          {.meaning = "size of letters, lines and charts; 1 is the usual one"}),
      key("words", &OverlaySettings::words, Kind<Words>{wordsFrom, wordsText, kExpectedWords},
          {.comment = "\"english\", \"german\", a table or the file of one",
           .meaning = "the words that pictures show, and their `decimal_mark`"}),
  };
  return keys;
}

}  // namespace rotatebook::scene
