// Texts to and from the slots of the bridge.
#pragma once

#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <string>
#include <string_view>

#include <gtest/gtest.h>

#include "bridge/bridge.h"

namespace rotatebook::bridge::testing {

inline constexpr std::string_view kScene =
    "title = \"A throw\"\n"
    "[initial]\nangular_velocity = [5.0, 0.0, 0.0]\ntilt = [\"1 deg\", \"z\"]\n"
    "[clip]\nduration = 2.0\n"
    "[[nudge]]\nat = 0.5\nangular_velocity = [0.0, 0.2, 0.0]\n";
inline constexpr int kFrames = 120;
inline constexpr std::int32_t kAll = 1'000'000'000;

/// Returns the context of all tests but those that make another.
inline rb_context* context() {
  static rb_context* const made = rb_new(0, 0);
  return made;
}

inline std::int32_t put(std::string_view text) {
  std::memcpy(rb_buffer(context()), text.data(), text.size());
  return static_cast<std::int32_t>(text.size());
}

inline std::string taken(std::int32_t length) {
  return {rb_buffer(context()), static_cast<std::size_t>(std::abs(length))};
}

inline void read(std::int32_t slot, std::string_view text) {
  const std::int32_t length = rb_read(context(), slot, put(text));
  ASSERT_GT(length, 0) << taken(length);
}

/// Reads a scene into a slot that holds other motions.
inline void readAnew(std::int32_t slot, std::string_view text) {
  read(slot, "[initial]\nangular_velocity = [0.0, 0.0, 1.0]\n[clip]\nduration = 0.1\n");
  read(slot, text);
}

inline std::string with(std::string_view text, std::string_view part, std::string_view other) {
  std::string changed(text);
  return changed.replace(changed.find(part), part.size(), other);
}

inline void giveFile(std::string_view name, std::string_view bytes) {
  put(std::string(name) + std::string(bytes));
  ASSERT_EQ(rb_file(context(), static_cast<std::int32_t>(name.size()),
                    static_cast<std::int32_t>(bytes.size())),
            0);
}

}  // namespace rotatebook::bridge::testing
