// Messages about wrong documents.
#pragma once

#include <string>

#include "base/document/toml_tree.h"
#include "base/error.h"

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

/// Returns `part` so many times.
inline std::string repeated(const std::string& part, int times) {
  std::string text;
  for (int i = 0; i < times; ++i) text += part;
  return text;
}

}  // namespace rotatebook::document
