// Settings of the encoders of a scene's videos.
#pragma once

#include <string>

#include "scene/scene.h"
#include "video/video_settings.h"

namespace rotatebook::store {

/// Returns the encoder settings that `scene` asks for; `record` becomes the video's comment.
video::VideoSettings videoSettings(const scene::Scene& scene, const std::string& record);

}  // namespace rotatebook::store
