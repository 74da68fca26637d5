#include "cli/render_scenes.h"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <functional>
#include <iostream>
#include <numeric>
#include <optional>
#include <sstream>
#include <string>
#include <utility>

#include "base/number_text.h"
#include "base/text.h"
#include "cli/error_report.h"
#include "cli/exit_code.h"
#include "cli/file_report.h"
#include "cli/interrupt.h"
#include "cli/motion_report.h"
#include "cli/progress_line.h"
#include "system/machine.h"
#include "system/parallel_runs.h"
#include "timeline/simulate_scene.h"

namespace rotatebook::cli {
namespace {

constexpr int kCoresAScene = 3;

/// Estimates the memory that one more render takes. [bytes] Measured at 1280x720, 1920x1080 and
/// 3840x2160: 155, 326 and 878 MB.
double memoryOf(const scene::Scene& scene) {
  constexpr double kBase = 60e6, kPixel = 110;
  const double supersample = scene.look.supersample;
  return kBase + kPixel * supersample * supersample * scene.clip.width * scene.clip.height;
}

using Progress = std::function<void(pipeline::RenderProgress)>;

/// Returns the number of threads of all encoders.
int encoderThreads(const scene::Scene& scene, const std::vector<video::VideoFormat>& formats) {
  int threads = 0;
  for (const video::VideoFormat format : formats) {
    threads += rowOf(format).usesThreads ? scene.video.threads : 1;
  }
  return threads;
}

void announce(const scene::Scene& scene, const pipeline::RenderStart& start, int encoders,
              std::ostream& out) {
  out << scene.name << ": " << scene.title << '\n'
      << "  " << sizeText(scene.clip.width, scene.clip.height) << " at "
      << scene.clip.frameRate.text() << " frames/s, " << shortestText(scene.clip.duration)
      << " s; renderer " << start.renderer
      << (start.encoders.empty() ? std::string() : "; encoder " + start.encoders) << '\n'
      << "  threads: 1 draws (a software rasteriser has its own), 1 composes";
  if (start.pngThreads > 0) {
    out << ", " << start.pngThreads << (start.pngThreads == 1 ? " compresses" : " compress")
        << " PNGs";
  }
  if (encoders > 0) out << ", " << encoders << (encoders == 1 ? " encodes" : " encode");
  out << "; cores: " << system::coreCount() << std::endl;
}

/// Lists the files and folders that a render wrote.
std::vector<std::string> writtenItems(const pipeline::RenderResult& result,
                                      const pipeline::RenderOptions& options) {
  const store::ClipFiles& files = result.files;
  const bool newFolder = result.interrupted && !options.frames;
  std::vector<std::string> items;
  for (const video::VideoFormat format : formatsOf(options.outputs)) {
    if (result.framesWritten == 0) break;
    items.push_back(
        (result.interrupted ? files.partialVideo(format) : files.video(format)).string());
  }
  if (!result.interrupted) {
    for (const auto& csv : result.csvs) items.push_back(csv.string());
  }
  if (!result.interrupted && !options.frames) items.push_back(files.poster.string());
  if (hasPng(options.outputs)) {
    items.push_back(std::to_string(result.framesWritten) + " frames in " +
                    (newFolder ? files.partialFrameFolder : files.frameFolder).string() + '/');
  }
  return items;
}

struct Rendered {
  timeline::ClipMotion motion;
  pipeline::RenderResult result;
};

/// Renders one scene. Returns nothing, and reports that, if it was interrupted before there was
/// anything to write.
std::optional<Rendered> render(const SceneToRender& one, const pipeline::RenderOptions& options,
                               const Progress& progress, std::ostream& out) {
  const scene::Scene& scene = one.scene;
  timeline::ClipMotion motion = timeline::simulateScene(scene, options.stop);
  if (*options.stop) {
    out << scene.name << ": interrupted while simulating; nothing was written" << std::endl;
    return std::nullopt;
  }
  pipeline::RenderListener listener;
  listener.started = [&](const pipeline::RenderStart& start) {
    announce(scene, start, encoderThreads(scene, formatsOf(options.outputs)), out);
    const std::string warning = spaceWarning(start.space, options.folder, hasPng(options.outputs));
    if (!warning.empty()) std::cerr << "rotatebook: " + scene.name + ": " + warning + '\n';
  };
  listener.progress = progress;
  pipeline::RenderResult result = renderClip(scene, motion, options, listener, one.textures);
  return Rendered{std::move(motion), std::move(result)};
}

const char* howToGoOn(const pipeline::RenderOptions& options) {
  return hasPng(options.outputs) ? "; go on with the same command and --resume" : "";
}

/// Reports what was rendered; returns the status.
int report(const scene::Scene& scene, const std::optional<Rendered>& rendered,
           const pipeline::RenderOptions& options, std::ostream& out) {
  if (!rendered) return interruptStatus();
  const auto& [motion, result] = *rendered;
  if (result.wasDone) out << scene.name << ": already done" << std::endl;
  if (result.framesKept > 0) {
    out << "  kept " << result.framesKept << " frames of an earlier run" << std::endl;
  }
  if (result.interrupted && result.framesWritten == 0) {
    out << "  interrupted before the first frame; nothing was written" << std::endl;
    return interruptStatus();
  }
  if (!result.wasDone) out << "  wrote " << listed(writtenItems(result, options)) << std::endl;
  if (!result.others.empty()) {
    out << "  kept " << oneLine(listed(result.others)) << ", made with other settings" << std::endl;
  }
  if (result.interrupted) {
    out << "  interrupted after " << result.framesWritten << " frames" << howToGoOn(options)
        << std::endl;
    return interruptStatus();
  }
  return reportMotions(scene, motion, out);
}

int renderInTurn(const std::vector<SceneToRender>& scenes, const pipeline::RenderOptions& options) {
  int status = kDone;
  for (const SceneToRender& one : scenes) {
    const scene::Scene& scene = one.scene;
    std::optional<Rendered> rendered;
    {
      ProgressLine line(scene.name);
      const auto progress = [&](pipeline::RenderProgress now) { line.update(now.done, now.total); };
      rendered = render(one, options, progress, std::cout);
    }
    const int outcome = report(scene, rendered, options, std::cout);
    if (outcome >= kInterrupted) return outcome;
    status = std::max(status, outcome);
  }
  return status;
}

/// Renders of several scenes at the same time. Their reports are printed on the caller's thread.
class ParallelRenders {
 public:
  ParallelRenders(const std::vector<SceneToRender>& scenes, const pipeline::RenderOptions& options)
      : scenes_(scenes),
        options_(options),
        renders_(scenes.size()),
        line_(std::to_string(scenes.size()) + " scenes") {
    for (std::size_t i = 0; i < scenes.size(); ++i) {
      renders_[i].total =
          options.frames ? options.frames->count() : scenes[i].scene.clip.frameCount();
    }
  }

  int run(int atATime) {
    std::vector<std::size_t> all(scenes_.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    system::RunOptions options;
    options.threads = atATime;
    options.stop = options_.stop;
    options.progress = [this](std::size_t, std::size_t) { update(); };
    bool begunAll = false;
    try {
      const auto renderOne = [this](std::size_t i) { render(i); };
      begunAll = runParallel(all, renderOne, options);
    } catch (...) {
      reportRest();
      const int status = reportErrors();
      if (status != kDone) return status;
      throw;  // The error isn't a scene's, but of running them.
    }
    int status = begunAll ? kDone : interruptStatus();
    for (const Render& one : renders_) status = std::max(status, one.status);
    return status;
  }

 private:
  enum class State { Waiting, Running, Failed, Finished };

  struct Render {
    std::atomic<std::int64_t> done = 0, total = 0;
    std::ostringstream text;
    int status = kDone;
    std::exception_ptr error;
    std::atomic<State> state = State::Waiting;  // Once Failed or Finished, nothing changes.
  };

  void render(std::size_t i) {
    Render& one = renders_[i];
    one.state = State::Running;
    one.text.exceptions(std::ios::badbit);  // The report must be complete.
    const auto progress = [&one](pipeline::RenderProgress now) {
      one.total = now.total;
      one.done = now.done;
    };
    try {
      const std::optional<Rendered> rendered =
          cli::render(scenes_[i], options_, progress, one.text);
      one.status = report(scenes_[i].scene, rendered, options_, one.text);
      one.state = State::Finished;
    } catch (...) {
      one.error = std::current_exception();
      one.state = State::Failed;
      throw;
    }
  }

  void update() {
    reportFailure();
    std::int64_t done = 0, total = 0;
    for (const Render& one : renders_) {
      if (failureReported_ && (one.state == State::Failed || one.state == State::Waiting)) continue;
      done += one.done;
      total += one.total;
    }
    line_.update(done, total);
    reportFinished();
  }

  /// Reports a failure at once, as the other renders may take long; the cause is printed at the
  /// end.
  void reportFailure() {
    const auto failed = std::ranges::find(renders_, State::Failed, stateOf);
    if (failureReported_ || failed == renders_.end()) return;
    failureReported_ = true;
    line_.clear();
    std::cerr << nameOf(*failed) << " failed; no more scenes are started" << std::endl;
  }

  /// Prints the reports of finished renders, in the scenes' order, up to the first unfinished one.
  void reportFinished() {
    for (; reported_ < renders_.size() && renders_[reported_].state == State::Finished;
         ++reported_) {
      line_.clear();
      std::cout << renders_[reported_].text.str() << std::flush;
    }
  }

  /// Prints the remaining reports after an error, and which scenes weren't started.
  void reportRest() {
    reportFailure();
    line_.clear();
    for (; reported_ < renders_.size(); ++reported_) reportFinished();
    for (const Render& one : renders_) {
      if (one.state == State::Waiting) std::cout << nameOf(one) << ": not started" << std::endl;
    }
  }

  /// Prints why scenes failed; returns the highest status, kDone if none failed.
  int reportErrors() const {
    int status = kDone;
    for (const Render& one : renders_) {
      if (one.error) status = std::max(status, reportError(one.error, nameOf(one) + ": "));
    }
    return status;
  }

  static State stateOf(const Render& one) { return one.state; }

  const std::string& nameOf(const Render& one) const {
    return scenes_[static_cast<std::size_t>(&one - renders_.data())].scene.name;
  }

  const std::vector<SceneToRender>& scenes_;
  const pipeline::RenderOptions& options_;
  std::vector<Render> renders_;
  std::size_t reported_ = 0;
  bool failureReported_ = false;
  ProgressLine line_;
};

}  // namespace

int scenesAtATime(const std::vector<SceneToRender>& scenes, int cores, double memory) {
  double largest = 0;
  for (const SceneToRender& one : scenes) largest = std::max(largest, memoryOf(one.scene));
  const double held = memory / 4 / largest;
  return std::max(1, static_cast<int>(std::min(1.0 * cores / kCoresAScene, held)));
}

int renderScenes(const std::vector<SceneToRender>& scenes, const pipeline::RenderOptions& options,
                 int atATime) {
  for (const SceneToRender& one : scenes) printNotes(one.scene);
  atATime = std::min(atATime, static_cast<int>(scenes.size()));
  if (atATime <= 1) return renderInTurn(scenes, options);
  pipeline::RenderOptions shared = options;
  for (pipeline::RenderOutput& output : shared.outputs) {
    if (output.png) output.threads = pipeline::pngThreads(system::coreCount() / atATime);
  }
  std::cout << atATime << " scenes at a time" << std::endl;
  return ParallelRenders(scenes, shared).run(atATime);
}

}  // namespace rotatebook::cli
