// Completions of command lines, made of the commands and options that the parser knows. Inside the
// room only.
#pragma once

#include <string>

#include <CLI/CLI.hpp>

namespace rotatebook::cli {

/// Returns the script by which `shell` ("bash", "zsh" or "fish") completes the command line of
/// `program`. Throws InputError for another shell.
std::string completionScript(const CLI::App& program, const std::string& shell);

}  // namespace rotatebook::cli
