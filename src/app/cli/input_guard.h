// The files that a command reads, and those that it would replace: none that it is made from, and
// none of others. Inside the room only.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "pipeline/render_clip.h"
#include "scene/scene.h"
#include "store/footprint.h"
#include "store/result_owners.h"

namespace rotatebook::cli {

/// A file that a command reads.
struct Input {
  std::filesystem::path path;
  std::string what;  ///< Its description in messages: "the scene itself".
};

/// Returns the files that `scene` names.
std::vector<Input> inputsOf(const scene::Scene& scene);
/// Returns these and the scene's own file, at `path`.
std::vector<Input> inputsOf(const std::filesystem::path& path, const scene::Scene& scene);

/// Scenes, and the files that they are made from.
struct ReadScenes {
  std::vector<scene::Scene> scenes;
  std::vector<Input> inputs;
};

/// Reads all scenes before anything is written, so that a mistake in the last one costs nothing.
ReadScenes readAllScenes(const std::vector<std::string>& paths,
                         const std::function<scene::Scene(const std::string& path)>& read);

/// Returns the names that a render of `scene` writes, moves or removes.
store::Footprint footprintOf(const scene::Scene& scene, const pipeline::RenderOptions& options);

/// Throws InputError "INPUT is WHAT and would be replaced; `remedy`" if the command with
/// `footprint` would write, move or remove one of `inputs`, under whatever name.
void refuseInputs(const store::Footprint& footprint, const std::vector<Input>& inputs,
                  const std::string& remedy = "name another folder with -o");

/// Throws likewise if the single file `output` is one of `inputs`.
void refuseInputs(const std::filesystem::path& output, const std::vector<Input>& inputs,
                  const std::string& remedy = "name another file with -o");

/// Throws InputError if the render (of `formats`), map, film or study of `scene` would replace in
/// `folder` one of `inputs`, or what it didn't leave.
void refuseLosses(store::ResultKind kind, const scene::Scene& scene,
                  const std::filesystem::path& folder, const std::vector<Input>& inputs,
                  const std::vector<video::VideoFormat>& formats = {});

/// Throws InputError if `output`, the value of `option`, hasn't the ending of its format: a clip,
/// for example, isn't to be replaced by a picture. `others` names what else it may end in.
void requireEnding(const std::filesystem::path& output, const std::string& ending,
                   const std::string& option = "-o", const std::string& others = "");

/// Throws InputError if a command that draws the single picture `output` reads it, if it isn't
/// named .png, or if it belongs to a clip, a map or a study, or has no mark of the program.
void requirePictureOutput(const std::filesystem::path& output, const std::vector<Input>& inputs);

/// Throws InputError if there is something at `path`.
void requireAbsent(const std::filesystem::path& path);

/// Likewise, unless it is a file with this beginning, as an earlier result has it.
void requireAbsentOr(const std::filesystem::path& path, std::string_view beginning);

}  // namespace rotatebook::cli
