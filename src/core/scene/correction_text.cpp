#include "scene/correction_text.h"

namespace rotatebook::scene {
namespace {

std::string correctionText(const std::string& done, const std::string& notDone, int every) {
  if (every == 0) return notDone;
  return every == 1 ? done : done + " every " + std::to_string(every) + " steps";
}

}  // namespace

std::vector<std::string> correctionTexts(const physics::SimulationSettings& settings) {
  const bool isOfParticles = settings.model == physics::Model::Particles;
  const int energy = isOfParticles ? settings.energyEvery() : settings.normalizeEvery;
  const int drift = isOfParticles ? settings.driftEvery() : settings.normalizeEvery;
  if (energy == drift) return {correctionText("normalised", "not normalised", energy)};
  return {correctionText("energy normalised", "energy not normalised", energy),
          correctionText("drift removed", "drift not removed", drift)};
}

}  // namespace rotatebook::scene
