// What the rows of keys say of their effects is held against motions that are simulated: what
// fingerprints leave out, and what studies, grids and maps may vary, follows from the rows.
#include <map>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "base/error.h"
#include "base/number_text.h"
#include "scene/key_rows.h"
#include "scene/names.h"
#include "scene/scene_text.h"
#include "timeline/motion_checksum.h"
#include "timeline/simulate_scene.h"

namespace rotatebook::timeline {
namespace {

using physics::Model;
using scene::Affects;
using scene::KeyRow;
using Type = scene::ValueForm::Type;

/// Values of keys with a form of their own, as --set takes them.
const std::map<std::string, std::string> kOwnValues{
    {"body.inertia", "[0.01, 0.02, 0.025]"},
    {"body.shape", "'box'"},
    {"body.dimensions", "{ x = 0.3 }"},
    {"simulation.integrator", "'euler'"},
    {"simulation.normalize", "{ every = 7 }"},
    {"simulation.normalize_energy", "{ every = 7 }"},
    {"simulation.remove_drift", "{ every = 7 }"},
    {"simulation.particles", "'equimomental'"},
    {"initial.tilt", "[0.3, 'y']"},
    {"initial.attitude", "[0.9, 0.1, 0.2, 0.3]"},
    {"cue.N.at", "0.1"},
    {"cue.N.move", "{ orbit = 1 }"},
    {"clip.size", "[64, 36]"},
    {"clip.fps", "24"},
    {"clip.speed", "0.5"},
    {"video.preset", "'medium'"},
    {"book.front", "'x.png'"},
    {"book.spine", "'x.png'"},
    {"book.back", "'x.png'"},
    {"book.color", "'#102030'"},
    {"look.background", "'stars'"},
    {"look.motion_blur", "4"},
    {"look.body", "false"},
    {"overlay.band", "false"},
    {"overlay.show", "['clock']"},
    {"overlay.words", "'german'"},
    {"panel.N.label", "'other'"},
};

std::vector<std::string> valuesFor(const KeyRow& row) {
  switch (row.form.type) {
    case Type::Own:
      return kOwnValues.contains(row.name) ? std::vector{kOwnValues.at(row.name)}
                                           : std::vector<std::string>{};
    case Type::Integer:
      return {"2", "3"};
    case Type::Number:
      return {"0.05", "0.75", "40.0"};
    case Type::Vector:
      return {"[0.2, 0.5, 0.06]"};
    case Type::Text:
      return {"'other'"};
    case Type::Choice:
      break;
  }
  std::vector<std::string> values;
  for (const std::string_view choice : row.form.choices)
    values.push_back("'" + std::string(choice) + "'");
  return values;
}

scene::Scene sceneOf(const std::string& model, const std::vector<std::string>& more) {
  const std::string text = "simulation.model = '" + model +
                           "'\nclip.duration = 0.2\noverlay.show = []\n"
                           "[[cue]]\nat = 0.05\ntext = 'a'\nhold = 0.05\n[[nudge]]\nat = "
                           "0.1\nangular_velocity = [1, 2, 3]\n"
                           "[initial]\nangular_velocity = [5, 0.2, 1]\n";
  return scene::parseScene(text, "a.toml", more);
}

struct Effects {
  std::string scene, motionText, checksum;
};

Effects effectsOf(const scene::Scene& scene) {
  return {sceneText(scene), motionText(scene), motionChecksum(simulateScene(scene))};
}

/// What was seen of a key.
struct Seen {
  bool isTaken = false;
  std::set<Model> changed{};  ///< Models whose motion it changed.
};

Seen lookAt(const KeyRow& row) {
  Seen seen;
  std::string name = row.name;
  if (const auto element = name.find(".N."); element != name.npos) name.replace(element, 3, ".0.");
  for (const auto& [word, model] : scene::kModels) {
    if (model == Model::Recorded) continue;
    const Effects before = effectsOf(sceneOf(std::string(word), {}));
    for (const std::string& value : valuesFor(row)) {
      SCOPED_TRACE(name + "=" + value);
      Effects after;
      try {
        after = effectsOf(sceneOf(std::string(word), {name + "=" + value}));
      } catch (const InputError&) {
        continue;
      }
      if (after.scene == before.scene) continue;
      seen.isTaken = true;
      EXPECT_EQ(after.motionText != before.motionText, row.affects == Affects::Motion);
      if (after.checksum != before.checksum) seen.changed.insert(model);
    }
  }
  return seen;
}

/// Keys of which a single motion of a book has none, or that need a file.
bool isOfOthers(const KeyRow& row) {
  static const std::set<std::string> kOthers{"body.dimensions", "body.mesh",
                                             "body.unit",       "body.density",
                                             "body.part",       "nudge.N.angular_momentum"};
  const std::string section = row.name.substr(0, row.name.find('.'));
  return kOthers.contains(row.name) || row.name.starts_with("body.part.") ||
         std::set<std::string>{"expect", "panel", "grid", "study", "map"}.contains(section) ||
         row.models == scene::kOfRecorded;
}

TEST(KeyEffects, AreThoseThatTheRowsState) {
  for (const KeyRow& row : scene::allKeys()) {
    if (isOfOthers(row)) continue;
    SCOPED_TRACE(row.name);
    const Seen seen = lookAt(row);
    EXPECT_TRUE(seen.isTaken) << "add a value to kOwnValues";
    if (row.affects != Affects::Motion) {
      EXPECT_TRUE(seen.changed.empty()) << "its row is to say that it affects the motion";
      continue;
    }
    EXPECT_FALSE(seen.changed.empty());
    for (const auto& [word, model] : scene::kModels) {
      if (model == Model::Recorded || row.models.have(model)) continue;
      EXPECT_FALSE(seen.changed.contains(model)) << word << ": its row is to name that model, too";
    }
  }
}

}  // namespace
}  // namespace rotatebook::timeline
