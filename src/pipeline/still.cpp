#include "pipeline/still.h"

#include <algorithm>

#include "base/error.h"
#include "base/number_text.h"
#include "image/png_file.h"
#include "physics/trajectory.h"
#include "pipeline/frame_drawer.h"
#include "pipeline/simulate_scene.h"

namespace rotatebook::pipeline {
namespace {

std::int64_t frameAt(const scene::Scene& scene, double time) {
  if (!(time >= 0 && time <= scene.clip.duration)) {
    throw InputError("there is no picture at " + shortestText(time) +
                     " s: the clip lasts from 0 to " + shortestText(scene.clip.duration) + " s");
  }
  return std::min(scene.clip.frameRate.framesIn(time), scene.clip.frameCount() - 1);
}

}  // namespace

std::int64_t renderStill(const scene::Scene& scene, double time,
                         const std::filesystem::path& path) {
  const std::int64_t frame = frameAt(scene, time);
  const physics::Trajectory trajectory = simulateScene(scene, frame + 1);
  if (trajectory.divergedAt) {
    throw InputError("there is no picture at " + shortestText(time) +
                     " s: the motion diverged at " + shortestText(*trajectory.divergedAt) + " s");
  }
  FrameDrawer drawer(scene, trajectory);
  image::Image picture = drawer.makePicture();
  drawer.draw(frame, picture);
  image::writePng(path, picture.view());
  return frame;
}

}  // namespace rotatebook::pipeline
