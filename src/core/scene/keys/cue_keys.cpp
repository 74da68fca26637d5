// The keys of [[cue]]: captions in time, holds, chapters and moves of the camera.
#include "scene/keys/keys.h"
#include "scene/keys/kinds.h"
#include "scene/keys/moments.h"
#include "scene/limits.h"

namespace rotatebook::scene {
namespace {

constexpr NumberRange kHolds{"a time of the video, 0 or more seconds", 0, document::kPositive.max,
                             Dimension::Time};

constexpr const char* kExpectedMove =
    "a table such as { orbit = \"90 deg\", over = 3 }, with position, target, field_of_view_deg, "
    "orbit and over";

CameraMove moveFrom(const ValueReader& value) {
  CameraMove move;
  readKeys(value, cameraMoveKeys(), move);
  return move;
}

std::string moveText(const CameraMove& move) {
  return inlineTable(cameraMoveKeys(), move);
}

}  // namespace

Keys<Cue> cueKeys() {
  static constexpr std::array keys{
      own<&Cue::at, momentFrom, momentText>(
          "at", kNumberOrText, kExpectedMoments,
          {.comment = "s of the motion, or an event of it",
           .meaning = "from when on, see [captions in time](#captions-in-time)"}),
      lines<&Cue::text>("text", kLongestCaption,
                        {.meaning = "the caption until the next one; `\"\"` is none",
                         .byDefault = "that before",
                         .affects = Affects::Text}),
      number<&Cue::hold>("hold", kHolds,
                         {.comment = "s of video for which the motion stands",
                          .meaning = "for so long the motion stands, in the video"}),
      key<&Cue::chapter, textFrom, optionalText>("chapter", textForm(kLongestChapter),
                                                 {.meaning = "name of the chapter that begins",
                                                  .byDefault = "none begins",
                                                  .affects = Affects::Text}),
      key<&Cue::move, moveFrom, moveText>(
          "move", tableForm(kTableKind, kExpectedMove, membersOf<cameraMoveKeys>),
          {.meaning = "a move of the camera that begins, see [moves](#moves-of-the-camera)",
           .byDefault = "none",
           .affects = Affects::Picture}),
  };
  return keys;
}

}  // namespace rotatebook::scene
