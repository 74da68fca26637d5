#include "cli/render_scenes.h"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <filesystem>
#include <functional>
#include <iostream>
#include <numeric>
#include <sstream>
#include <string>
#include <vector>

#include <fmt/ostream.h>

#include "base/error.h"
#include "base/text.h"
#include "cli/batch.h"
#include "cli/exit_code.h"
#include "cli/input_guard.h"
#include "cli/interrupt.h"
#include "cli/motion_report.h"
#include "cli/progress_line.h"
#include "cli/render_report.h"
#include "picture/preflight.h"
#include "store/clip_record.h"
#include "store/disk_space.h"
#include "system/file_checksum.h"
#include "system/machine.h"
#include "system/parallel_runs.h"
#include "system/read_file.h"
#include "timeline/simulate_scene.h"
#include "video/clip_reader.h"
#include "video/whole_file.h"

namespace rotatebook::cli {
namespace {

using Progress = std::function<void(pipeline::RenderProgress)>;

/// Renders a scene into `rendered`, which has what was done also after an error.
void render(const SceneToRender& one, const pipeline::RenderOptions& options,
            const Progress& progress, std::ostream& out, RenderedScene& rendered) {
  const scene::Scene& scene = one.scene;
  const timeline::ClipMotion motion = timeline::simulateScene(scene, options.stop);
  rendered.interrupted = *options.stop;
  if (rendered.interrupted) return;
  // Expectations are of the whole, which the render of a part can't keep or break
  std::vector<timeline::MotionSummary> summaries;
  if (!options.part) summaries = timeline::summarize(scene, motion);
  rendered.motions = summaries;
  if (!one.isJudged) timeline::leaveUnjudged(rendered.motions);
  pipeline::RenderListener listener;
  listener.started = [&](const pipeline::RenderStart& start) {
    rendered.start = start;
    reportStart(rendered, options, out);
    const std::string warning =
        store::spaceWarning(start.space, options.folder, hasPng(options.outputs));
    if (!warning.empty()) fmt::print(std::cerr, "rotatebook: {}: {}\n", scene.name, warning);
  };
  listener.progress = progress;
  rendered.result = renderClip(scene, motion, options, listener, one.found.textures, summaries);
  rendered.interrupted = rendered.result->interrupted;
}

int outcomeOf(const RenderedScene& rendered) {
  return rendered.interrupted ? interruptStatus() : statusOf(timeline::allMet(rendered.motions));
}

int renderInTurn(const std::vector<SceneToRender>& scenes, const pipeline::RenderOptions& options,
                 std::ostream& out, std::vector<RenderedScene>& rendered) {
  return inTurn(rendered, [&](std::size_t i) {
    {
      ProgressLine line(scenes[i].scene.name);
      const auto progress = [&](pipeline::RenderProgress now) { line.update(now.done, now.total); };
      render(scenes[i], options, progress, out, rendered[i]);
    }
    reportRender(rendered[i], options, out);
    reportRenderNotes(rendered[i], std::cerr);
    return outcomeOf(rendered[i]);
  });
}

/// Renders of several scenes at the same time. Their reports are printed on the caller's thread.
class ParallelRenders {
 public:
  ParallelRenders(const std::vector<SceneToRender>& scenes, const pipeline::RenderOptions& options,
                  std::ostream& out, std::vector<RenderedScene>& rendered)
      : scenes_(scenes),
        options_(options),
        out_(out),
        rendered_(rendered),
        renders_(scenes.size()),
        line_(std::to_string(scenes.size()) + " scenes") {
    for (std::size_t i = 0; i < scenes.size(); ++i) {
      const std::int64_t count = scenes[i].scene.clip.frameCount();
      renders_[i].total = options.part     ? store::framesOf(*options.part, count).count()
                          : options.frames ? options.frames->count()
                                           : count;
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
    std::ostringstream text, notes;
    int status = kDone;
    std::exception_ptr error;
    std::atomic<State> state = State::Waiting;  // Once Failed or Finished, nothing changes.
  };

  void render(std::size_t i) {
    Render& one = renders_[i];
    one.state = State::Running;
    // The report must be complete.
    for (std::ostringstream* part : {&one.text, &one.notes}) part->exceptions(std::ios::badbit);
    const auto progress = [&one](pipeline::RenderProgress now) {
      one.total = now.total;
      one.done = now.done;
    };
    try {
      noted(rendered_[i],
            [&] { cli::render(scenes_[i], options_, progress, one.text, rendered_[i]); });
      reportRender(rendered_[i], options_, one.text);
      reportRenderNotes(rendered_[i], one.notes);
      one.status = outcomeOf(rendered_[i]);
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
    fmt::print(std::cerr, "{} failed; no more scenes are started\n", nameOf(*failed));
  }

  /// Prints the reports of finished renders, in the scenes' order, up to the first unfinished one.
  void reportFinished() {
    for (; reported_ < renders_.size() && renders_[reported_].state == State::Finished;
         ++reported_) {
      line_.clear();
      out_ << renders_[reported_].text.str();
      std::cerr << renders_[reported_].notes.str();
    }
  }

  /// Prints the remaining reports after an error, and which scenes weren't started.
  void reportRest() {
    reportFailure();
    line_.clear();
    for (; reported_ < renders_.size(); ++reported_) reportFinished();
    for (const Render& one : renders_) {
      if (one.state == State::Waiting) fmt::print(out_, "{}: not started\n", nameOf(one));
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
  std::ostream& out_;
  std::vector<RenderedScene>& rendered_;  // Each is written by its render alone.
  std::vector<Render> renders_;
  std::size_t reported_ = 0;
  bool failureReported_ = false;
  ProgressLine line_;
};

/// Renders all scenes as renderScenes() does, with its reports on `out`.
int renderAll(const std::vector<SceneToRender>& scenes, const pipeline::RenderOptions& options,
              int atATime, std::ostream& out, std::vector<RenderedScene>& rendered) {
  for (const SceneToRender& one : scenes) reportNotes(one.scene, one.found.notes, std::cerr);
  atATime = std::min(atATime, static_cast<int>(scenes.size()));
  if (atATime <= 1) return renderInTurn(scenes, options, out, rendered);
  pipeline::RenderOptions shared = options;
  for (pipeline::RenderOutput& output : shared.outputs) {
    if (output.png) output.threads = pipeline::pngThreads(system::coreCount() / atATime);
  }
  fmt::print(out, "{} scenes at a time\n", atATime);
  return ParallelRenders(scenes, shared, out, rendered).run(atATime);
}

}  // namespace

int renderScenes(const std::vector<SceneToRender>& scenes, const pipeline::RenderOptions& options,
                 int atATime, const ReportStyle& style) {
  std::vector<RenderedScene> rendered;
  for (const SceneToRender& one : scenes)
    rendered.push_back({.scene = one.scene, .isDetailed = style.isDetailed});
  return reportBatch(
      style.json, "scenes", rendered,
      [&](std::ostream& out) { return renderAll(scenes, options, atATime, out, rendered); },
      [&](const RenderedScene& one) { return renderJson(one, options); });
}

namespace {

namespace fs = std::filesystem;

store::ClipFiles filesOf(const store::RecordedClip& clip, const fs::path& folder) {
  const std::string& name = clip.record.scene.name;
  return clip.record.part ? store::clipFiles(folder, name, *clip.record.part)
                          : store::clipFiles(folder, name);
}

/// Throws InputError if the rerun would replace what another scene's clip of the same name left:
/// its video, or, if `png`, its frames.
void refuseOtherClip(const scene::Scene& scene, const store::ClipFiles& files,
                     const fs::path& output, bool png) {
  const auto refuse = [](const fs::path& file) {
    throw InputError(file.string() +
                     " isn't from the clip's scene and would be lost; name another folder with -o, "
                     "or replace it with --overwrite");
  };
  if (fs::exists(output) && !store::isRecordOf(scene, store::recordIn(output))) refuse(output);
  const fs::path& copy = files.sceneCopy;
  if (png && fs::exists(copy) && !store::isRecordOf(scene, system::readFileOrEmpty(copy)))
    refuse(copy);
}

/// Lists why `clip`, which was made `there`, may have other bytes than the one made `here` from the
/// same record.
std::vector<std::string> reasons(const fs::path& clip, const store::Provenance& there,
                                 const store::Provenance& here) {
  try {
    video::requireWholeFile(clip);
  } catch (const InputError& cut) {
    return {cut.what()};
  }
  std::vector<std::string> found = store::differencesOfTools(there, here);
  if (there.motion != here.motion) found.push_back("the motion differs from the recorded one");
  if (!found.empty()) return found;
  return {
      "version, renderer, FFmpeg and motion are those recorded: the clip was changed, or a "
      "texture, the font, the video encoder or the build of this program differs"};
}

/// Reports whether both files have the same bytes; returns the status.
int compare(const store::RecordedClip& there, const RerunArguments& arguments,
            const fs::path& output) {
  const std::string clip = oneLine(arguments.clip.string());
  const std::string made = oneLine(output.string());
  if (system::checksumOfFile(arguments.clip) == system::checksumOfFile(output)) {
    fmt::print(std::cout, "  {} has exactly the bytes of {}\n", made, clip);
    return kDone;
  }
  fmt::print(std::cout, "  {} has OTHER bytes than {}\n", made, clip);
  const store::ClipRecord here = store::parseRecord(video::readClipMetadata(output).comment, output,
                                                    there.record.scene.folder);
  for (const std::string& reason :
       reasons(arguments.clip, there.record.provenance, here.provenance)) {
    fmt::print(std::cout, "    {}\n", oneLine(reason));
  }
  return kUnmet;
}

}  // namespace

int rerun(const RerunArguments& arguments) {
  const store::RecordedClip clip = store::readRecordedClip(arguments.clip, arguments.textures);
  const picture::Preflight found{clip.textures, picture::notesOn(clip.record.scene)};
  const store::ClipFiles files = filesOf(clip, arguments.folder);
  const fs::path output = files.video(clip.format);
  pipeline::RenderOptions options;
  options.folder = arguments.folder;
  options.earlier = arguments.earlier;
  options.outputs = pipeline::outputsOf(arguments.png, {clip.format});
  options.frames = clip.record.part;
  std::vector<Input> inputs = inputsOf(clip.record.scene);
  inputs.push_back({arguments.clip, "the clip itself, which is to be compared with the new one"});
  refuseInputs(footprintOf(clip.record.scene, options), inputs);
  if (!arguments.earlier.overwrite) {
    refuseOtherClip(clip.record.scene, files, output, arguments.png);
  }
  options.device = arguments.deviceOptions.choice(/*resumable=*/true);
  options.stop = &catchInterrupts();
  // Expectations are reported, but decide no status: they decided that of the first render.
  const int status = renderScenes({{clip.record.scene, found}}, options, 1);
  return status >= kInterrupted ? status : compare(clip, arguments, output);
}

}  // namespace rotatebook::cli
