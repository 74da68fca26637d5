// Settings of the encoders of a scene's videos.
#pragma once

#include <string>
#include <vector>

#include "scene/scene.h"
#include "video/video_settings.h"

namespace rotatebook::store {

/// Returns the chapters that the scene's cues begin.
std::vector<video::Chapter> chaptersOf(const scene::Scene& scene);

/// Returns the encoder settings that `scene` asks for; `record` becomes the video's comment. The
/// video of a whole clip has chapters.
video::VideoSettings videoSettings(const scene::Scene& scene, const std::string& record,
                                   bool isWhole = true);

}  // namespace rotatebook::store
