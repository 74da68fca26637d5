// Bytes compared so that a failure says where they differ first, and doesn't print them.
#pragma once

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <map>
#include <string>
#include <string_view>

#include <gtest/gtest.h>

namespace rotatebook::testing {

/// "byte 17 is 0x61, not 0x62", "line 3 is \"a\", not \"b\"" where both are text, or "it ends at
/// byte 17 of 20"; empty if `found` is `expected`.
inline std::string firstDifference(std::string_view found, std::string_view expected) {
  if (found == expected) return "";
  const auto differing =
      std::mismatch(found.begin(), found.end(), expected.begin(), expected.end()).first;
  const auto at = static_cast<std::size_t>(differing - found.begin());
  const auto isText = [](std::string_view bytes) { return bytes.find('\0') == bytes.npos; };
  if (isText(found) && isText(expected)) {
    const auto before = found.substr(0, at);
    const std::size_t begin = before.rfind('\n') + 1;  // npos + 1 is 0
    const auto lineOf = [&](std::string_view text) {
      return '"' + std::string(text.substr(begin, text.find('\n', begin) - begin)) + '"';
    };
    return "line " + std::to_string(1 + std::count(before.begin(), before.end(), '\n')) + " is " +
           lineOf(found) + ", not " + lineOf(expected);
  }
  const std::string place = "byte " + std::to_string(at);
  if (at == found.size()) return "it ends at " + place + " of " + std::to_string(expected.size());
  if (at == expected.size()) return "it goes on at " + place + ", where it should end";
  const auto hex = [at](std::string_view bytes) {
    constexpr const char* kDigits = "0123456789abcdef";
    const auto byte = static_cast<unsigned char>(bytes[at]);
    return std::string("0x") + kDigits[byte / 16] + kDigits[byte % 16];
  };
  return place + " is " + hex(found) + ", not " + hex(expected);
}

/// Success if `found` is `expected`; else where they differ first.
inline ::testing::AssertionResult sameBytes(std::string_view found, std::string_view expected) {
  const std::string difference = firstDifference(found, expected);
  if (difference.empty()) return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure() << difference;
}

/// Bytes by name.
using Files = std::map<std::string, std::string>;

/// Success if both have the same names with the same bytes; else every name that is missing, too
/// much, or of other bytes, each with the first difference.
inline ::testing::AssertionResult sameFiles(const Files& found, const Files& expected) {
  std::string differences;
  for (const auto& [name, bytes] : expected) {
    const auto there = found.find(name);
    const std::string one =
        there == found.end() ? "it is missing" : firstDifference(there->second, bytes);
    if (!one.empty()) differences += "\n  " + name + ": " + one;
  }
  for (const auto& [name, bytes] : found) {
    if (!expected.contains(name)) differences += "\n  " + name + ": it shouldn't be there";
  }
  if (differences.empty()) return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure() << "files differ:" << differences;
}

}  // namespace rotatebook::testing
