// A scene's part of the page. Inside the room only.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/frame_rate.h"
#include "page/html.h"
#include "scene/scene.h"
#include "video/clip_reader.h"
#include "video/video_settings.h"

namespace rotatebook::page {

/// The kind of a scene's results, which decides how they are shown.
enum class FigureKind { Still, Clip, Comparison, Study, Map };

/// Properties of the files beside the page.
struct FigureFiles {
  /// True if NAME.thumbnail.png is there or will be; else posters stand for thumbnails.
  bool hasThumbnails = false;
  /// True if the page is for the web, with the files that packFiles() leaves: no tables of clips,
  /// frames and arrays.
  bool isPacked = false;

  /// Returns the name that a picture named "a.png" has there: "a.webp" if the page is for the web.
  std::string nameOfPicture(const std::string& png) const;
};

/// A scene's section of the page, and its item in the overview.
struct Figure {
  FigureKind kind = FigureKind::Clip;
  std::string id;     ///< The scene's name; the section's anchor.
  std::string title;  ///< The scene's.
  /// The overview's picture, relative to the page.
  std::string thumbnail{};
  Html badge{};    ///< The number of expectations met, unless all are.
  Html section{};  ///< The whole <section>.
  /// "out/a.gif isn't linked: WHY" for each file under the scene's name that isn't the scene's.
  std::vector<std::string> leftOut{};
  std::string clip{};     ///< The video that is played; empty of stills, studies and maps.
  FrameRate frameRate{};  ///< Of the clip.
  std::vector<video::Chapter> chapters{};  ///< Likewise.
  /// Its PNGs that a page for the web has as WebP: of posters, thumbnails and stills.
  std::vector<std::string> pictures{};
  std::vector<std::string> files{};  ///< Its other files that a page for the web has.
};

/// Reads the figure of `scene` from its results in `folder`: a study if it has [study], a map if
/// it has [map], a still if
/// there is a NAME.png but no clip, else a clip. Throws InputError, naming the file and the remedy,
/// if a file is missing or was made from something else than this scene.
Figure readFigure(const scene::Scene& scene, const std::filesystem::path& folder,
                  const FigureFiles& files = {}, const Language& say = {});

/// Read the figure of a clip or comparison, of a study and of a map. Inside the room only.
Figure clipFigure(const scene::Scene& scene, const std::filesystem::path& folder,
                  const FigureFiles& files, const Language& say);
Figure studyFigure(const scene::Scene& scene, const std::filesystem::path& folder,
                   const Language& say);
Figure mapFigure(const scene::Scene& scene, const std::filesystem::path& folder,
                 const FigureFiles& files, const Language& say);

/// Throws InputError "PATH is missing; ...: rotatebook COMMAND SCENE -o FOLDER" if there is no such
/// file. Inside the room only.
void requireFile(const std::filesystem::path& path, const scene::Scene& scene,
                 const std::string& command);
/// Returns "render it again (or give this command the same --size and --set): rotatebook render
/// ..." Inside the room only.
std::string renderAgain(const scene::Scene& scene, const std::filesystem::path& folder);
/// Returns "its pictures are 640x800, and the scene's are 1280x720"; empty if the sizes are equal.
/// Inside the room only.
std::string otherSizeText(const video::PictureSize& size, const scene::Scene& scene);
/// Returns "rotatebook COMMAND scenes/a.toml -o out". Inside the room only.
std::string remedy(const std::string& command, const scene::Scene& scene,
                   const std::filesystem::path& folder);

/// Returns "NAME.thumbnail.png". Inside the room only.
std::string nameOfThumbnail(const scene::Scene& scene, const std::filesystem::path& folder);

/// Returns a link to a file beside the page, as an item of a list. Inside the room only.
Html linkItem(const std::string& address, const std::string& text);

/// Returns the name of a file's format, by its ending: "PNG".
std::string formatOf(const std::filesystem::path& file);
/// Returns the button for the live book; empty if a motion was recorded, as the page doesn't hold
/// recordings. Inside the room only.
Html toyButton(const scene::Scene& scene, const Language& say);
/// Returns the scene's caption, from the attributes of its element on. Its class says if the
/// picture has it in the same words. Inside the room only.
Html captionOf(const scene::Scene& scene, const Language& say);
/// Returns the scene's text, folded away. Inside the room only.
Html sceneDetails(const scene::Scene& scene, const Language& say);

}  // namespace rotatebook::page
