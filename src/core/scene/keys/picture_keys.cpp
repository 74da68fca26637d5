// The keys of the title, [video], [camera], [book], [look] and [overlay]: how the motion is
// shown.
#include <algorithm>
#include <array>
#include <bit>
#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "base/clip_limits.h"
#include "scene/keys/keys.h"
#include "scene/keys/kinds.h"
#include "scene/sections.h"

namespace rotatebook::scene {
namespace {

using document::TomlNode;

constexpr int kMaxThreads = 64;
constexpr int kMaxSupersample = 2;
constexpr unsigned kMaxMoments = 16;  // For motion blur.

constexpr const char* kExpectedPresets = "\"book\" or x264's \"ultrafast\" to \"placebo\"";
constexpr const char* kTextures = "\"builtin\" or a path relative to the scene's folder";
constexpr const char* kBackgroundTexts =
    "\"studio\", \"stars\", \"transparent\", \"white\", \"black\" or a colour such as \"#2b5d8a\"";
constexpr const char* kBlurMoments = "1, 2, 4, 8 or 16";

constexpr NumberRange kPoints{"three numbers from -1e9 to 1e9", -1e9, 1e9, Dimension::Length};
constexpr NumberRange kOverlayScales{"a number from 0.5 to 3", 0.5, 3};
constexpr NumberRange kAngles{"an angle from 1 to 170 degrees", 1, 170};

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

template <auto kTexture>
constexpr Key<BookSettings> textureKey(std::string_view name, std::string_view comment = "") {
  return own<kTexture, textureFrom, tomlString>(
      name, kTextKind, kTextures, {.comment = comment, .meaning = "a PNG, JPEG or WebP"});
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
    std::vector<std::string_view> names{"white", "black"};
    std::ranges::copy(namesOf(kBackgrounds), std::back_inserter(names));
    value.fail(value.name() + " must be " + kBackgroundTexts + ", not " + describe(value.node()) +
               didYouMean(*text, names));
  }
  look.background = named->value;
}

std::string backgroundText(const LookSettings& look) {
  if (look.background == Background::Plain) return tomlString(textOf(look.plainColour));
  return quotedName(kBackgrounds, look.background);
}

// Accepts only powers of two, by which times divide without rounding: blurred or not, the motion is
// the same.
int blurMomentsFrom(const ValueReader& value) {
  const int moments = value.integer(1, kMaxMoments);
  if (!std::has_single_bit(static_cast<unsigned>(moments))) value.mismatch(kBlurMoments);
  return moments;
}

std::string flagText(bool flag) {
  return flag ? "true" : "false";
}

std::vector<Overlay> overlaysFrom(const ValueReader& value) {
  const auto* array = std::get_if<TomlNode::Array>(&value.node().value);
  if (array == nullptr) value.mismatch("a list of overlays, such as [\"caption\", \"clock\"]");
  std::vector<Overlay> overlays;
  readEach(value.elements(array->size(), "a list of overlays"), [&](const ValueReader& element) {
    const auto overlay = choiceFrom(element, kOverlays);
    if (std::ranges::count(overlays, overlay) > 0) {
      element.fail(element.name() + " has " + std::string(nameOf(kOverlays, overlay)) + " twice");
    }
    overlays.push_back(overlay);
  });
  return overlays;
}

std::string overlaysText(const std::vector<Overlay>& overlays) {
  return listText(overlays, [](Overlay overlay) { return quotedName(kOverlays, overlay); });
}

constexpr std::string_view kDecimalMark = "decimal_mark";
constexpr const char* kExpectedWords =
    "\"english\", \"german\", a table of words, such as { \"Flips\" = \"Retournements\" }, or a "
    "TOML file of one, such as \"french.words\"";
Words wordsFrom(const ValueReader& value) {
  if (const auto* language = std::get_if<std::string>(&value.node().value)) {
    if (*language == kLanguages[0]) return {};
    if (*language == kLanguages[1]) return germanWords();
    value.fail(value.name() + " must be " + kExpectedWords + ", not " + describe(value.node()) +
               didYouMean(*language, kLanguages));
  }
  if (!std::holds_alternative<TomlNode::Table>(value.node().value)) value.mismatch(kExpectedWords);
  return readWords(value);
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

std::string captionFrom(const ValueReader& value, const ValueForm& form) {
  if (!std::holds_alternative<TomlNode::Array>(value.node().value)) return linesFrom(value, form);
  value.fail(
      "caption is the text from the beginning on; those that follow are in [[cue]]: at and "
      "text");
}

}  // namespace

Keys<Spec> titleKeys() {
  static constexpr auto keys = allOf(
      Affects::Text,
      std::array{
          text<&Spec::title>("title", kLongestTitle,
                             {.meaning = "stored in the clip, shown by the overlay `caption`",
                              .byDefault = "the file's name"}),
          key<&Spec::caption, captionFrom, tomlString>(
              "caption", textForm(kLongestCaption), {.meaning = "likewise", .byDefault = "empty"}),
      });
  return keys;
}

Keys<EncodingSettings> videoKeys() {
  static constexpr auto keys =
      allOf(Affects::Picture,
            std::array{
                integer<&EncodingSettings::crf>(
                    "crf", kBestCrf, kWorstCrf,
                    {.comment = "1 to 51, smaller is better and takes more space",
                     .meaning = "x264's rate factor; smaller is better, in larger files"}),
                own<&EncodingSettings::preset, presetFrom, tomlString>(
                    "preset", kTextKind, kExpectedPresets,
                    {.comment = kExpectedPresets, .meaning = "`\"book\"` is made for these clips"}),
                integer<&EncodingSettings::threads>(
                    "threads", 1, kMaxThreads,
                    {.comment = "encoder threads; another number gives other bytes"}),
            });
  return keys;
}

Keys<CameraSettings> cameraKeys() {
  static constexpr auto keys = allOf(
      Affects::Picture,
      std::array{
          vector<&CameraSettings::position>(
              "position", kPoints,
              {.comment = "m",
               .meaning = "where it is",
               .byDefault = "such that the whole book is seen in any attitude"}),
          vector<&CameraSettings::target>("target", kPoints,
                                          {.comment = "m, the point in the middle of the picture",
                                           .meaning = "the point in the middle of the picture",
                                           .byDefault = "the origin"}),
          direction<&CameraSettings::up>(
              "up", {.meaning = "the direction that is up in the picture", .byDefault = "+y"}),
          number<&CameraSettings::fieldOfViewDeg>(
              "field_of_view_deg", kAngles,
              {.comment = "degrees, from bottom to top",
               .meaning = "from the picture's bottom to its top",
               .unit = "degrees"}),
          choice<&CameraSettings::frame, kFrames>(
              "frame", {.meaning = "the reference frame that the camera turns with"}),
          choice<&CameraSettings::follow, kFollows>(
              "follow", {.meaning = "size: the camera draws back when the body grows"}),
          choice<&CameraSettings::fit, kFits>(
              "fit",
              {.meaning =
                   "each: in panels each body is seen from a distance in proportion to its size"}),
      });
  return keys;
}

Keys<CameraMove> cameraMoveKeys() {
  static constexpr NumberRange kOrbits{"an angle from -1000 to 1000 rad", -1000, 1000,
                                       Dimension::Angle};
  static constexpr NumberRange kMoves{"a time of the video, more than 0 s", document::kPositive.min,
                                      document::kPositive.max, Dimension::Time};
  static constexpr auto keys =
      allOf(Affects::Picture, std::array{
                                  vector<&CameraMove::position>("position", kPoints),
                                  vector<&CameraMove::target>("target", kPoints),
                                  number<&CameraMove::fieldOfViewDeg>("field_of_view_deg", kAngles),
                                  number<&CameraMove::orbit>("orbit", kOrbits),
                                  number<&CameraMove::over>("over", kMoves),
                              });
  return keys;
}

Keys<BookSettings> bookKeys() {
  static constexpr auto keys =
      allOf(Affects::Picture,
            std::array{
                textureKey<&BookSettings::front>("front", kTextures),
                textureKey<&BookSettings::spine>("spine"),
                textureKey<&BookSettings::back>("back"),
                colour<&BookSettings::colour>(
                    "color", {.comment = "of plain cloth on the sides that are \"builtin\"",
                              .meaning = "of plain cloth on the sides that are `\"builtin\"`",
                              .byDefault = "that of the built-in pictures"}),
            });
  return keys;
}

Keys<LookSettings> lookKeys() {
  static constexpr auto keys = allOf(
      Affects::Picture,
      std::array{
          keyOf<LookSettings, readBackground, backgroundText>(
              "background", ownForm(kTextKind, kBackgroundTexts),
              {.comment = kBackgroundTexts,
               .meaning = "transparent: PNGs with an alpha channel; of a colour: flat"}),
          integer<&LookSettings::supersample>(
              "supersample", 1, kMaxSupersample,
              {.comment = "1, or 2 to draw with twice as many pixels across and down",
               .meaning = "2 draws twice as many pixels across and down, in four times the time",
               .allowed = "1 or 2"}),
          own<&LookSettings::motionBlur, blurMomentsFrom, integerText>(
              "motion_blur", kNumberKind, kBlurMoments,
              {.comment = "moments averaged in a picture: 1, 2, 4, 8 or 16",
               .meaning = "number of moments averaged in a picture"}),
          own<&LookSettings::body, flagFrom, flagText>(
              "body", {.flag = true}, kFlags,
              {.meaning = "false: no bodies, only what is drawn over them"}),
      });
  return keys;
}

Keys<OverlaySettings> overlayKeys() {
  static constexpr auto keys =
      allOf(Affects::Picture,
            std::array{
                key<&OverlaySettings::show, overlaysFrom, overlaysText>(
                    "show", {.choices = kNamesOf<kOverlays>, .kinds = kListKind},
                    {.meaning = "drawn over the pictures",
                     .allowed = "a list of [overlays](panels-and-overlays.md#overlays)"}),
                text<&OverlaySettings::font>("font", kLongestName,
                                             {.comment = "\"builtin\" or an installed family",
                                              .meaning = "the built-in font is Inter",
                                              .allowed = "\"builtin\" or an installed family"}),
                number<&OverlaySettings::scale>(
                    "scale", kOverlayScales,
                    {.meaning = "size of letters, lines and charts; 1 is the usual one"}),
                own<&OverlaySettings::words, wordsFrom, wordsText>(
                    "words", {.text = true, .table = true}, kExpectedWords,
                    {.comment = "\"english\", \"german\", a table or the file of one",
                     .meaning = "the words that pictures show, and their `decimal_mark`"}),
                own<&OverlaySettings::band, flagFrom, flagText>(
                    "band", {.flag = true}, kFlags,
                    {.meaning = "false: the text at the bottom has no dark ground"}),
            });
  return keys;
}

}  // namespace rotatebook::scene
