#include "store/encoding.h"

namespace rotatebook::store {

std::vector<video::Chapter> chaptersOf(const scene::Scene& scene) {
  std::vector<video::Chapter> chapters;
  for (const scene::ShownCue& shown : scene.shownCues) {
    const std::string& name = scene.cues[shown.cue].chapter;
    if (!name.empty()) chapters.push_back({shown.frame, name});
  }
  return chapters;
}

video::VideoSettings videoSettings(const scene::Scene& scene, const std::string& record,
                                   bool isWhole) {
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
  if (isWhole) settings.chapters = chaptersOf(scene);
  return settings;
}

}  // namespace rotatebook::store
