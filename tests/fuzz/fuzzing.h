// The rules that every fuzz target keeps to.
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include "base/error.h"

/// A target: libFuzzer, or replay.cpp, calls it with one input after the other. A finding is
/// whatever ends the program: a sanitizer's report, an exception, abort().
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size);

namespace rotatebook::fuzzing {

inline std::string_view textOf(const std::uint8_t* bytes, std::size_t size) {
  return {reinterpret_cast<const char*>(bytes), size};
}

/// Runs `work`, which may refuse its input with an Error, whose words are returned; any other
/// exception is a finding.
template <std::invocable Work>
std::string mayRefuse(const Work& work) {
  try {
    work();
    return "";
  } catch (const Error& error) {
    return error.what();
  }
}

/// A finding unless it `holds`. In builds without assert(), too.
inline void require(bool holds) {
  if (!holds) std::abort();
}

}  // namespace rotatebook::fuzzing
