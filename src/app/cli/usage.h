// Messages about wrong command lines. Inside the room only.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <CLI/CLI.hpp>

namespace rotatebook::cli {

/// Returns the names of the commands of `program`, in the order of its help.
std::vector<std::string> commandNames(const CLI::App& program);

/// Returns "unknown command: NAME", with the nearest name that `program` has.
std::string unknownCommandText(const CLI::App& program, std::string_view name);

/// Returns `error`, by which the parser refused `arguments`, in words: the argument that is wrong,
/// the nearest name or the remedy, and where there is help. Its last line ends without a line end.
std::string usageText(const CLI::App& program, const CLI::Error& error,
                      std::span<char* const> arguments);

}  // namespace rotatebook::cli
