// What a reader says of what it refuses.
#pragma once

#include <concepts>
#include <string>

#include "base/error.h"

namespace rotatebook::recording {

/// Returns the message of the InputError that `work` throws; "" if it throws none.
template <std::invocable Work>
std::string refusalOf(const Work& work) {
  try {
    work();
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

}  // namespace rotatebook::recording
