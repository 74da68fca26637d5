// The manual page, made of the commands and options that the parser knows. Inside the room only.
#pragma once

#include <string>

#include <CLI/CLI.hpp>

namespace rotatebook::cli {

/// Returns the manual page of `program` in section 1, all commands on it, as man(7) source.
std::string manualPage(const CLI::App& program);

}  // namespace rotatebook::cli
