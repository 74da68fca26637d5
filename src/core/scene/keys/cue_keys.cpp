// The keys of [[cue]]: captions in time, holds and chapters.
#include "scene/keys/keys.h"
#include "scene/keys/kinds.h"
#include "scene/keys/moments.h"
#include "scene/limits.h"

namespace rotatebook::scene {
namespace {

constexpr NumberRange kHolds{"a time of the video, 0 or more seconds", 0, document::kPositive.max,
                             Dimension::Time};

}  // namespace

Keys<Cue> cueKeys() {
  static constexpr std::array keys{
      own<&Cue::at, momentFrom, momentText>(
          "at", kExpectedMoments,
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
  };
  return keys;
}

}  // namespace rotatebook::scene
