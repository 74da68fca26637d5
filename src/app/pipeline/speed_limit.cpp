#include "pipeline/speed_limit.h"

#include <algorithm>
#include <array>
#include <utility>

#include "base/text.h"
#include "picture/device_choice.h"

namespace rotatebook::pipeline {
namespace {

constexpr double kMinGain = 1.03;
constexpr int kMinToHalve = 64;  // The shorter side. [pixels]

WorkTime scaled(const WorkTime& time, double factor) {
  return {time.wall * factor, time.processor * factor};
}

/// Collects advice: each change is tried on the measured times, and kept if it gains enough.
class AdviceCollector {
 public:
  explicit AdviceCollector(const Speed& speed)
      : speed_(speed), limit_(speedLimit(speed.stages, speed.cores)) {}

  const SpeedLimit& limit() const { return limit_; }

  void tryOut(const std::string& change, const std::string& effect, const StageTimes& stages,
              int cores) {
    const double gain = limit_.wall / std::max(speedLimit(stages, cores).wall, 1e-9);
    if (gain >= kMinGain) advice_.push_back({change, effect, gain});
  }

  /// Tries the stages' times as `change(stages)` alters them.
  template <typename Change>
  void tryOut(const std::string& name, const std::string& effect, const Change& change) {
    StageTimes stages = speed_.stages;
    change(stages);
    tryOut(name, effect, stages, speed_.cores);
  }

  std::vector<SpeedAdvice> take() {
    std::ranges::stable_sort(advice_, std::ranges::greater{}, &SpeedAdvice::gain);
    return std::move(advice_);
  }

 private:
  const Speed& speed_;
  SpeedLimit limit_;
  std::vector<SpeedAdvice> advice_;
};

void adviseOnBook(const scene::Scene& scene, const Speed& speed, AdviceCollector& advice) {
  const scene::LookSettings& look = scene.look;
  if (look.supersample > 1) {
    advice.tryOut("--set look.supersample=1", "edges are less smooth", [&](StageTimes& stages) {
      stages.book = scaled(stages.book, 1.0 / (look.supersample * look.supersample));
    });
  }
  if (look.motionBlur > 1) {
    advice.tryOut("--set look.motion_blur=1", "no blur", [&](StageTimes& stages) {
      stages.book = scaled(stages.book, 1.0 / look.motionBlur);
    });
  }
  if (picture::isSoftwareRenderer(speed.renderer)) {
    advice.tryOut("a graphics card", "if it drew at no cost",
                  [](StageTimes& stages) { stages.book = {}; });
  }
}

void adviseOnVideo(const scene::Scene& scene, const Speed& speed, AdviceCollector& advice) {
  if (scene.video.preset != "ultrafast") {
    advice.tryOut("a faster video.preset", "larger files; if encoding cost nothing",
                  [](StageTimes& stages) { stages.video = {}; });
  }
  if (!advice.limit().ofCores && scene.video.threads < speed.cores) {
    const double share = static_cast<double>(scene.video.threads) / speed.cores;
    advice.tryOut("--set video.threads=" + std::to_string(speed.cores), "another MP4, byte by byte",
                  [&](StageTimes& stages) { stages.video.wall *= share; });
  }
}

/// Returns half the width and height; the sides stay even.
std::string halfSize(const scene::ClipSettings& clip) {
  return sizeText(clip.width / 4 * 2, clip.height / 4 * 2);
}

void adviseOnSize(const scene::Scene& scene, AdviceCollector& advice) {
  if (std::min(scene.clip.width, scene.clip.height) < kMinToHalve) return;
  advice.tryOut(
      "--size " + halfSize(scene.clip), "a quarter of the pixels", [](StageTimes& stages) {
        for (WorkTime* time : {&stages.book, &stages.compose, &stages.png, &stages.video}) {
          *time = scaled(*time, 0.25);
        }
      });
}

}  // namespace

SpeedLimit speedLimit(const StageTimes& stages, int cores) {
  const double shared = stages.processorSum() / cores;
  const double alone = std::max({stages.book.wall, stages.compose.wall, stages.video.wall});
  // A software rasteriser alone can keep all cores busy, too; then the cores are the limit.
  if (shared >= alone) {
    const std::array<std::pair<double, Stage>, 5> times{{
        {stages.simulate.processor, Stage::Simulate},
        {stages.book.processor, Stage::Book},
        {stages.compose.processor, Stage::Compose},
        {stages.png.processor, Stage::Png},
        {stages.video.processor, Stage::Video},
    }};
    return {std::ranges::max_element(times)->second, true, shared};
  }
  if (stages.video.wall >= alone) return {Stage::Video, false, alone};
  return {stages.book.wall >= alone ? Stage::Book : Stage::Compose, false, alone};
}

std::vector<SpeedAdvice> speedAdvice(const scene::Scene& scene, const Speed& speed) {
  AdviceCollector advice(speed);
  const SpeedLimit& limit = advice.limit();
  if (limit.stage == Stage::Book) adviseOnBook(scene, speed, advice);
  if (limit.stage == Stage::Compose) {
    advice.tryOut("fewer of overlay.show", "if finishing cost nothing",
                  [](StageTimes& stages) { stages.compose = {}; });
  }
  if (limit.stage == Stage::Png) {
    advice.tryOut("--no-png", "the MP4 alone", [](StageTimes& stages) { stages.png = {}; });
  }
  if (limit.stage == Stage::Video) adviseOnVideo(scene, speed, advice);
  if (limit.stage != Stage::Simulate) adviseOnSize(scene, advice);
  if (limit.ofCores) {
    const int more = 2 * speed.cores;
    advice.tryOut("more cores", "with " + std::to_string(more), speed.stages, more);
  }
  return advice.take();
}

}  // namespace rotatebook::pipeline
