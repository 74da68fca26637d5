// A table of a document in a file of its own.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

#include "base/document/toml_tree.h"

namespace rotatebook::document {

/// Returns the text of a file that a document names, relative to its folder. Throws InputError
/// "can't read FILE: CAUSE", also if it has more than `most` bytes.
using ReadNamedFile =
    std::function<std::string(const std::filesystem::path& file, std::size_t most)>;

/// Replaces the value of `key` in `section` of `root`, a table, by the table in the file that it
/// names, and returns the file's path, within `folder`; a string with a dot in it is such a name.
/// Leaves other values, and returns an empty path then. What is read keeps its locations in the
/// file. Throws DocumentError if the file can't be read or isn't TOML; its table is empty then.
std::filesystem::path includeTable(TomlNode& root, std::string_view section, std::string_view key,
                                   const std::filesystem::path& folder,
                                   const ReadNamedFile& readNamedFile);

}  // namespace rotatebook::document
