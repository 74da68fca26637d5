// Verifies that pictures have no word but those of scene::Words and the scene's own.
#include <algorithm>
#include <dlfcn.h>
#include <filesystem>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "overlay/caption_and_clock.h"
#include "overlay/motion.h"
#include "overlay/panel_heads.h"
#include "physics/integrators/integrator_table.h"
#include "scene/shipped_scene.h"

namespace {

/// The texts that Pango sets while this exists, one at a time.
struct Recording {
  Recording() { present = this; }
  ~Recording() { present = nullptr; }

  static inline Recording* present = nullptr;
  std::vector<std::string> texts{};
};

}  // namespace

// Takes the place of Pango's function, through which each text goes, in this program.
extern "C" void pango_layout_set_text(void* layout, const char* text, int length) {
  if (Recording::present != nullptr && length > 0) {
    Recording::present->texts.emplace_back(text, text + length);
  }
  using Function = void (*)(void*, const char*, int);
  reinterpret_cast<Function>(dlsym(RTLD_NEXT, "pango_layout_set_text"))(layout, text, length);
}

namespace rotatebook::overlay {
namespace {

namespace fs = std::filesystem;

/// "«7______»" in place of word 7, about as long as in English.
std::string markerOf(std::size_t word) {
  return "«" + std::to_string(word) + std::string(scene::kEnglishWords[word].size(), '_') + "»";
}

/// Words that are all markers, and a decimal mark that no number of the program has by itself.
scene::Words markers() {
  scene::Words words;
  for (std::size_t i = 0; i < words.texts.size(); ++i) words.texts[i] = markerOf(i);
  words.decimalMark = "·";
  return words;
}

/// Numbers, units, quantities, axes and the proper names of integrators, which are the same in all
/// languages.
bool isInternational(const std::string& part) {
  static const std::set<std::string> kSame{
      "s",       "ms",   "N",    "m",    "t",      "k",     "E",   "T",         "U",
      "ω",       "L",    "x",    "y",    "z",      "euler", "rk4", "lie-euler", "cf4",
      "suzuki4", "dmv2", "dmv4", "dmv6", "verlet", "kg",    "m²"};
  static const std::regex kNumber("[0-9]+(·[0-9]+)?(e[-+]?[0-9]+)?");
  return kSame.contains(part) || std::regex_match(part, kNumber);
}

/// Returns the parts of `text` that are neither markers nor international.
std::string foreignParts(const std::string& text) {
  static const std::regex kBetween("«[0-9]+_*»|[ ,;=/%]|\u00a0|°|\u00d7|−|\\+|₀");
  static const std::regex kExponent("([0-9])e\\+");  // Its sign stands between nothing.
  const std::string unsignedOnes = std::regex_replace(text, kExponent, "$1e");
  std::istringstream parts(std::regex_replace(unsignedOnes, kBetween, " "));
  std::string foreign;
  for (std::string part; parts >> part;) {
    if (!isInternational(part)) foreign += part + " ";
  }
  return foreign;
}

/// The texts that are set for the pictures of `scene`: of its first frames, and of its end as if it
/// diverged.
std::vector<std::string> textsOf(const scene::Scene& scene) {
  constexpr int kFrames = 3;
  using Position = CaptionAndClock::ClockPosition;
  Recording recording;
  image::Image picture = testing::greyPicture(scene);
  CaptionAndClock caption(scene, !scene.hasPanels() ? Position::TopLeft : Position::Bottom);
  std::vector<physics::Trajectory> motions;
  for (const scene::Panel& panel : scene.motions) {
    const scene::Scene single = scene::withMotion(scene, panel);
    physics::Trajectory motion = physics::simulate(single.motions[0], kFrames);
    motion.divergedAt = 1.25;
    motions.push_back(motion);
    MotionOverlays overlays = testing::overlaysOf(single, motion);
    for (std::int64_t frame = 0; frame <= kFrames; ++frame) {
      overlays.draw(frame, testing::clipFromWorld(single, overlays.bottomRows()), picture);
    }
  }
  for (std::int64_t frame = 0; frame <= kFrames; ++frame) caption.draw(frame, picture);
  if (scene.hasPanels()) {
    PanelCells cells{scene.clip.width, scene.clip.height};
    cells.corners.resize(scene.motions.size(), Point(0, 0));
    PanelHeads(scene, motions, cells).draw(kFrames, picture);
  }
  return recording.texts;
}

/// Adds the texts of `scene` with markers to `seen`, and expects that there are no other words.
void expectNoOtherWords(scene::Scene scene, std::set<std::string>& seen) {
  scene.overlay.words = markers();
  std::set<std::string> own{scene.title, scene.caption};
  for (const scene::Panel& panel : scene.motions) own.insert(panel.label);
  for (const scene::Cue& cue : scene.cues) own.insert(cue.text.value_or(""));
  for (const std::string& text : textsOf(scene)) {
    if (own.contains(text)) continue;
    EXPECT_EQ(foreignParts(text), "") << scene.name << ": " << text;
    seen.insert(text);
  }
}

std::vector<scene::Scene> shippedScenes() {
  std::vector<scene::Scene> scenes;
  const fs::path folder = fs::path(ROTATEBOOK_SOURCE) / "scenes";
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.path().extension() != ".toml") continue;
    const fs::path name = entry.path().lexically_relative(folder).replace_extension();
    scenes.push_back(scene::shippedScene(name.string()));
  }
  return scenes;
}

/// Scenes that have words which those that ship lack.
std::vector<scene::Scene> rareScenes() {
  std::vector<scene::Scene> scenes{
      testing::tumbling({"clip.size=[180, 320]", "overlay.show=['error']"}),
      testing::tumbling({"camera.frame='body'", "overlay.show=['forces']"})};
  for (const char* kept : {"simulation.normalize_energy", "simulation.remove_drift"}) {
    scenes.push_back(testing::tumbling(
        {"simulation.model=particles", "simulation.integrator=verlet", "simulation.normalize=false",
         std::string(kept) + "={ every = 100 }", "overlay.show=['settings']"}));
  }
  for (const physics::IntegratorRow& row : physics::integratorTable()) {
    const bool isRigid = physics::steppingOf(physics::Model::Quaternion, row.integrator) != nullptr;
    scenes.push_back(testing::tumbling(
        {std::string("simulation.model=") + (isRigid ? "quaternion" : "particles"),
         "simulation.integrator=" + std::string(row.word), "overlay.show=['settings']"}));
  }
  return scenes;
}

TEST(Words, OfPicturesAreThoseOfTheTable) {
  std::set<std::string> seen;
  for (const scene::Scene& scene : rareScenes()) expectNoOtherWords(scene, seen);
  for (scene::Scene& scene : shippedScenes()) {
    expectNoOtherWords(scene, seen);
    for (const auto& overlay : scene::kOverlayRows) {
      if (!shows(scene, overlay.overlay)) scene.overlay.show.push_back(overlay.overlay);
    }
    expectNoOtherWords(scene, seen);
  }
  // Each word is on some picture, but for those of events, which are in WebVTT
  const std::set<std::string_view> ofEvents{"flip", "nudge", "burst"};
  const scene::Words words = markers();
  for (std::size_t i = 0; i < words.texts.size(); ++i) {
    const auto has = [&](const std::string& text) {
      return text.find(words.texts[i]) != text.npos;
    };
    if (ofEvents.contains(scene::kEnglishWords[i])) continue;
    EXPECT_TRUE(std::ranges::any_of(seen, has)) << scene::kEnglishWords[i] << " is nowhere";
  }
}

TEST(Words, ThatAreInNoTableAreFound) {
  EXPECT_EQ(foreignParts("«0» 3"), "");
  EXPECT_EQ(foreignParts("«21_____», rk4, «14», k = 2000 N/m, «24» 0·26 ms; «10»"), "");
  EXPECT_EQ(foreignParts("Flips 3"), "Flips ");
  EXPECT_EQ(foreignParts("t = 0.26 s"), "0.26 ");
  EXPECT_EQ(foreignParts("«3» / initial"), "initial ");
}

}  // namespace
}  // namespace rotatebook::overlay
