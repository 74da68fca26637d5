// Twice as many lanes: while the processor waits for the result of one half, it computes the
// other's. Inside the room only.
#pragma once

namespace rotatebook::study::lanes {

/// For which bodies a condition holds, in both halves.
template <typename Half>
struct PairMask {
  Half first, second;
};

/// Lanes, or pairs of them, as one number.
template <typename Half>
struct Pair {
  Half first, second;

  Pair() = default;
  Pair(Half one, Half other) : first(one), second(other) {}
  /// Gives each the number.
  explicit Pair(double number) : first(number), second(number) {}

  friend Pair operator+(Pair a, Pair b) { return {a.first + b.first, a.second + b.second}; }
  friend Pair operator-(Pair a, Pair b) { return {a.first - b.first, a.second - b.second}; }
  friend Pair operator*(Pair a, Pair b) { return {a.first * b.first, a.second * b.second}; }
  friend Pair operator/(Pair a, Pair b) { return {a.first / b.first, a.second / b.second}; }
};

template <typename Half>
auto paired(Half first, Half second) {
  return PairMask<Half>{first, second};
}
template <typename Half>
auto operator<(Pair<Half> a, Pair<Half> b) {
  return paired(a.first < b.first, a.second < b.second);
}
template <typename Half>
auto operator<=(Pair<Half> a, Pair<Half> b) {
  return paired(a.first <= b.first, a.second <= b.second);
}
template <typename Half>
auto operator==(Pair<Half> a, Pair<Half> b) {
  return paired(a.first == b.first, a.second == b.second);
}
template <typename Half>
auto operator>(Pair<Half> a, Pair<Half> b) {
  return paired(a.first > b.first, a.second > b.second);
}
template <typename Half>
PairMask<Half> isNot(PairMask<Half> mask) {
  return {isNot(mask.first), isNot(mask.second)};
}
template <typename Half>
PairMask<Half> both(PairMask<Half> a, PairMask<Half> b) {
  return {both(a.first, b.first), both(a.second, b.second)};
}
template <typename MaskHalf, typename Half>
Pair<Half> chosen(PairMask<MaskHalf> mask, Pair<Half> yes, Pair<Half> no) {
  return {chosen(mask.first, yes.first, no.first), chosen(mask.second, yes.second, no.second)};
}
template <typename Half>
bool isAny(PairMask<Half> mask) {
  const bool one = isAny(mask.first), other = isAny(mask.second);
  return one || other;
}
template <typename Half>
bool isAll(PairMask<Half> mask) {
  const bool one = isAll(mask.first), other = isAll(mask.second);
  return one && other;
}
template <typename Half>
void storeMask(PairMask<Half> mask, bool* to) {
  storeMask(mask.first, to);
  storeMask(mask.second, to + laneCount(mask.first));
}
template <typename Half>
constexpr int laneCount(PairMask<Half> mask) {
  return 2 * laneCount(mask.first);
}
template <typename Half>
Pair<Half> magnitude(Pair<Half> a) {
  return {magnitude(a.first), magnitude(a.second)};
}
template <typename Half>
Pair<Half> rootOf(Pair<Half> a) {
  return {rootOf(a.first), rootOf(a.second)};
}
template <typename Half>
bool isAnyLarger(Pair<Half> x, double bound) {
  if constexpr (requires { largerSize(x.first, x.second); }) {
    return isAnyLarger(largerSize(x.first, x.second), bound);
  } else {
    const bool one = isAnyLarger(x.first, bound), other = isAnyLarger(x.second, bound);
    return one || other;
  }
}
template <typename Half>
Pair<Half> exactProductPlus(Pair<Half> a, Pair<Half> b, Pair<Half> c) {
  return {exactProductPlus(a.first, b.first, c.first),
          exactProductPlus(a.second, b.second, c.second)};
}
template <typename Half>
Pair<Half> negativeProduct(Pair<Half> a, Pair<Half> b) {
  return {negativeProduct(a.first, b.first), negativeProduct(a.second, b.second)};
}
template <typename Half>
requires requires(Half half) {
  inverseOfRoot(half, half);
}
Pair<Half> inverseOfRoot(Pair<Half> x, Pair<Half> series) {
  return {inverseOfRoot(x.first, series.first), inverseOfRoot(x.second, series.second)};
}

}  // namespace rotatebook::study::lanes
