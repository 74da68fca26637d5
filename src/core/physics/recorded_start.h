// Motions that are taken from a recording.
#pragma once

#include <memory>
#include <string>

#include "physics/motion_settings.h"

namespace rotatebook::physics {

/// Makes `settings` the motion of a recording, called `name` in messages, with the exact motion
/// from its first moment. Throws InputError if the body is at rest then.
void takeRecording(MotionSettings& settings,
                   std::shared_ptr<const recording::RecordedMotion> recording,
                   const std::string& name);

}  // namespace rotatebook::physics
