// The section [[cue]]: what a clip says, and where it stands, in the course of its motion.
#include <string>
#include <vector>

#include "base/document/problems.h"
#include "scene/keys/keys.h"
#include "scene/keys/kinds.h"
#include "scene/sections.h"

namespace rotatebook::scene {
namespace {

Cue cueFrom(const ValueReader& table) {
  Cue cue;
  readKeys(table, cueKeys(), cue);
  if (!cue.text && cue.hold == 0 && cue.chapter.empty() && !cue.move)
    table.fail("[[cue]] needs text, hold, chapter or move");
  if (cue.move && !cue.move->position && !cue.move->target && !cue.move->fieldOfViewDeg &&
      cue.move->orbit == 0)
    table.fail("cue.move needs position, target, field_of_view_deg or orbit");
  return cue;
}

void readCues(const ValueReader& value, Spec& spec) {
  spec.cues = tablesFrom(value, "tables with the header [[cue]]", cueFrom);
  if (spec.cues.size() <= kMaxCues) return;
  value.fail("a scene has up to " + std::to_string(kMaxCues) + " cues, not " +
             std::to_string(spec.cues.size()));
}

/// Of those for the motion, only the ones at which it stands.
std::vector<std::string> cueTables(const Spec& spec, const Printed& printed) {
  std::vector<std::string> tables;
  for (const Cue& cue : spec.cues) {
    if (printed.ofMotion && cue.hold == 0) continue;
    tables.push_back(linesOf(cueKeys(), cue, printed));
  }
  return tables;
}

}  // namespace

Section<Spec> cueSection() {
  return {"cue", readCues, {}, rowsOf("cue.N.", cueKeys()), cueTables};
}

}  // namespace rotatebook::scene
