// A TOML document as JSON, and back.
#pragma once

#include <string>
#include <string_view>

#include "base/document/toml_tree.h"

namespace rotatebook::document {

/// Returns a value as JSON, tables in the order of the text. Numbers read back as the same ones;
/// those that aren't finite, and dates, become null.
std::string jsonOf(const TomlNode& node);

/// Returns a value that jsonOf() wrote, or another program, without locations. Throws InputError
/// for what isn't JSON, and for null.
TomlNode nodeOfJson(std::string_view text);

}  // namespace rotatebook::document
