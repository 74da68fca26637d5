#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>
#include <string>
#include <system_error>

#include "base/document/toml_text.h"
#include "base/error.h"
#include "base/text.h"
#include "cli/commands.h"
#include "cli/exit_code.h"
#include "cli/input_guard.h"
#include "embedded/cli.h"
#include "scene/scene_text.h"
#include "store/scene_name.h"
#include "system/atomic_file.h"

namespace rotatebook::cli {
namespace {

namespace fs = std::filesystem;

/// Returns the title of a scene named `name`: "my-first_throw" is "My first throw".
std::string titleFrom(std::string name) {
  std::ranges::replace(name, '-', ' ');
  std::ranges::replace(name, '_', ' ');
  if (name.front() >= 'a' && name.front() <= 'z') name.front() -= 'a' - 'A';
  return name;
}

/// Returns the text of scenes/starter.toml with another title.
std::string starterWith(const std::string& title) {
  constexpr std::string_view kTitle = "title = ";
  std::string text(starterScene());
  const std::size_t begin = text.find(kTitle) + kTitle.size();
  text.replace(begin, text.find('\n', begin) - begin, document::tomlString(title));
  return text;
}

/// Throws InputError if no scene can be written to `path`.
void requireNew(const fs::path& path) {
  if (path.extension() != ".toml") {
    throw InputError(path.string() + ": the name of a scene's file ends in .toml, as " +
                     path.stem().string() + ".toml does");
  }
  const std::string name = path.stem().string();
  if (const std::string problem = store::problemOfName(name); !problem.empty()) {
    throw InputError(path.string() + ": the scene's name " + quotedText(name) + " " + problem +
                     "; choose another");
  }
  std::error_code ignored;
  const fs::path folder = path.parent_path();
  if (!folder.empty() && !fs::is_directory(folder, ignored)) {
    throw InputError(path.string() + ": there is no folder " + folder.string() +
                     "; make it, or choose another");
  }
  requireAbsent(path);
}

int writeNewScene(const fs::path& path) {
  requireNew(path);
  const std::string text = starterWith(titleFrom(path.stem().string()));
  scene::parseScene(text, path);  // A title may be too long.
  system::writeFileAtomically(path, text);
  const std::string name = oneLine(path.string());
  std::cout << "wrote " << name << "\nnext: change a number in it, and run\n  rotatebook render "
            << oneLine(shellWord(path.string())) << '\n';
  return kDone;
}

}  // namespace

void addNewCommand(CLI::App& program, Action& action) {
  auto path = std::make_shared<std::string>();
  CLI::App* command = program.add_subcommand("new", "Write a commented scene to begin with");
  command->add_option("FILE", *path, "Scene file to write, NAME.toml")->required();
  command->footer("\nAn existing file is never overwritten.\n\nExample:\n  rotatebook new my.toml");
  command->callback([path, &action] { action = [path] { return writeNewScene(*path); }; });
}

}  // namespace rotatebook::cli
