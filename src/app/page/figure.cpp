#include "page/figure.h"

#include <algorithm>

#include <fmt/core.h>

#include "base/error.h"
#include "base/text.h"
#include "embedded/page.h"
#include "image/png_file.h"
#include "scene/scene_text.h"
#include "store/clip_files.h"

namespace rotatebook::page {
namespace {

namespace fs = std::filesystem;

Figure stillFigure(const scene::Scene& scene, const fs::path& folder, const FigureFiles& files,
                   const Language& say) {
  const std::string png = scene.name + ".png";
  const image::Image pixels = image::readPng(folder / png);
  const std::string thumbnail = files.hasThumbnails ? nameOfThumbnail(scene, folder) : png;
  const std::string picture = files.nameOfPicture(png);
  Figure figure{FigureKind::Still, scene.name, say(scene.title), files.nameOfPicture(thumbnail)};
  figure.pictures = {png, thumbnail};
  figure.section = filled(stillTemplate(),
                          {{"id", escaped(scene.name)},
                           {"anchor", addressOf(scene.name)},
                           {"title", escaped(figure.title)},
                           {"picture", addressOf(picture)},
                           {"width", {std::to_string(pixels.width())}},
                           {"height", {std::to_string(pixels.height())}},
                           {"caption", captionOf(scene, say)},
                           {"toy", toyButton(scene, say)},
                           {"links", linkItem(picture, files.isPacked ? say("Picture") : "PNG")},
                           {"scene", sceneDetails(scene, say)}},
                          say);
  return figure;
}

/// Returns whether all pictures of the scene show its caption, and no cue's in its place.
bool drawsCaption(const scene::Scene& scene) {
  return shows(scene, scene::Overlay::Caption) &&
         std::ranges::none_of(scene.cues,
                              [](const scene::Cue& cue) { return cue.text.has_value(); });
}

bool isStill(const scene::Scene& scene, const fs::path& folder) {
  return fs::exists(folder / (scene.name + ".png")) &&
         !fs::exists(store::clipFiles(folder, scene.name).csv);
}

}  // namespace

std::string FigureFiles::nameOfPicture(const std::string& png) const {
  return isPacked ? fs::path(png).replace_extension(".webp").string() : png;
}

Figure readFigure(const scene::Scene& scene, const fs::path& folder, const FigureFiles& files,
                  const Language& say) {
  if (scene.study) return studyFigure(scene, folder, say);
  if (scene.map) return mapFigure(scene, folder, files, say);
  return isStill(scene, folder) ? stillFigure(scene, folder, files, say)
                                : clipFigure(scene, folder, files, say);
}

std::string nameOfThumbnail(const scene::Scene& scene, const fs::path& folder) {
  return store::clipFiles(folder, scene.name).thumbnail.filename().string();
}

std::string remedy(const std::string& command, const scene::Scene& scene, const fs::path& folder) {
  return fmt::format("rotatebook {} {} -o {}", command,
                     shellWord((scene.folder / (scene.name + ".toml")).string()),
                     shellWord(folder.string()));
}

std::string renderAgain(const scene::Scene& scene, const fs::path& folder) {
  return "render it again (or give this command the same --size and --set): " +
         remedy("render", scene, folder);
}

std::string otherSizeText(const video::PictureSize& size, const scene::Scene& scene) {
  const scene::ClipSettings& clip = scene.clip;
  if (size.width == clip.width && size.height == clip.height) return "";
  return fmt::format("its pictures are {}, and the scene's are {}",
                     sizeText(size.width, size.height), sizeText(clip.width, clip.height));
}

void requireFile(const fs::path& path, const scene::Scene& scene, const std::string& command) {
  if (fs::is_regular_file(path)) return;
  throw InputError(fmt::format("{} is missing; {} it first: {}", path.string(),
                               command == "render" ? "render" : "make",
                               remedy(command, scene, path.parent_path())));
}

Html linkItem(const std::string& address, const std::string& text) {
  return filled(R"(<li><a href="{{address}}">{{text}}</a></li>)",
                {{"address", addressOf(address)}, {"text", escaped(text)}});
}

std::string formatOf(const fs::path& file) {
  std::string name = file.extension().string().substr(1);
  for (char& letter : name) letter = static_cast<char>(letter - 'a' + 'A');
  return name;
}

Html toyButton(const scene::Scene& scene, const Language& say) {
  const bool isRecorded = std::ranges::any_of(scene.motions, [](const auto& panel) {
    return panel.simulation.model == physics::Model::Recorded;
  });
  if (isRecorded) return {};
  return filled(
      "<p class=\"toy\" hidden><button type=\"button\">{{\"Play with this\"}}</button></p>\n", {},
      say);
}

Html captionOf(const scene::Scene& scene, const Language& say) {
  const std::string text = say(scene.caption);
  const bool isDrawn = scene.map || (!scene.study && drawsCaption(scene));
  return filled(R"(class="{{class}}" id="{{anchor}}/caption">{{text}})",
                {{"class", {isDrawn && text == scene.caption ? "caption drawn" : "caption"}},
                 {"anchor", addressOf(scene.name)},
                 {"text", escaped(text)}});
}

Html sceneDetails(const scene::Scene& scene, const Language& say) {
  return filled(
      "<details><summary>{{\"The scene\"}}</summary><pre class=\"scene\" "
      "tabindex=\"0\">{{text}}</pre></details>",
      {{"text", escaped(briefText(scene))}}, say);
}

}  // namespace rotatebook::page
