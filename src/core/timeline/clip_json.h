// The result of a clip as JSON.
#pragma once

#include <string_view>
#include <vector>

#include "base/json.h"
#include "scene/expectation.h"
#include "scene/scene.h"
#include "timeline/clip_motion.h"
#include "timeline/motion_summary.h"

namespace rotatebook::timeline {

/// Returns an expectation as an object: its bounds, what was measured, and whether it is met.
Json expectationJson(const scene::ExpectationResult& result);

/// Returns a summary as an object. Unknown values are null.
Json motionJson(const MotionSummary& summary);

/// The checksums of a clip's scene and of its motion().
struct ClipChecksums {
  std::string_view scene, motion;
};

/// Returns the result of a clip as an object: {"result": "clip", "name", "title", "scene_xxh128",
/// "motion_xxh128", "rate": [60, 1], "frames", "motions", "events", "plots"}. "motions" holds
/// motionJson() of `summaries`, which are summarize()'s of `motion`; "events" {"frame", "time_s",
/// "label", "words"}, none of a grid; "plots" {"interval", "times": those of the frames, unless
/// they are even, "motions": [{"label", "springs": whether there are any, "kinetic", "potential",
/// "total", "tilt", "error"}]}, of a grid those in its corners. The last five have a number for
/// each sample, of six digits: energies over the total at the start, angles in degrees.
Json clipJson(const scene::Scene& scene, const ClipMotion& motion,
              const std::vector<MotionSummary>& summaries, const ClipChecksums& checksums);

}  // namespace rotatebook::timeline
