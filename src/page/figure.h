// One scene's part of the page.
#pragma once

#include <filesystem>
#include <string>

#include "page/html.h"
#include "scene/scene.h"

namespace rotatebook::page {

/// What a scene left in the folder, and with it how it is shown.
enum class FigureKind { Still, Clip, Comparison, Study };

struct Figure {
  FigureKind kind = FigureKind::Clip;
  std::string id;         ///< The scene's name; the section's anchor.
  std::string title;      ///< The scene's.
  std::string thumbnail;  ///< The picture that stands for it, relative to the page.
  Html badge;             ///< How many of its expectations are met.
  Html section;           ///< The whole <section>.
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
/// "rotatebook COMMAND scenes/a.toml -o out". Inside the room only.
std::string remedy(const std::string& command, const scene::Scene& scene,
                   const std::filesystem::path& folder);

/// A link to a file beside the page, as an item of a list. Inside the room only.
Html linkItem(const std::string& address, const std::string& words);
/// The scene's text with every default explicit, to be unfolded. Inside the room only.
Html sceneDetails(const scene::Scene& scene);

}  // namespace rotatebook::page
