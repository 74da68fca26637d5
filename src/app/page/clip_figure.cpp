// The figure of a clip: its player, its plots, its expectations and measurements.
#include <algorithm>
#include <iterator>
#include <map>
#include <string>
#include <vector>

#include <fmt/core.h>

#include "base/error.h"
#include "base/number_text.h"
#include "base/text.h"
#include "embedded/page.h"
#include "image/png_file.h"
#include "page/clip_result.h"
#include "page/clip_videos.h"
#include "page/expectation_table.h"
#include "page/figure.h"
#include "page/motion_settings_table.h"
#include "store/clip_files.h"
#include "store/clip_record.h"
#include "store/encoding.h"
#include "system/read_file.h"
#include "timeline/web_vtt.h"

namespace rotatebook::page {
namespace {

namespace fs = std::filesystem;

// Significant digits of a time.
constexpr int kTimeDigits = 4;

constexpr std::string_view kEvents = R"(<details class="events"><summary>What happens</summary>
<ol>{{items}}</ol></details>
)";

/// A clip's motions, its result and its files.
struct Clip {
  std::vector<scene::Panel> motions;
  ClipResult result;
  store::ClipFiles files;
  std::vector<fs::path> csvs;  ///< See timeline::tableCount().
  ClipVideos videos;
  bool hasRecord = false;  ///< NAME/scene.toml is this scene's.
  bool hasFrames = false;  ///< All frames are beside it.
};

/// Throws InputError if a table beside the clip isn't of its scene.
void refuseOtherTables(const Clip& clip, const scene::Scene& scene) {
  for (const fs::path& csv : clip.csvs) {
    requireFile(csv, scene, "render");
    if (!areOfOtherScenes(clip.files, clip.videos.played, csv)) continue;
    throw InputError(fmt::format("{} was made from another scene or with other settings; {}",
                                 csv.string(), renderAgain(scene, csv.parent_path())));
  }
}

void refuseOtherPoster(const Clip& clip, const scene::Scene& scene) {
  const fs::path& poster = clip.files.poster;
  const image::Image picture = image::readPng(poster);
  std::string difference = otherSizeText({picture.width(), picture.height()}, scene);
  if (difference.empty() && areOfOtherScenes(clip.files, clip.videos.played, poster)) {
    difference = kOtherSettings;
  }
  if (difference.empty()) return;
  throw InputError(fmt::format("{}: {}; {}", poster.string(), difference,
                               renderAgain(scene, poster.parent_path())));
}

Clip readClip(const scene::Scene& scene, const fs::path& folder) {
  Clip clip;
  clip.motions = scene.motions;
  clip.files = store::clipFiles(folder, scene.name);
  clip.csvs = store::csvFiles(clip.files.csv, scene);
  clip.videos = videosOf(scene, clip.files);
  clip.result = readClipResult(clip.files.json, scene, clip.videos.motion);
  clip.hasRecord = store::isRecordOfClip(scene, system::readFileOrEmpty(clip.files.sceneCopy));
  clip.hasFrames =
      clip.hasRecord && std::ssize(store::framesIn(clip.files.frameFolder)) == clip.result.frames;
  refuseOtherTables(clip, scene);
  requireFile(clip.files.poster, scene, "render");
  refuseOtherPoster(clip, scene);
  return clip;
}

std::string nameOf(const fs::path& file) {
  return file.filename().string();
}

/// On the web, the clip alone: it holds its scene, which makes all other files again.
Html linksOf(const Clip& clip, const FigureFiles& files) {
  Html links;
  if (files.isPacked) {
    return linkItem(nameOf(clip.videos.played),
                    clip.videos.isMovingPicture ? "Clip" : "Clip, which holds its scene");
  }
  for (std::size_t i = 0; i < clip.csvs.size(); ++i) {
    const std::string label = clip.csvs.size() > 1 ? ": " + clip.motions[i].label : "";
    links += linkItem(nameOf(clip.csvs[i]), "CSV" + label);
  }
  for (const auto& [file, name] : clip.videos.linked) links += linkItem(nameOf(file), name);
  links += linkItem(nameOf(clip.files.json), "Result (JSON)");
  links += linkItem(nameOf(clip.files.poster), "Poster");
  const std::string folder = nameOf(clip.files.frameFolder) + "/";
  if (clip.hasFrames) links += linkItem(folder, "PNG frames");
  if (clip.hasRecord) links += linkItem(folder + nameOf(clip.files.sceneCopy), "Scene");
  return links;
}

std::vector<Check> allChecks(const Clip& clip) {
  std::vector<Check> all;
  for (const MotionResult& motion : clip.result.motions)
    all.insert(all.end(), motion.checks.begin(), motion.checks.end());
  return all;
}

Html tablesOf(const Clip& clip) {
  Html tables;
  for (std::size_t i = 0; i < clip.motions.size(); ++i) {
    const std::string& name = clip.motions[i].label;
    const std::string label = name.empty() ? "" : ": " + name;
    tables += checksTable("Expected and measured" + label, clip.result.motions[i].checks);
  }
  return tables;
}

Html divergenceOf(const scene::Scene& scene, const Clip& clip) {
  const auto note = [](const std::string& text) {
    return filled("<p class=\"note\">{{text}}</p>\n", {{"text", escaped(text)}});
  };
  const std::vector<MotionResult>& results = clip.result.motions;
  const auto diverged = std::ranges::count_if(
      results, [](const MotionResult& result) { return result.divergedAt.has_value(); });
  if (diverged == 0) return {};
  if (scene.grid) return note(fmt::format("{} of {} motions diverge.", diverged, results.size()));
  Html notes;
  for (std::size_t i = 0; i < results.size(); ++i) {
    if (!results[i].divergedAt) continue;
    const std::string& label = clip.motions[i].label;
    notes += note(fmt::format("{} diverges at {} s.", label.empty() ? "The motion" : label,
                              roundedText(*results[i].divergedAt, kTimeDigits)));
  }
  return notes;
}

/// A moment of a clip to go to.
struct Moment {
  std::int64_t frame = 0;
  std::string words;
};

/// Returns chapters, captions and events in the order of their frames.
std::vector<Moment> momentsOf(const scene::Scene& scene, const ClipResult& result) {
  std::vector<Moment> moments;
  for (const scene::ShownCue& shown : scene.shownCues) {
    const auto& [at, text, hold, chapter, move] = scene.cues[shown.cue];
    if (shown.frame >= result.frames) continue;
    const std::string words = joined({chapter, oneLine(text.value_or(""))}, ": ");
    if (!words.empty()) moments.push_back({shown.frame, words});
  }
  for (const timeline::ClipEvent& event : result.events)
    moments.push_back({event.frame, eventText(event, scene.overlay.words)});
  std::ranges::stable_sort(moments, {}, &Moment::frame);
  return moments;
}

/// Returns the moments as a list, folded away; each is a button for its frame. Empty without any.
Html momentList(const std::vector<Moment>& moments) {
  if (moments.empty()) return {};
  Html items;
  for (const Moment& moment : moments) {
    items += filled(R"(<li><button type="button" data-frame="{{frame}}">{{words}}</button></li>)",
                    {{"frame", {std::to_string(moment.frame)}}, {"words", escaped(moment.words)}});
  }
  return filled(kEvents, {{"items", items}});
}

/// Returns the video with its controls; of a GIF or APNG, which browsers don't tell the frame of,
/// the picture alone.
Html screenOf(const scene::Scene& scene, const Clip& clip, const Figure& figure,
              const std::string& poster) {
  std::map<std::string, Html> values{{"title", escaped(scene.title)},
                                     {"anchor", addressOf(scene.name)},
                                     {"width", {std::to_string(scene.clip.width)}},
                                     {"height", {std::to_string(scene.clip.height)}},
                                     {"poster", addressOf(poster)},
                                     {"thumbnail", addressOf(figure.thumbnail)},
                                     {"video", addressOf(figure.clip)}};
  if (clip.videos.isMovingPicture) return filled(movingPictureTemplate(), values);
  values["captions"] = addressOf(webVtt(scene, clip.result.events, clip.result.frames));
  values["last"] = {std::to_string(clip.result.frames - 1)};
  return filled(videoTemplate(), values);
}

}  // namespace

Figure clipFigure(const scene::Scene& scene, const fs::path& folder, const FigureFiles& files) {
  const Clip clip = readClip(scene, folder);
  const std::string poster = nameOf(clip.files.poster);
  const std::string thumbnail = files.hasThumbnails ? nameOfThumbnail(scene, folder) : poster;
  const FigureKind kind = clip.motions.size() > 1 ? FigureKind::Comparison : FigureKind::Clip;
  Figure figure{kind, scene.name, scene.title, files.nameOfPicture(thumbnail)};
  figure.clip = nameOf(clip.videos.played);
  figure.frameRate = scene.clip.frameRate;
  figure.chapters = store::chaptersOf(scene);
  figure.pictures = {poster, thumbnail};
  const std::vector<Check> checks = allChecks(clip);
  figure.badge = unmetBadge(checks);
  figure.leftOut = clip.videos.leftOut;
  figure.section = filled(clipTemplate(),
                          {{"id", escaped(scene.name)},
                           {"anchor", addressOf(scene.name)},
                           {"title", escaped(scene.title)},
                           {"badge", figure.badge},
                           {"caption", escaped(scene.caption)},
                           {"notes", divergenceOf(scene, clip)},
                           {"width", {std::to_string(scene.clip.width)}},
                           {"height", {std::to_string(scene.clip.height)}},
                           {"screen", screenOf(scene, clip, figure, files.nameOfPicture(poster))},
                           {"events", momentList(momentsOf(scene, clip.result))},
                           {"settings", settingsTable(clip.motions, scene.clip)},
                           {"checks", foldedChecks(checks, tablesOf(clip))},
                           {"links", linksOf(clip, files)},
                           {"scene", sceneDetails(scene)},
                           {"data", {clip.result.plots}}});
  return figure;
}

}  // namespace rotatebook::page
