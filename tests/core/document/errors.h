// Messages about wrong documents.
#pragma once

#include <string>

#include "base/error.h"
#include "document/toml_tree.h"

namespace rotatebook::document {

/// The message of the InputError that `work` throws, "no error" if it throws none.
template <typename Work>
std::string errorOf(const Work& work) {
  try {
    work();
    return "no error";
  } catch (const InputError& error) {
    return error.what();
  }
}

/// The message about a whole document.
inline std::string errorOfText(const std::string& text) {
  return errorOf([&] { parseToml(text, "a.toml"); });
}

}  // namespace rotatebook::document
