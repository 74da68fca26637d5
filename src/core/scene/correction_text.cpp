#include "scene/correction_text.h"

namespace rotatebook::scene {
namespace {

std::string correctionText(const Words& words, Word done, Word notDone, int every) {
  if (every == 0) return words[notDone];
  if (every == 1) return words[done];
  return words[done] + " " + words[Word::Every] + " " + std::to_string(every) + " " +
         words[Word::Steps];
}

}  // namespace

std::vector<std::string> correctionTexts(const physics::SimulationSettings& settings,
                                         const Words& words) {
  const bool isOfParticles = settings.model == physics::Model::Particles;
  const int energy = isOfParticles ? settings.energyEvery() : settings.normalizeEvery;
  const int drift = isOfParticles ? settings.driftEvery() : settings.normalizeEvery;
  if (energy == drift) {
    return {correctionText(words, Word::Normalised, Word::NotNormalised, energy)};
  }
  return {correctionText(words, Word::EnergyNormalised, Word::EnergyNotNormalised, energy),
          correctionText(words, Word::DriftRemoved, Word::DriftNotRemoved, drift)};
}

}  // namespace rotatebook::scene
