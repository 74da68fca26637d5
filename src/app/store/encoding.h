// How a scene's videos are encoded.
#pragma once

#include <string>

#include "scene/scene.h"
#include "video/video_settings.h"

namespace rotatebook::store {

/// Settings of the videos' encoders. `record` goes into the videos' metadata.
video::VideoSettings videoSettings(const scene::Scene& scene, const std::string& record);

}  // namespace rotatebook::store
