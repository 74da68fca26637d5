#include "store/encoding.h"

namespace rotatebook::store {

video::VideoSettings videoSettings(const scene::Scene& scene, const std::string& record) {
  video::VideoSettings settings;
  settings.width = scene.clip.width;
  settings.height = scene.clip.height;
  settings.frameRate = scene.clip.frameRate;
  settings.transparent = scene::isTransparent(scene);
  settings.crf = scene.video.crf;
  settings.preset = scene.video.preset;
  settings.threads = scene.video.threads;
  settings.title = scene.title;
  settings.comment = record;
  return settings;
}

}  // namespace rotatebook::store
