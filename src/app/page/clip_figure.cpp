// The figure of a clip: its player, its plots, its expectations and measurements.
#include <algorithm>
#include <iterator>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "base/error.h"
#include "base/number_text.h"
#include "embedded/page.h"
#include "image/png_file.h"
#include "page/captions.h"
#include "page/clip_videos.h"
#include "page/expectation_table.h"
#include "page/figure.h"
#include "page/motion_data.h"
#include "page/motion_settings_table.h"
#include "store/clip_files.h"
#include "store/clip_record.h"
#include "system/read_file.h"
#include "timeline/clip_tables.h"
#include "timeline/simulate_scene.h"

namespace rotatebook::page {
namespace {

namespace fs = std::filesystem;

// Significant digits of a time.
constexpr int kTimeDigits = 4;

constexpr std::string_view kEvents = R"(<details class="events"><summary>What happens</summary>
<ol>{{items}}</ol></details>
)";

/// A clip's motions, simulated again, and its files.
struct Clip {
  std::vector<Motion> motions;
  std::int64_t frames = 0;
  store::ClipFiles files;
  std::vector<fs::path> csvs;  ///< See timeline::tableCount().
  ClipVideos videos;
  bool hasRecord = false;  ///< NAME/scene.toml is this scene's.
  bool hasFrames = false;  ///< All frames are beside it.
};

/// Throws InputError if a table beside the clip isn't that of the motion that the plots show.
void refuseOtherMotion(const std::vector<fs::path>& csvs, const timeline::ClipMotion& motion,
                       const scene::Scene& scene) {
  for (std::size_t i = 0; i < csvs.size(); ++i) {
    requireFile(csvs[i], scene, "render");
    if (system::readFileOrEmpty(csvs[i]) == timeline::tableText(scene, motion, i)) continue;
    throw InputError(csvs[i].string() + " was made from another scene or with other settings; " +
                     renderAgain(scene, csvs[i].parent_path()));
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
  throw InputError(poster.string() + ": " + difference + "; " +
                   renderAgain(scene, poster.parent_path()));
}

Clip readClip(const scene::Scene& scene, const fs::path& folder) {
  Clip clip;
  clip.files = store::clipFiles(folder, scene.name);
  clip.csvs = store::csvFiles(clip.files.csv, scene);
  clip.hasRecord = store::isRecordOfClip(scene, system::readFileOrEmpty(clip.files.sceneCopy));
  const timeline::ClipMotion motion = timeline::simulateScene(scene);
  clip.frames = motion.frameCount();
  clip.hasFrames =
      clip.hasRecord && std::ssize(store::framesIn(clip.files.frameFolder)) == clip.frames;
  refuseOtherMotion(clip.csvs, motion, scene);
  for (const scene::Panel& panel : scene::motionsOf(scene)) {
    const physics::Trajectory& trajectory = motion.trajectories()[clip.motions.size()];
    clip.motions.push_back({panel, trajectory});
  }
  clip.videos = videosOf(scene, clip.files);
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
    const std::string label = clip.csvs.size() > 1 ? ": " + clip.motions[i].panel.label : "";
    links += linkItem(nameOf(clip.csvs[i]), "CSV" + label);
  }
  for (const auto& [file, name] : clip.videos.linked) links += linkItem(nameOf(file), name);
  links += linkItem(nameOf(clip.files.poster), "Poster");
  const std::string folder = nameOf(clip.files.frameFolder) + "/";
  if (clip.hasFrames) links += linkItem(folder, "PNG frames");
  if (clip.hasRecord) links += linkItem(folder + nameOf(clip.files.sceneCopy), "Scene");
  return links;
}

std::vector<Check> allChecks(const Clip& clip) {
  std::vector<Check> all;
  for (const Motion& motion : clip.motions) {
    const std::vector<Check> checks = checksOf(motion);
    all.insert(all.end(), checks.begin(), checks.end());
  }
  return all;
}

Html tablesOf(const Clip& clip) {
  Html tables;
  for (const Motion& motion : clip.motions) {
    const std::string label = motion.panel.label.empty() ? "" : ": " + motion.panel.label;
    tables += checksTable("Expected and measured" + label, checksOf(motion));
  }
  return tables;
}

Html divergenceOf(const scene::Scene& scene, const Clip& clip) {
  Html notes;
  if (scene.grid) {
    const auto diverged = std::ranges::count_if(clip.motions, [](const Motion& motion) {
      return motion.trajectory.divergedAt.has_value();
    });
    if (diverged == 0) return notes;
    return filled("<p class=\"note\">{{text}}</p>\n",
                  {{"text", escaped(std::to_string(diverged) + " of " +
                                    std::to_string(clip.motions.size()) + " motions diverge.")}});
  }
  for (const Motion& motion : clip.motions) {
    if (!motion.trajectory.divergedAt) continue;
    const std::string who = motion.panel.label.empty() ? "The motion" : motion.panel.label;
    notes += filled(
        "<p class=\"note\">{{text}}</p>\n",
        {{"text", escaped(who + " diverges at " +
                          roundedText(*motion.trajectory.divergedAt, kTimeDigits) + " s.")}});
  }
  return notes;
}

/// Returns the motions of the plots: of a grid those in its corners.
std::vector<Motion> plottedMotions(const scene::Scene& scene, const Clip& clip) {
  if (!scene.grid) return clip.motions;
  const std::size_t columns = scene.grid->columnCount(), last = clip.motions.size() - 1;
  std::vector<Motion> corners;
  for (const std::size_t i : std::set{std::size_t{0}, columns - 1, last + 1 - columns, last}) {
    corners.push_back(clip.motions[i]);
  }
  return corners;
}

/// Returns the events as a list, folded away; each is a button for its frame. Empty without events.
Html eventList(const std::vector<Event>& events) {
  if (events.empty()) return {};
  Html items;
  for (const Event& event : events) {
    items += filled(R"(<li><button type="button" data-frame="{{frame}}">{{words}}</button></li>)",
                    {{"frame", {std::to_string(event.frame)}}, {"words", escaped(event.words)}});
  }
  return filled(kEvents, {{"items", items}});
}

/// Returns the video with its controls; of a GIF or APNG, which browsers don't tell the frame of,
/// the picture alone.
Html screenOf(const scene::Scene& scene, const Clip& clip, const Figure& figure,
              const std::string& poster, const std::vector<Event>& events) {
  std::map<std::string, Html> values{{"title", escaped(scene.title)},
                                     {"anchor", addressOf(scene.name)},
                                     {"width", {std::to_string(scene.clip.width)}},
                                     {"height", {std::to_string(scene.clip.height)}},
                                     {"poster", addressOf(poster)},
                                     {"thumbnail", addressOf(figure.thumbnail)},
                                     {"video", addressOf(figure.clip)}};
  if (clip.videos.isMovingPicture) return filled(movingPictureTemplate(), values);
  values["captions"] = addressOf(webVtt(events, scene.clip.frameRate, clip.frames));
  values["last"] = {std::to_string(clip.frames - 1)};
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
  figure.pictures = {poster, thumbnail};
  // A whole grid would have hundreds.
  const std::vector<Event> events =
      scene.grid ? std::vector<Event>{} : eventsOf(clip.motions, clip.frames);
  const std::vector<Check> checks = allChecks(clip);
  figure.badge = unmetBadge(checks);
  figure.leftOut = clip.videos.leftOut;
  figure.section =
      filled(clipTemplate(),
             {{"id", escaped(scene.name)},
              {"anchor", addressOf(scene.name)},
              {"title", escaped(scene.title)},
              {"badge", figure.badge},
              {"caption", escaped(scene.caption)},
              {"notes", divergenceOf(scene, clip)},
              {"width", {std::to_string(scene.clip.width)}},
              {"height", {std::to_string(scene.clip.height)}},
              {"screen", screenOf(scene, clip, figure, files.nameOfPicture(poster), events)},
              {"events", eventList(events)},
              {"settings", settingsTable(clip.motions, scene.clip)},
              {"checks", foldedChecks(checks, tablesOf(clip))},
              {"links", linksOf(clip, files)},
              {"scene", sceneDetails(scene)},
              {"data",
               {motionData(plottedMotions(scene, clip), scene, clip.frames, clip.videos.motion)}}});
  return figure;
}

}  // namespace rotatebook::page
