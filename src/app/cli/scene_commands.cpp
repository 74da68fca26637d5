#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <system_error>
#include <vector>

#include <fmt/ostream.h>
#include <glib.h>

#include "base/document/toml_text.h"
#include "base/error.h"
#include "base/json.h"
#include "base/number_text.h"
#include "base/text.h"
#include "cli/commands.h"
#include "cli/exit_code.h"
#include "cli/input_guard.h"
#include "cli/installed_file.h"
#include "cli/motion_report.h"
#include "cli/option_checks.h"
#include "cli/scene_options.h"
#include "embedded/cli.h"
#include "picture/preflight.h"
#include "scene/scene_schema.h"
#include "scene/scene_text.h"
#include "store/scene_file.h"
#include "store/scene_name.h"
#include "store/scene_search.h"
#include "system/atomic_file.h"
#include "system/read_file.h"
#include "timeline/simulate_scene.h"

namespace rotatebook::cli {
namespace {

namespace fs = std::filesystem;

/// A scene file that was read.
struct SceneFile {
  fs::path path;
  std::optional<scene::Scene> scene{};  ///< Nothing if it can't be read.
  /// Of its clip, which ends early if its motion diverges; nothing if it wasn't simulated.
  std::optional<std::int64_t> frames{};
  std::vector<std::string> notes{};   ///< On what is likely a slip in it.
  std::vector<std::string> errors{};  ///< Why the scene isn't usable; empty if it is.
};

int statusOfAll(const std::vector<SceneFile>& files) {
  const bool ok =
      std::ranges::all_of(files, [](const SceneFile& file) { return file.errors.empty(); });
  return ok ? kDone : kWrongInput;
}

struct CheckArguments {
  std::vector<std::string> paths;
  SceneOptions sceneOptions;
  bool json = false, print = false, schema = false;
};

Json labelsJson(const scene::Scene& scene) {
  if (!scene.hasPanels()) return Json::array();
  return arrayOf(scene.motions, [](const scene::Panel& panel) { return panel.label; });
}

Json checkJson(const SceneFile& file) {
  Json object{{"path", file.path.string()},
              {"ok", file.errors.empty()},
              {"errors", file.errors},
              {"notes", file.notes}};
  if (!file.scene) return object;
  const scene::Scene& scene = *file.scene;
  if (file.frames) object["frames"] = *file.frames;
  object.update({{"panels", labelsJson(scene)},
                 {"name", scene.name},
                 {"title", scene.title},
                 {"duration_s", scene.clip.duration},
                 {"width", scene.clip.width},
                 {"height", scene.clip.height},
                 {"has_study", scene.study.has_value()}});
  return object;
}

/// The paths that were named, with the scenes below a folder in its place.
struct NamedScenes {
  std::vector<fs::path> paths{};
  std::vector<SceneFile> unlisted{};  ///< Folders that can't be listed.
  bool isFolder = false;              ///< One of those that were named, at least.

  void addFolder(const std::string& folder) {
    const auto [scenes, problems] = store::scenesBelow(folder);
    if (scenes.empty() && problems.empty()) throw InputError(folder + " holds no scenes (*.toml)");
    isFolder = true;
    paths.insert(paths.end(), scenes.begin(), scenes.end());
    for (const auto& [path, message] : problems) {
      printError(message);
      unlisted.push_back({.path = path, .errors = {message}});
    }
  }
};

/// Returns the same for all names of a file. A link to a scene is another: it has its own folder.
fs::path placeOf(const fs::path& path) {
  std::error_code error;
  const fs::path folder = fs::weakly_canonical(fs::absolute(path, error).parent_path(), error);
  return error ? path : folder / path.filename();
}

NamedScenes namedIn(const std::vector<std::string>& words) {
  NamedScenes named;
  for (const std::string& word : words) {
    std::error_code ignored;
    if (fs::is_directory(word, ignored))
      named.addFolder(word);
    else
      named.paths.emplace_back(word);
  }
  std::set<fs::path> known;
  std::erase_if(named.paths, [&](const fs::path& path) {
    return path != system::kStandardInput && !known.insert(placeOf(path)).second;
  });
  return named;
}

/// Checks the scene in a file.
SceneFile checkFile(const fs::path& path, const CheckArguments& arguments) {
  SceneFile file{path};
  try {
    const scene::Scene scene = arguments.sceneOptions.read(path);
    refuseSameNames({scene});
    file.notes = picture::preflight(scene).notes;
    reportNotes(scene, file.notes, std::cerr);
    if (arguments.json) file.frames = timeline::simulateScene(scene).frameCount();
    file.scene = scene;
  } catch (const InputError& error) {
    printError(error.what());
    file.errors.emplace_back(error.what());
  }
  return file;
}

void printList(const std::vector<SceneFile>& files) {
  std::size_t width = 0;
  for (const SceneFile& file : files) width = std::max(width, file.path.string().size());
  for (const SceneFile& file : files) {
    if (!file.scene) continue;
    fmt::print(std::cout, "{:<{}}  {:>4} s  {}\n", oneLine(file.path.string()), width,
               shortestText(file.scene->clip.duration), file.scene->title);
  }
}

int checkScenes(const CheckArguments& arguments) {
  if (arguments.schema) {
    std::cout << scene::sceneSchema();
    return kDone;
  }
  if (arguments.paths.empty()) throw InputError("name the scenes to check");
  const NamedScenes named = namedIn(arguments.paths);
  const bool isList = named.isFolder && !arguments.print && !arguments.json;
  std::vector<SceneFile> files = named.unlisted;
  for (const fs::path& path : named.paths) {
    files.push_back(checkFile(path, arguments));
    const SceneFile& file = files.back();
    if (!file.scene || arguments.json || isList) continue;
    const std::string name = system::nameOfInput(path);
    std::cout << (arguments.print ? scene::sceneText(*file.scene) : oneLine(name) + ": ok\n");
  }
  if (isList) printList(files);
  if (arguments.json) std::cout << jsonLine({{"scenes", arrayOf(files, checkJson)}});
  return statusOfAll(files);
}

}  // namespace

void addCheckCommand(CLI::App& program, Action& action) {
  auto [command, arguments] =
      addCommand(program, action, "check",
                 "Validate scenes, or list those of folders; writes nothing", checkScenes);
  CLI::Option* files = command.add_option("SCENE", arguments.paths,
                                          "Scene files, or folders, whose scenes are listed");
  command
      .add_flag("--schema", arguments.schema,
                "Print the JSON Schema of scenes, for editors, in place of SCENE")
      ->excludes(files);
  CLI::Option* json = command.add_flag(
      "--json", arguments.json,
      "Print one JSON object: each scene's errors, notes, title, size and number of frames");
  command.add_flag("--print", arguments.print, "Print the scenes with every default explicit")
      ->excludes(json);
  arguments.sceneOptions.addTo(command);
  command.footer(R"(
Of a folder, prints each scene below it that is right, with its length and title.

Examples:
  rotatebook check scenes/*.toml
  rotatebook check scenes
  rotatebook check scenes/starter.toml --print > full.toml
  rotatebook check --schema > scene.schema.json)");
}

namespace {

/// Returns the title of a scene named `name`: "my-first_throw" is "My first throw".
std::string titleFrom(std::string name) {
  std::ranges::replace(name, '-', ' ');
  std::ranges::replace(name, '_', ' ');
  if (name.front() >= 'a' && name.front() <= 'z') name.front() -= 'a' - 'A';
  return name;
}

/// Returns the line by which editors find the schema that is installed with the program; empty if
/// none is.
std::string schemaLine() {
  const std::optional<fs::path> schema = installedFile("scene.schema.json");
  if (!schema) return "";
  const std::unique_ptr<char, decltype(&g_free)> uri(
      g_filename_to_uri(schema->c_str(), nullptr, nullptr), &g_free);
  return uri ? fmt::format("#:schema {}\n", uri.get()) : "";
}

/// Returns the text of scenes/starter.toml with another title.
std::string starterWith(const std::string& title) {
  constexpr std::string_view kTitle = "title = ";
  std::string text = schemaLine() + std::string(starterScene());
  const std::size_t begin = text.find(kTitle) + kTitle.size();
  text.replace(begin, text.find('\n', begin) - begin, document::tomlString(title));
  return text;
}

/// Throws InputError if no scene can be written to `path`.
void requireNew(const fs::path& path) {
  if (path.extension() != ".toml") {
    throw InputError(fmt::format("{}: the name of a scene's file ends in .toml, as {}.toml does",
                                 path.string(), path.stem().string()));
  }
  const std::string name = path.stem().string();
  if (const std::string problem = store::problemOfName(name); !problem.empty()) {
    throw InputError(fmt::format("{}: the scene's name {} {}; choose another", path.string(),
                                 quotedText(name), problem));
  }
  std::error_code ignored;
  const fs::path folder = path.parent_path();
  if (!folder.empty() && !fs::is_directory(folder, ignored)) {
    throw InputError(fmt::format("{}: there is no folder {}; make it, or choose another",
                                 path.string(), folder.string()));
  }
  requireAbsent(path);
}

int writeNewScene(const std::string& file) {
  const fs::path path(file);
  requireNew(path);
  const std::string text = starterWith(titleFrom(path.stem().string()));
  scene::parseScene(text, path);  // A title may be too long.
  system::writeFileAtomically(path, text);
  fmt::print(std::cout, "wrote {}\nnext: change a number in it, and run\n  rotatebook render {}\n",
             oneLine(path.string()), oneLine(shellWord(path.string())));
  return kDone;
}

}  // namespace

void addNewCommand(CLI::App& program, Action& action) {
  auto [command, file] =
      addCommand(program, action, "new", "Write a commented scene to begin with", writeNewScene);
  command.add_option("FILE", file, "Scene file to write, NAME.toml")
      ->required()
      ->check(notStandardOutput);
  command.footer("\nAn existing file is never overwritten.\n\nExample:\n  rotatebook new my.toml");
}

}  // namespace rotatebook::cli
