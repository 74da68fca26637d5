// The keys of a scene file, section by section. A new key is a row in this folder and a field of
// the struct. Inside the room only.
#pragma once

#include <string>
#include <vector>

#include "scene/keys/key.h"
#include "scene/scene.h"

namespace rotatebook::scene {

/// Keys outside all sections.
Keys<Spec> titleKeys();

Keys<physics::MotionSettings> bodyKeys();
Keys<physics::SimulationSettings> simulationKeys();
Keys<physics::InitialSpin> initialKeys();
Keys<physics::Nudge> nudgeKeys();
/// Keys of a panel itself, without its sections.
Keys<Panel> panelKeys();

Keys<ClipSettings> clipKeys();
Keys<Cue> cueKeys();
Keys<CameraMove> cameraMoveKeys();
Keys<EncodingSettings> videoKeys();
Keys<CameraSettings> cameraKeys();
Keys<BookSettings> bookKeys();
Keys<LookSettings> lookKeys();
Keys<OverlaySettings> overlayKeys();

/// Keys of [study].
Keys<StudySettings> studyKeys();

/// Keys of [map].
Keys<MapSettings> mapKeys();

/// Keys of [grid].
Keys<GridSettings> gridKeys();

}  // namespace rotatebook::scene
