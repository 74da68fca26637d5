// Messages about wrong command lines. Inside the room only.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include <CLI/CLI.hpp>

namespace rotatebook::cli {

/// Returns "unknown command: NAME", with the nearest name that `program` has.
std::string unknownCommandText(const CLI::App& program, std::string_view name);

/// Returns `error`, by which the parser refused `arguments`, in words: the argument that is wrong,
/// and the nearest name or the remedy.
std::string problemText(const CLI::App& program, const CLI::Error& error,
                        std::span<char* const> arguments);

/// Returns the lines that say where there is help after such an error.
std::string adviceText(const CLI::App& program);

}  // namespace rotatebook::cli
