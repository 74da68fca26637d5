// The keys of [grid]: its axes, and what must come out.
#include "scene/keys/axis_keys.h"
#include "scene/keys/expectation_keys.h"
#include "scene/keys/keys.h"

namespace rotatebook::scene {

const Keys<GridSettings>& gridKeys() {
  static const Keys<GridSettings> keys{
      key("columns", &GridSettings::columns, valueAxis(),
          {.meaning = "the key that each column has another value of, see [axes](vary.md#axes)",
           .byDefault = "one column"}),
      key("rows", &GridSettings::rows, valueAxis(),
          {.meaning = "likewise of each row", .byDefault = "one row"}),
      key("expect", &GridSettings::expected, kGridExpectations.kind(),
          {.meaning = "[bounds](vary.md#expectations) on the motions of a `column`, of a `row`, or "
                      "of a cell, which is in both",
           .byDefault = "none",
           .affects = Affects::Text}),
  };
  return keys;
}

}  // namespace rotatebook::scene
