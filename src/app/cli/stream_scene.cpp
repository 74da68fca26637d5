#include "cli/stream_scene.h"

#include <algorithm>
#include <iostream>
#include <unistd.h>

#include <fmt/ostream.h>

#include "base/error.h"
#include "base/nearest_name.h"
#include "base/text.h"
#include "cli/exit_code.h"
#include "cli/interrupt.h"
#include "cli/motion_report.h"
#include "cli/progress_line.h"
#include "timeline/simulate_scene.h"

namespace rotatebook::cli {

pipeline::StreamFormat streamFormatOf(const std::vector<std::string>& names) {
  if (names.empty()) return pipeline::StreamFormat::Y4m;
  const std::string& name = names.back();
  const auto found = std::ranges::find(pipeline::kStreamNames, name);
  if (names.size() > 1 || found == pipeline::kStreamNames.end()) {
    throw InputError(fmt::format("--format {}: the standard output takes one of {}{}",
                                 joined(names, ","), quotedList(pipeline::kStreamNames, "and"),
                                 names.size() > 1 ? "" : didYouMean(name, pipeline::kStreamNames)));
  }
  return static_cast<pipeline::StreamFormat>(found - pipeline::kStreamNames.begin());
}

int streamScene(const SceneToRender& one, const pipeline::StreamOptions& options) {
  endAtInterrupts();
  const scene::Scene& scene = one.scene;
  reportNotes(scene, one.found.notes, std::cerr);
  const timeline::ClipMotion motion = timeline::simulateScene(scene);
  std::vector<timeline::MotionSummary> motions = timeline::summarize(scene, motion);
  if (!one.isJudged) timeline::leaveUnjudged(motions);
  const system::FileDescriptor output(dup(STDOUT_FILENO));
  std::int64_t frames = 0;
  {
    ProgressLine line(scene.name);
    const auto progress = [&](pipeline::RenderProgress now) { line.update(now.done, now.total); };
    frames = streamClip(scene, motion, options, output, "the standard output", progress,
                        one.found.textures);
  }
  fmt::print(std::clog, "{}: wrote {} to the standard output\n", scene.name,
             countText(frames, "frame"));
  reportMotions(motions, std::clog);
  reportNotes(scene, motions, std::cerr);
  return reportIfUnmet(statusOf(timeline::allMet(motions)), false);
}

}  // namespace rotatebook::cli
