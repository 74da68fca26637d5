#include "cli/render_report.h"

#include <algorithm>
#include <filesystem>

#include <fmt/ostream.h>

#include "base/json.h"
#include "base/number_text.h"
#include "base/text.h"
#include "cli/motion_report.h"
#include "store/other_settings.h"
#include "system/machine.h"

namespace rotatebook::cli {
namespace {

namespace fs = std::filesystem;

/// Returns the number of threads of all encoders.
int encoderThreads(const scene::Scene& scene, const pipeline::RenderOptions& options) {
  int threads = 0;
  for (const video::VideoFormat format : formatsOf(options.outputs)) {
    threads += rowOf(format).usesThreads ? scene.video.threads : 1;
  }
  return threads;
}

/// Returns the videos, tables, captions and poster that a render left, or an earlier run if it was
/// done.
std::vector<fs::path> filesOf(const pipeline::RenderResult& result,
                              const pipeline::RenderOptions& options) {
  std::vector<fs::path> files;
  for (const video::VideoFormat format : formatsOf(options.outputs)) {
    if (result.framesWritten == 0 && !result.wasDone) break;
    files.push_back(result.interrupted ? result.files.partialVideo(format)
                                       : result.files.video(format));
  }
  if (result.interrupted) return files;
  files.insert(files.end(), result.csvs.begin(), result.csvs.end());
  if (!result.files.json.empty()) files.push_back(result.files.json);
  if (!result.captions.empty()) files.push_back(result.captions);
  if (!options.isPart()) files.push_back(result.files.poster);
  return files;
}

/// Returns the folder of the PNGs, with a slash at its end; empty if there are none.
std::string frameFolder(const pipeline::RenderResult& result,
                        const pipeline::RenderOptions& options) {
  if (!hasPng(options.outputs) || (result.framesWritten == 0 && !result.wasDone)) return "";
  const bool isNew = result.interrupted && !options.isPart();
  return (isNew ? result.files.partialFrameFolder : result.files.frameFolder).string() + '/';
}

std::string writtenText(const pipeline::RenderResult& result,
                        const pipeline::RenderOptions& options) {
  std::vector<std::string> items;
  for (const fs::path& file : filesOf(result, options)) items.push_back(file.string());
  if (const std::string folder = frameFolder(result, options); !folder.empty()) {
    items.push_back(countText(result.framesWritten, "frame") + " in " + folder);
  }
  return listed(items);
}

/// Notes what became of the outputs `items` of other settings; of those with unknown ones, the
/// items say so themselves. `start` begins each line: "note: tiny: kept ".
void noteOtherSettings(const std::string& start, std::vector<std::string> items,
                       std::ostream& out) {
  const auto isKnown = [](const std::string& item) {
    return !item.ends_with(store::kUnknownSettings);
  };
  const auto unknown = std::stable_partition(items.begin(), items.end(), isKnown);
  const std::vector<std::string> known(items.begin(), unknown);
  const std::vector<std::string> others(unknown, items.end());
  if (!known.empty()) out << start + oneLine(listed(known)) + ", made with other settings\n";
  if (!others.empty()) out << start + oneLine(listed(others)) + '\n';
}

Json resultJson(const pipeline::RenderResult& result, const pipeline::RenderOptions& options) {
  const auto pathOf = [](const fs::path& file) { return file.string(); };
  return {{"frames_written", result.framesWritten},
          {"frames_kept", result.framesKept},
          {"files", arrayOf(filesOf(result, options), pathOf)},
          {"frame_folder", orNull(frameFolder(result, options))},
          {"replaced", result.replaced},
          {"kept_of_other_settings", result.others},
          {"note", orNull(result.remainder)}};
}

}  // namespace

void reportStart(const RenderedScene& rendered, const pipeline::RenderOptions& options,
                 std::ostream& out) {
  const scene::Scene& scene = rendered.scene;
  const pipeline::RenderStart& start = *rendered.start;
  fmt::print(out, "{}: {}\n  {} at {} frames/s, {} s", scene.name, scene.title,
             sizeText(scene.clip.width, scene.clip.height), scene.clip.frameRate.text(),
             shortestText(scene.clip.duration));
  if (rendered.isDetailed) {
    fmt::print(
        out, "; renderer {}{}\n  threads: 1 draws (a software rasteriser has its own), 1 composes",
        start.renderer, start.encoders.empty() ? "" : "; encoder " + start.encoders);
    const int png = start.pngThreads, encoders = encoderThreads(scene, options);
    if (png > 0) fmt::print(out, ", {} {} PNGs", png, png == 1 ? "compresses" : "compress");
    if (encoders > 0) fmt::print(out, ", {} {}", encoders, encoders == 1 ? "encodes" : "encode");
    fmt::print(out, "; cores: {}", system::coreCount());
  }
  out << '\n';
}

void reportRender(const RenderedScene& rendered, const pipeline::RenderOptions& options,
                  std::ostream& out) {
  const std::string& name = rendered.scene.name;
  if (!rendered.result) {
    fmt::print(out, "{}: interrupted while simulating; nothing was written\n", name);
    return;
  }
  const pipeline::RenderResult& result = *rendered.result;
  if (result.wasDone) fmt::print(out, "{}: already done\n", name);
  if (options.part && result.framesWritten == 0 && !result.interrupted) {
    fmt::print(out, "{}: this part has no frames; nothing was written\n", name);
    return;
  }
  if (result.framesKept > 0) {
    fmt::print(out, "  kept {} of an earlier run\n", countText(result.framesKept, "frame"));
  }
  if (result.interrupted && result.framesWritten == 0) {
    out << "  interrupted before the first frame; nothing was written\n";
    return;
  }
  if (!result.wasDone) fmt::print(out, "  wrote {}\n", oneLine(writtenText(result, options)));
  if (!result.interrupted) return reportMotions(rendered.motions, out);
  fmt::print(out, "  interrupted after {}{}\n", countText(result.framesWritten, "frame"),
             hasPng(options.outputs) ? "; go on with the same command and --resume" : "");
}

void reportRenderNotes(const RenderedScene& rendered, std::ostream& out) {
  if (!rendered.result) return;
  const pipeline::RenderResult& result = *rendered.result;
  const std::string start = fmt::format("note: {}: ", rendered.scene.name);
  noteOtherSettings(start + "replaced ", result.replaced, out);
  noteOtherSettings(start + "kept ", result.others, out);
  if (!result.remainder.empty()) out << start + result.remainder + '\n';
  if (!result.interrupted) reportNotes(rendered.scene, rendered.motions, out);
}

Json renderJson(const RenderedScene& rendered, const pipeline::RenderOptions& options) {
  const scene::Scene& scene = rendered.scene;
  const pipeline::RenderStart start = rendered.start.value_or(pipeline::RenderStart{});
  pipeline::RenderResult none;
  none.interrupted = true;
  Json object{{"name", scene.name},
              {"title", scene.title},
              {"width", scene.clip.width},
              {"height", scene.clip.height},
              {"frames_per_second",
               1.0 * scene.clip.frameRate.numerator / scene.clip.frameRate.denominator},
              {"duration_s", scene.clip.duration},
              {"renderer", orNull(start.renderer)},
              {"encoders", orNull(start.encoders)},
              {"already_done", rendered.result && rendered.result->wasDone},
              {"interrupted", rendered.interrupted},
              {"error", orNull(rendered.error)}};
  object.update(resultJson(rendered.result.value_or(none), options));
  object["motions"] = motionsJson(rendered.motions);
  return object;
}

}  // namespace rotatebook::cli
