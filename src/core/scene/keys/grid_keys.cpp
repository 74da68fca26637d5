// The keys of [grid]: its axes, and what must come out.
#include "scene/keys/axis_keys.h"
#include "scene/keys/expectation_keys.h"
#include "scene/keys/keys.h"

namespace rotatebook::scene {

Keys<GridSettings> gridKeys() {
  static constexpr std::array keys{
      valueAxis<&GridSettings::columns>(
          "columns",
          {.meaning = "the key that each column has another value of, see [axes](vary.md#axes)",
           .byDefault = "one column"}),
      valueAxis<&GridSettings::rows>("rows",
                                     {.meaning = "likewise of each row", .byDefault = "one row"}),
      placedExpectations<&GridSettings::expected, kGridExpectations>(
          "expect",
          {.meaning = "[bounds](vary.md#expectations) on the motions of a `column`, of a `row`, or "
                      "of a cell, which is in both",
           .byDefault = "none",
           .affects = Affects::Text}),
  };
  return keys;
}

}  // namespace rotatebook::scene
