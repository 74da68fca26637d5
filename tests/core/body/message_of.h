// Messages of refused input, for tests.
#pragma once

#include <string>

#include "base/error.h"

namespace rotatebook::body::testing {

/// Returns the message of the InputError that `call` throws; "accepted" if it throws none.
template <typename Call>
std::string messageOf(const Call& call) {
  try {
    call();
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

}  // namespace rotatebook::body::testing
