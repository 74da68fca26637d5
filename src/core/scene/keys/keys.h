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

/// Keys of [study].
const Keys<StudySettings>& studyKeys();

/// Keys of [map].
const Keys<MapSettings>& mapKeys();

/// Keys of [grid].
const Keys<GridSettings>& gridKeys();

}  // namespace rotatebook::scene
