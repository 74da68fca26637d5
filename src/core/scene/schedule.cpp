#include "scene/schedule.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <numeric>
#include <string>
#include <utility>

#include "base/document/problems.h"
#include "base/document/toml_text.h"
#include "base/document/toml_tree.h"
#include "base/error.h"
#include "base/nearest_name.h"
#include "base/number_text.h"
#include "scene/motion_events.h"
#include "scene/solid_particles.h"
#include "scene/source_locations.h"

namespace rotatebook::scene {
namespace {

// Times of frames that are closer to a moment than that come with it. [s]
constexpr double kSameTime = 1e-9;

double baseSpeed(const Scene& scene) {
  return scene.clip.speed ? scene.clip.speed->constant
                          : scene.timePerFrame() / scene.clip.frameRate.period();
}

const std::vector<SpeedStretch>& stretchesOf(const Spec& spec) {
  static const std::vector<SpeedStretch> kNone;
  return spec.clip.speed ? spec.clip.speed->stretches : kNone;
}

bool hasMoments(const Spec& spec) {
  return std::ranges::any_of(stretchesOf(spec), &SpeedStretch::hasMoments);
}

/// Returns the moments that a scene names.
std::vector<const Moment*> momentsOf(const Spec& spec) {
  std::vector<const Moment*> moments;
  for (const Cue& cue : spec.cues) moments.push_back(&cue.at);
  for (const SpeedStretch& stretch : stretchesOf(spec)) {
    if (stretch.begin) moments.push_back(&*stretch.begin);
    if (stretch.end) moments.push_back(&*stretch.end);
  }
  return moments;
}

/// Returns the index of the motion with that label, or of the first. Throws InputError.
std::size_t motionOf(const Scene& scene, const std::string& label) {
  if (label.empty()) return 0;
  std::vector<std::string_view> labels;
  for (const Panel& motion : scene.motions) labels.push_back(motion.label);
  const auto found = std::ranges::find(labels, label);
  if (found != labels.end()) return static_cast<std::size_t>(found - labels.begin());
  throw InputError("no motion has the label " + document::tomlString(label) +
                   didYouMean(label, labels));
}

/// Returns whether all motions are there that a scene names events of.
bool hasMotions(const Scene& scene) {
  const auto isThere = [](const Panel& panel) {
    const physics::SimulationSettings& simulation = panel.simulation;
    return !lacksSurface(panel) &&
           (simulation.model != physics::Model::Recorded || simulation.recorded.motion != nullptr);
  };
  const auto needsNone = [](const Moment* moment) {
    return moment->event == Event::Start || moment->event == Event::End;
  };
  return std::ranges::all_of(momentsOf(scene), needsNone) ||
         std::ranges::all_of(scene.motions, isThere);
}

/// Returns whether a stretch needs the motion's time at the clip's end, which it changes itself.
bool isOfUnknownEnd(const SpeedStretch& stretch) {
  return (stretch.begin && stretch.begin->event == Event::End) ||
         (stretch.end && stretch.end->event == Event::End && stretch.end->offset != 0);
}

/// A time at which the motion stands, and for how long.
struct Hold {
  double at;      // of the motion [s]
  double length;  // of video [s]
};

/// Goes through a clip, and notes the speeds at which it shows the motion.
class Walk {
 public:
  Walk(double base, std::vector<Hold> holds)
      : base_(base), speed_(base), holds_(std::move(holds)) {}

  double motion() const { return motion_; }
  double video() const { return video_; }
  void setSpeed(double speed) { speed_ = speed; }

  void goToVideo(double time) {
    while (stopBefore(time)) continue;
    run(time);
  }
  void goToMotion(double time) {
    while (stopBefore(videoAt(time))) continue;
    run(videoAt(time));
    motion_ = std::max(motion_, time);
  }
  PlaybackSpeed speeds() const { return {base_, stretches_}; }

 private:
  /// Returns the time of video at which the motion comes to `time`, at this speed.
  double videoAt(double time) const {
    if (time <= motion_) return video_;
    return speed_ > 0 ? video_ + (time - motion_) / speed_
                      : std::numeric_limits<double>::infinity();
  }

  /// Goes through the next hold if it comes by `time`.
  bool stopBefore(double time) {
    if (next_ == holds_.size() || videoAt(holds_[next_].at) > time) return false;
    const auto [at, length] = holds_[next_++];
    run(videoAt(at));
    motion_ = std::max(motion_, at);
    add(length, 0);
    return true;
  }

  void run(double until) {
    const double length = until - video_;
    if (!(length > 0)) return;
    motion_ += speed_ * length;
    add(length, speed_);
  }

  void add(double length, double speed) {
    const double end = video_ + length;
    if (speed != base_) stretches_.push_back({video_, end, speed});
    video_ = end;
  }

  double base_, speed_;
  double video_ = 0, motion_ = 0;  // [s]
  std::vector<Hold> holds_;        // in the order of time
  std::size_t next_ = 0;           // of the holds
  std::vector<SpeedStretch> stretches_;
};

/// Finds the schedule of a scene.
class Scheduler {
 public:
  explicit Scheduler(Scene& scene) : scene_(scene) {}

  void run() {
    refuseUnseenEnds();
    findTimes();
    const double end = endOfMotion();
    for (ShownCue& shown : scene_.shownCues) {
      const Moment& at = cueOf(shown).at;
      if (at.event == Event::End) shown.time = end + at.offset;
    }
    refuseEarly();
    std::ranges::stable_sort(scene_.shownCues, {}, &ShownCue::time);
    const bool hasHolds =
        std::ranges::any_of(scene_.cues, [](const Cue& cue) { return cue.hold > 0; });
    if (hasHolds || hasMoments(scene_)) scene_.schedule = walked(holds(true)).speeds();
    for (ShownCue& shown : scene_.shownCues) shown.frame = frameAt(shown.time);
    refuseSameFrames();
  }

 private:
  const Cue& cueOf(const ShownCue& shown) const { return scene_.cues[shown.cue]; }

  double timeOf(const Moment& moment) {
    if (moment.event == Event::Start) return moment.offset;
    const std::size_t index = motionOf(scene_, moment.label);
    if (moment.event == Event::End) return longestMotion(scene_);
    const auto [events, isNew] = events_.try_emplace(index, scene_.motions[index],
                                                     scene_.timePerFrame(), longestMotion(scene_));
    return events->second.timeOf(moment) + moment.offset;
  }

  /// Finds the times of cues and stretches, but for those of the clip's end.
  void findTimes() {
    document::Problems problems;
    const auto at = [&](const std::string& key, const Moment& moment) {
      double time = 0;
      problems.note([&] {
        try {
          time = timeOf(moment);
        } catch (const InputError& error) {
          document::failAt(locationOf(scene_, key), error.what());
        }
      });
      return time;
    };
    scene_.shownCues.clear();
    for (std::size_t i = 0; i < scene_.cues.size(); ++i)
      scene_.shownCues.push_back({i, at(cueKey(i), scene_.cues[i].at)});
    for (const SpeedStretch& stretch : stretchesOf(scene_)) {
      if (isOfUnknownEnd(stretch)) {
        refuse(
            "names a time before or after the end, or begins there; the motion's end follows from "
            "the speeds, so state a time, another event, or to = \"end\" alone");
      }
      if (stretch.begin) begins_[&stretch] = at("clip.speed", *stretch.begin);
      if (stretch.end) ends_[&stretch] = at("clip.speed", *stretch.end);
    }
    problems.throwIfAny();
    std::ranges::stable_sort(scene_.shownCues, {}, &ShownCue::time);
  }

  /// Returns the holds, with or without those of the clip's end.
  std::vector<Hold> holds(bool ofEnd) const {
    std::vector<Hold> all;
    for (const ShownCue& shown : scene_.shownCues) {
      const Cue& cue = cueOf(shown);
      const bool isOfEnd = cue.at.event == Event::End;
      if (cue.hold > 0 && (ofEnd || !isOfEnd)) all.push_back({shown.time, cue.hold});
    }
    return all;
  }

  Walk walked(std::vector<Hold> holds) const {
    Walk walk(baseSpeed(scene_), std::move(holds));
    for (const SpeedStretch& stretch : stretchesOf(scene_)) {
      const double video = walk.video(), motion = walk.motion();
      const bool isLate = stretch.begin ? begins_.at(&stretch) < motion - kSameTime
                                        : stretch.from < video - kSameTime;
      if (isLate) refuse("begins before the one before it has ended");
      stretch.begin ? walk.goToMotion(begins_.at(&stretch)) : walk.goToVideo(stretch.from);
      walk.setSpeed(stretch.value);
      const bool isEmpty =
          stretch.end ? ends_.at(&stretch) <= walk.motion() : stretch.to <= walk.video();
      if (isEmpty) refuse("ends before it begins");
      stretch.end ? walk.goToMotion(ends_.at(&stretch)) : walk.goToVideo(stretch.to);
      walk.setSpeed(baseSpeed(scene_));
    }
    walk.goToVideo(std::max(walk.video(), scene_.clip.duration));
    return walk;
  }

  [[noreturn]] void refuse(const std::string& what) const {
    document::failAt(locationOf(scene_, "clip.speed"), "a stretch of clip.speed " + what);
  }

  /// Returns the motion's time at the clip's end, before which the holds of the end must come.
  double endOfMotion() const {
    double held = 0;
    for (const Cue& cue : scene_.cues) held += cue.at.event == Event::End ? cue.hold : 0;
    const PlaybackSpeed speeds = walked(holds(false)).speeds();
    return speeds.timeAt(std::max(scene_.clip.duration - held, 0.0));
  }

  /// A cue at the clip's end has no time of its own but that for which it holds it.
  void refuseUnseenEnds() const {
    for (std::size_t i = 0; i < scene_.cues.size(); ++i) {
      const Cue& cue = scene_.cues[i];
      if (cue.at.event != Event::End || cue.at.offset < 0 || cue.hold > 0) continue;
      document::failAt(locationOf(scene_, cueKey(i)),
                       "nothing is seen of a cue at the clip's end; give it a hold, such as hold = "
                       "\"3 s\", or take at = \"3 s before end\"");
    }
  }

  void refuseEarly() const {
    for (const ShownCue& shown : scene_.shownCues) {
      if (shown.time >= 0) continue;
      document::failAt(locationOf(scene_, cueKey(shown.cue)),
                       "the cue comes " + roundedText(-shown.time, 3) + " s before the start");
    }
  }

  /// Returns the first frame that shows a time, or the number of frames.
  std::int64_t frameAt(double time) const {
    std::int64_t first = 0, end = scene_.clip.frameCount();
    while (first < end) {
      const std::int64_t middle = std::midpoint(first, end);
      if (timeAt(scene_, static_cast<double>(middle)) >= time - kSameTime) {
        end = middle;
      } else {
        first = middle + 1;
      }
    }
    return end;
  }

  void refuseSameFrames() const {
    const std::vector<ShownCue>& all = scene_.shownCues;
    for (std::size_t i = 1; i < all.size(); ++i) {
      if (all[i].frame != all[i - 1].frame || all[i].frame == scene_.clip.frameCount()) continue;
      document::failAt(locationOf(scene_, cueKey(all[i].cue)),
                       "two cues come in frame " + std::to_string(all[i].frame) + ", at " +
                           roundedText(all[i].time, 4) + " s of the motion; make one of them");
    }
  }

  Scene& scene_;
  std::map<std::size_t, MotionEvents> events_;           // by motion
  std::map<const SpeedStretch*, double> begins_, ends_;  // of the motion [s]
};

}  // namespace

double longestMotion(const Scene& scene) {
  const auto frames = static_cast<double>(scene.clip.frameCount());
  if (stretchesOf(scene).empty()) return frames * scene.timePerFrame();
  if (!hasMoments(scene))
    return scene.clip.speed->timeAt(frames * scene.clip.frameRate.period(), scene.clip.duration);
  double fastest = baseSpeed(scene);
  for (const SpeedStretch& stretch : stretchesOf(scene)) fastest = std::max(fastest, stretch.value);
  return scene.clip.duration * fastest;
}

void schedule(Scene& scene) {
  if ((scene.cues.empty() && !hasMoments(scene)) || !hasMotions(scene)) return;
  Scheduler(scene).run();
}

}  // namespace rotatebook::scene
