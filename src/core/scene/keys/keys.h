// The keys of a scene file, section by section. A new key is a row in this folder and a field of
// the struct. Inside the room only.
#pragma once

#include <string>
#include <vector>

#include "scene/keys/key.h"
#include "scene/scene.h"

namespace rotatebook::scene {

/// Keys outside all sections.
const Keys<Scene>& titleKeys();

const Keys<physics::MotionSettings>& bodyKeys();
const Keys<physics::SimulationSettings>& simulationKeys();
const Keys<physics::InitialSpin>& initialKeys();
const Keys<physics::Nudge>& nudgeKeys();
/// Keys of a panel itself, without its sections.
const Keys<Panel>& panelKeys();

const Keys<ClipSettings>& clipKeys();
const Keys<EncodingSettings>& videoKeys();
const Keys<CameraSettings>& cameraKeys();
const Keys<BookSettings>& bookKeys();
const Keys<LookSettings>& lookKeys();
const Keys<OverlaySettings>& overlayKeys();

/// Keys of Scene::study, which must be present, that studies of all kinds have.
const Keys<Scene>& samplingKeys();
/// Keys of Scene::study, which must be present, but for its sweep; they depend on the scene's
/// model.
const Keys<Scene>& studyKeys();
/// The keys of Scene::study's sweep; to read them, it must be present.
const Keys<Scene>& sweepKeys();

/// Keys of [map].
const Keys<MapSettings>& mapKeys();

/// Keys of [grid].
const Keys<GridSettings>& gridKeys();

/// Returns the lines of study.orders, one for each integrator.
std::string ordersText(const StudySettings& study);

}  // namespace rotatebook::scene
