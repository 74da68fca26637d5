// A folder that holds the program with all libraries that it needs, graphics drivers among them,
// and runs on other systems: see scripts/portable.sh, which makes it.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace rotatebook::system {

/// An environment variable; `text()` is its line in the environment.
struct Variable {
  std::string name;
  std::string value;

  std::string text() const { return name + '=' + value; }
};

/// Lists the variables by which libraries find the files of the portable folder that `program`, a
/// path without symbolic links, lies in; none if it lies in no such folder.
///
/// Of the system below `host` two things are used where they are: NVIDIA's EGL, which goes with the
/// card's driver and comes before the folder's Mesa, and the configuration of fonts.
std::vector<Variable> portableVariables(const std::filesystem::path& program,
                                        const std::filesystem::path& host = "/");

/// Lists the variables of the running program's folder.
std::vector<Variable> portableVariables();

/// Sets those of portableVariables() that the user hasn't set, by these or other names. Must be
/// called before there are threads, and before a library that reads them is used.
void usePortableFolder();

}  // namespace rotatebook::system
