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

constexpr std::string_view kEvents =
    R"(<details class="events"><summary>{{"What happens"}}</summary>
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

Clip readClip(const scene::Scene& scene, const fs::path& folder, const Language& say) {
  Clip clip;
  clip.motions = scene.motions;
  clip.files = store::clipFiles(folder, scene.name);
  clip.csvs = store::csvFiles(clip.files.csv, scene);
  clip.videos = videosOf(scene, clip.files);
  clip.result = readClipResult(clip.files.json, scene, clip.videos.motion, say);
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
Html linksOf(const Clip& clip, const FigureFiles& files, const Language& say) {
  Html links;
  if (files.isPacked) {
    return linkItem(nameOf(clip.videos.played),
                    clip.videos.isMovingPicture ? say("Clip") : say("Clip, which holds its scene"));
  }
  for (std::size_t i = 0; i < clip.csvs.size(); ++i) {
    const std::string label = clip.csvs.size() > 1 ? ": " + say(clip.motions[i].label) : "";
    links += linkItem(nameOf(clip.csvs[i]), "CSV" + label);
  }
  for (const auto& [file, name] : clip.videos.linked) links += linkItem(nameOf(file), name);
  links += linkItem(nameOf(clip.files.json), say("Result (JSON)"));
  links += linkItem(nameOf(clip.files.poster), say("Poster"));
  const std::string folder = nameOf(clip.files.frameFolder) + "/";
  if (clip.hasFrames) links += linkItem(folder, say("PNG frames"));
  if (clip.hasRecord) links += linkItem(folder + nameOf(clip.files.sceneCopy), say("Scene"));
  return links;
}

std::vector<Check> allChecks(const Clip& clip) {
  std::vector<Check> all;
  for (const MotionResult& motion : clip.result.motions)
    all.insert(all.end(), motion.checks.begin(), motion.checks.end());
  return all;
}

Html tablesOf(const Clip& clip, const Language& say) {
  Html tables;
  for (std::size_t i = 0; i < clip.motions.size(); ++i) {
    const std::string& name = clip.motions[i].label;
    const std::string label = name.empty() ? "" : ": " + say(name);
    tables += checksTable(say("Expected and measured") + label, clip.result.motions[i].checks, say);
  }
  return tables;
}

Html divergenceOf(const scene::Scene& scene, const Clip& clip, const Language& say) {
  const auto note = [](const std::string& text) {
    return filled("<p class=\"note\">{{text}}</p>\n", {{"text", escaped(text)}});
  };
  const std::vector<MotionResult>& results = clip.result.motions;
  const auto diverged = std::ranges::count_if(
      results, [](const MotionResult& result) { return result.divergedAt.has_value(); });
  if (diverged == 0) return {};
  if (scene.grid)
    return note(say("{some} of {all} motions diverge.",
                    {{"some", std::to_string(diverged)}, {"all", std::to_string(results.size())}}));
  Html notes;
  for (std::size_t i = 0; i < results.size(); ++i) {
    if (!results[i].divergedAt) continue;
    const std::string time = say.numbers(roundedText(*results[i].divergedAt, kTimeDigits));
    const std::string& label = clip.motions[i].label;
    notes += note(label.empty() ? say("The motion diverges at {time} s.", {{"time", time}})
                                : say("{motion} diverges at {time} s.",
                                      {{"motion", say(label)}, {"time", time}}));
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
Html momentList(const std::vector<Moment>& moments, const Language& say) {
  if (moments.empty()) return {};
  Html items;
  for (const Moment& moment : moments) {
    items += filled(R"(<li><button type="button" data-frame="{{frame}}">{{words}}</button></li>)",
                    {{"frame", {std::to_string(moment.frame)}}, {"words", escaped(moment.words)}});
  }
  return filled(kEvents, {{"items", items}}, say);
}

/// Returns the video with its controls; of a GIF or APNG, which browsers don't tell the frame of,
/// the picture alone.
Html screenOf(const scene::Scene& scene, const Clip& clip, const Figure& figure,
              const std::string& poster, const Language& say) {
  std::map<std::string, Html> values{{"title", escaped(scene.title)},
                                     {"anchor", addressOf(scene.name)},
                                     {"width", {std::to_string(scene.clip.width)}},
                                     {"height", {std::to_string(scene.clip.height)}},
                                     {"poster", addressOf(poster)},
                                     {"thumbnail", addressOf(figure.thumbnail)},
                                     {"video", addressOf(figure.clip)}};
  if (clip.videos.isMovingPicture) return filled(movingPictureTemplate(), values, say);
  values["captions"] = addressOf(webVtt(scene, clip.result.events, clip.result.frames));
  values["last"] = {std::to_string(clip.result.frames - 1)};
  values["language"] = escaped(say.tag);
  return filled(videoTemplate(), values, say);
}

}  // namespace

Figure clipFigure(const scene::Scene& scene, const fs::path& folder, const FigureFiles& files,
                  const Language& say) {
  const Clip clip = readClip(scene, folder, say);
  const scene::Scene told = inLanguage(scene, say);
  const std::string poster = nameOf(clip.files.poster);
  const std::string thumbnail = files.hasThumbnails ? nameOfThumbnail(scene, folder) : poster;
  const FigureKind kind = clip.motions.size() > 1 ? FigureKind::Comparison : FigureKind::Clip;
  Figure figure{kind, scene.name, told.title, files.nameOfPicture(thumbnail)};
  figure.clip = nameOf(clip.videos.played);
  figure.frameRate = scene.clip.frameRate;
  figure.chapters = store::chaptersOf(scene);
  figure.pictures = {poster, thumbnail};
  const std::vector<Check> checks = allChecks(clip);
  figure.badge = unmetBadge(checks, say);
  figure.leftOut = clip.videos.leftOut;
  figure.section =
      filled(clipTemplate(),
             {{"id", escaped(scene.name)},
              {"anchor", addressOf(scene.name)},
              {"title", escaped(told.title)},
              {"badge", figure.badge},
              {"caption", captionOf(scene, say)},
              {"notes", divergenceOf(scene, clip, say)},
              {"toy", toyButton(scene, say)},
              {"width", {std::to_string(scene.clip.width)}},
              {"height", {std::to_string(scene.clip.height)}},
              {"screen", screenOf(told, clip, figure, files.nameOfPicture(poster), say)},
              {"events", momentList(momentsOf(told, clip.result), say)},
              {"settings", settingsTable(told.motions, scene.clip, say)},
              {"checks", foldedChecks(checks, tablesOf(clip, say), say)},
              {"links", linksOf(clip, files, say)},
              {"scene", sceneDetails(scene, say)},
              {"data", {clip.result.plots}}},
             say);
  return figure;
}

}  // namespace rotatebook::page
