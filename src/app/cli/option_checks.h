// Checks of options' values, for CLI::Option::check(). They refuse by "must be WHAT, not VALUE",
// which follows the option's name. Inside the room only.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

namespace rotatebook::cli {

/// Begins what a check says of a wrong value.
inline constexpr const char* kMust = "must be ";

/// Returns the check of a whole number from `least` to `most`.
CLI::Validator wholeNumber(std::int64_t least, std::int64_t most);

/// Returns the check of a number from `least` to `most`.
CLI::Validator numberWithin(double least, double most);

/// Returns the check of one of `words`, which has a name alike suggested.
CLI::Validator oneOf(const std::vector<std::string>& words);

/// Checks a number that isn't less than 0.
std::string notNegative(const std::string& text);

/// Refuses the standard input as the file or folder of a command that doesn't read it.
std::string notStandardInput(const std::string& path);

/// Refuses the standard output as the file or folder of a command that doesn't write to it.
std::string notStandardOutput(const std::string& path);

}  // namespace rotatebook::cli
