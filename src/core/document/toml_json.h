// A TOML document as JSON.
#pragma once

#include <string>

#include "document/toml_tree.h"

namespace rotatebook::document {

/// Returns a value as JSON, tables in the order of the text. Numbers read back as the same ones;
/// those that aren't finite, and dates, become null.
std::string jsonOf(const TomlNode& node);

}  // namespace rotatebook::document
