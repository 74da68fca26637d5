// What the C++ library of Emscripten 3.1 lacks of C++20, as far as the core and its tests use it;
// included before every source. Each name does what the standard says of it. A newer library has
// all of it, and then needs no such file.
#pragma once

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <iterator>
#include <string>
#include <system_error>
#include <utility>

namespace std {

template <class To, class From>
constexpr To bit_cast(const From& from) noexcept {
  return __builtin_bit_cast(To, from);
}

// Algorithms over a whole range, with a projection.
namespace ranges {

template <class Predicate, class Projection>
constexpr auto projected(Predicate& predicate, Projection& projection) {
  return [&](auto&& value) -> decltype(auto) {
    return std::invoke(predicate, std::invoke(projection, std::forward<decltype(value)>(value)));
  };
}
template <class Compare, class Projection>
constexpr auto projectedLess(Compare& compare, Projection& projection) {
  return [&](auto&& a, auto&& b) {
    return std::invoke(compare, std::invoke(projection, a), std::invoke(projection, b));
  };
}

#define ROTATEBOOK_OF_PREDICATE(name)                                                       \
  template <class Range, class Predicate, class Projection = std::identity>                 \
  constexpr auto name(Range&& range, Predicate predicate, Projection projection = {}) {     \
    return std::name(std::begin(range), std::end(range), projected(predicate, projection)); \
  }
ROTATEBOOK_OF_PREDICATE(all_of)
ROTATEBOOK_OF_PREDICATE(any_of)
ROTATEBOOK_OF_PREDICATE(none_of)
ROTATEBOOK_OF_PREDICATE(count_if)
ROTATEBOOK_OF_PREDICATE(find_if)
ROTATEBOOK_OF_PREDICATE(find_if_not)
#undef ROTATEBOOK_OF_PREDICATE

#define ROTATEBOOK_OF_ORDER(name)                                                             \
  template <class Range, class Compare = std::less<>, class Projection = std::identity>       \
  constexpr auto name(Range&& range, Compare compare = {}, Projection projection = {}) {      \
    return std::name(std::begin(range), std::end(range), projectedLess(compare, projection)); \
  }
ROTATEBOOK_OF_ORDER(max_element)
ROTATEBOOK_OF_ORDER(min_element)
ROTATEBOOK_OF_ORDER(sort)
ROTATEBOOK_OF_ORDER(stable_sort)
ROTATEBOOK_OF_ORDER(is_sorted)
#undef ROTATEBOOK_OF_ORDER

#define ROTATEBOOK_OF_VALUE(name, algorithm)                                             \
  template <class Range, class Value, class Projection = std::identity>                  \
  constexpr auto name(Range&& range, const Value& value, Projection projection = {}) {   \
    return std::algorithm(std::begin(range), std::end(range), [&](auto&& element) {      \
      return std::invoke(projection, std::forward<decltype(element)>(element)) == value; \
    });                                                                                  \
  }
ROTATEBOOK_OF_VALUE(count, count_if)
ROTATEBOOK_OF_VALUE(find, find_if)
#undef ROTATEBOOK_OF_VALUE

template <class Range, class Value, class Compare = std::less<>, class Projection = std::identity>
constexpr auto lower_bound(Range&& range, const Value& value, Compare compare = {},
                           Projection projection = {}) {
  return std::lower_bound(std::begin(range), std::end(range), value,
                          [&](auto&& element, const Value& wanted) {
                            return std::invoke(compare, std::invoke(projection, element), wanted);
                          });
}
template <class Range, class Compare = std::less<>, class Projection = std::identity>
constexpr auto max(Range&& range, Compare compare = {}, Projection projection = {}) {
  return *ranges::max_element(range, compare, projection);
}
template <class Range, class Out>
constexpr Out copy(Range&& range, Out out) {
  return std::copy(std::begin(range), std::end(range), out);
}
template <class Range, class Out>
constexpr Out move(Range&& range, Out out) {
  return std::move(std::begin(range), std::end(range), out);
}
template <class Range, class Value>
constexpr void replace(Range&& range, const Value& before, const Value& after) {
  std::replace(std::begin(range), std::end(range), before, after);
}
template <class Range, class Act>
constexpr void for_each(Range&& range, Act act) {
  std::for_each(std::begin(range), std::end(range), act);
}
template <class Range, class Other>
constexpr bool equal(Range&& range, Other&& other) {
  return std::equal(std::begin(range), std::end(range), std::begin(other), std::end(other));
}

}  // namespace ranges

// Numbers as text. The C library's own conversions round correctly.
inline from_chars_result from_chars(const char* first, const char* last, double& value) {
  if (first == last || *first == '+' || std::strchr(" \t\n\v\f\r", *first) != nullptr) {
    return {first, errc::invalid_argument};
  }
  const std::string text(first, last);
  if (text.find_first_of("xX") != std::string::npos) return {first, errc::invalid_argument};
  char* end = nullptr;
  const double read = std::strtod(text.c_str(), &end);
  if (end == text.c_str()) return {first, errc::invalid_argument};
  const char* after = first + (end - text.c_str());
  const bool isWord = text.find_first_of("iInN") != std::string::npos;
  if (!isWord && std::isinf(read)) return {after, errc::result_out_of_range};
  value = read;
  return {after, errc{}};
}

/// Returns whether `text` reads back as `value`.
inline bool readsBackAs(const string& text, double value) {
  return strtod(text.c_str(), nullptr) == value;
}

/// Returns the fewest significant digits that read back, of those the nearest, as "%e" writes them.
inline string shortestDigits(double value) {
  // Shorter texts are padded with zeros to 15 digits, except where a number has less precision.
  const int from = fabs(value) < 2.3e-308 ? 1 : 15;
  array<char, 40> text{};
  for (int digits = from; digits <= 17; ++digits) {
    snprintf(text.data(), text.size(), "%.*e", digits - 1, value);
    if (readsBackAs(text.data(), value)) break;
    // Above a power of two the next number is twice as far as below: one more in the last digit may
    // read back.
    string next = text.data();
    const size_t last = next.find('e') - 1;
    if (next[last] < '9' && ++next[last] && readsBackAs(next, value)) return next;
  }
  return text.data();
}

/// The shortest text that reads back, fixed or scientific; fixed if both are as long.
inline to_chars_result to_chars(char* first, char* last, double value) {
  const auto put = [&](const string& text) -> to_chars_result {
    if (static_cast<size_t>(last - first) < text.size()) return {last, errc::value_too_large};
    return {std::copy(text.begin(), text.end(), first), errc{}};
  };
  if (isnan(value)) return put(signbit(value) ? "-nan" : "nan");
  if (isinf(value)) return put(value < 0 ? "-inf" : "inf");
  string scientific = shortestDigits(value);
  const size_t e = scientific.find('e');
  const int exponent = atoi(scientific.c_str() + e + 1);
  string mantissa = scientific.substr(0, e);
  if (mantissa.find('.') != string::npos) {
    mantissa.erase(mantissa.find_last_not_of('0') + 1);
    if (mantissa.back() == '.') mantissa.pop_back();
  }
  scientific = mantissa + scientific.substr(e);
  const int decimals = static_cast<int>(count_if(mantissa.begin(), mantissa.end(),
                                                 [](char c) { return c >= '0' && c <= '9'; })) -
                       1 - exponent;
  array<char, 400> fixed{};
  snprintf(fixed.data(), fixed.size(), "%.*f", max(decimals, 0), value);
  return put(strlen(fixed.data()) <= scientific.size() ? fixed.data() : scientific);
}
/// Of chars_format::hex alone, which toml++ names without calling it.
inline to_chars_result to_chars(char* first, char* last, double value, chars_format) {
  array<char, 40> text{};
  snprintf(text.data(), text.size(), "%a", value);
  string hex = text.data();
  if (const size_t prefix = hex.find("0x"); prefix != string::npos) hex.erase(prefix, 2);
  if (static_cast<size_t>(last - first) < hex.size()) return {last, errc::value_too_large};
  return {std::copy(hex.begin(), hex.end(), first), errc{}};
}
inline to_chars_result to_chars(char* first, char* last, double value, chars_format, int digits) {
  const int length = std::snprintf(first, static_cast<size_t>(last - first), "%.*g", digits, value);
  if (length >= last - first) return {last, errc::value_too_large};
  return {first + length, errc{}};
}

}  // namespace std
