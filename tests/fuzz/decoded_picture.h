// What a fuzz target of a picture format requires.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <iterator>
#include <string>

#include "base/clip_limits.h"
#include "fuzz/fuzzing.h"
#include "image/image.h"

namespace rotatebook::fuzzing {

// Picture libraries aren't built for the fuzzer, which sees none of their branches: what they
// complain about tells some of them apart.
[[gnu::section("__libfuzzer_extra_counters")]] inline std::uint8_t complaints[256];

inline void requireWhole(const image::Image& picture) {
  require(picture.width() > 0 && picture.width() <= kMaxPictureSide);
  require(picture.height() > 0 && picture.height() <= kMaxPictureSide);
  const std::uint8_t* last = picture.row(picture.height() - 1) + picture.stride() - 1;
  require(last - picture.row(0) + 1 == picture.stride() * picture.height());
}

/// Runs `decode`, which returns a picture or refuses.
template <typename Decode>
void requireWholeOrRefused(const Decode& decode) {
  const std::string words = mayRefuse([&] { requireWhole(decode()); });
  complaints[std::hash<std::string>()(words) % std::size(complaints)] = 1;
}

}  // namespace rotatebook::fuzzing
