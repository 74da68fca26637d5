// One scene's part of the page. Inside the room only.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "page/html.h"
#include "scene/scene.h"
#include "video/clip_reader.h"

namespace rotatebook::page {

/// What a scene left in the folder, and with it how it is shown.
enum class FigureKind { Still, Clip, Comparison, Study };

struct Figure {
  FigureKind kind = FigureKind::Clip;
  std::string id;     ///< The scene's name; the section's anchor.
  std::string title;  ///< The scene's.
  /// The picture that stands for it, relative to the page: its poster, unless somebody draws one
  /// without words.
  std::string thumbnail;
  Html curves{};   ///< A study's plot without words, as <svg>, which stands for it instead.
  Html badge{};    ///< How many of its expectations are met, unless all are.
  Html section{};  ///< The whole <section>.
  /// "out/a.gif isn't linked: WHY" of each file that has the name of the scene's, but isn't.
  std::vector<std::string> leftOut{};
};

/// The figure of `scene` from what was made of it in `folder`: a study if it has [study], a still
/// if there is a NAME.png but no clip, else a clip. Throws InputError, naming the file and the
/// remedy, if one is missing or was made of something else than this scene.
Figure readFigure(const scene::Scene& scene, const std::filesystem::path& folder);

/// Those of one kind. Inside the room only.
Figure clipFigure(const scene::Scene& scene, const std::filesystem::path& folder);
Figure studyFigure(const scene::Scene& scene, const std::filesystem::path& folder);

/// Throws InputError "PATH is missing; ...: rotatebook COMMAND SCENE -o FOLDER" if there is no such
/// file. Inside the room only.
void requireFile(const std::filesystem::path& path, const scene::Scene& scene,
                 const std::string& command);
/// "render it again (or give this command the same --size and --set): rotatebook render ..." Inside
/// the room only.
std::string renderAgain(const scene::Scene& scene, const std::filesystem::path& folder);
/// "its pictures are 640x800, and the scene's are 1280x720"; empty if they aren't. Inside the room
/// only.
std::string otherSizeText(const video::PictureSize& size, const scene::Scene& scene);
/// "rotatebook COMMAND scenes/a.toml -o out". Inside the room only.
std::string remedy(const std::string& command, const scene::Scene& scene,
                   const std::filesystem::path& folder);

/// A link to a file beside the page, as an item of a list. Inside the room only.
Html linkItem(const std::string& address, const std::string& text);
/// The scene's text with every default explicit, to be unfolded. Inside the room only.
Html sceneDetails(const scene::Scene& scene);

}  // namespace rotatebook::page
