// The elementary functions beside what MPFR computes at 200 bits and rounds once.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <functional>
#include <mpfr.h>
#include <random>
#include <string>
#include <vector>

#include "base/elementary.h"

namespace rotatebook {

/// A function of MPFR, of one argument or of two.
using MpfrUnary = int (*)(mpfr_t, const mpfr_t, mpfr_rnd_t);
using MpfrBinary = int (*)(mpfr_t, const mpfr_t, const mpfr_t, mpfr_rnd_t);

/// Values of functions, each rounded once to the nearest double.
class Reference {
 public:
  Reference() { mpfr_inits2(kBits, x_, y_, value_, static_cast<mpfr_ptr>(nullptr)); }
  ~Reference() {
    mpfr_clears(x_, y_, value_, static_cast<mpfr_ptr>(nullptr));
    mpfr_clear(longer_);
    mpfr_mp_memory_cleanup();  // PolhodeConstants that MPFR keeps would count as leaks.
  }
  Reference(const Reference&) = delete;
  Reference& operator=(const Reference&) = delete;

  double of(MpfrUnary function, double x) {
    mpfr_set_d(x_, x, MPFR_RNDN);
    return rounded(function(value_, x_, MPFR_RNDZ));
  }
  double of(MpfrBinary function, double x, double y) {
    mpfr_set_d(x_, x, MPFR_RNDN);
    mpfr_set_d(y_, y, MPFR_RNDN);
    return rounded(function(value_, x_, y_, MPFR_RNDZ));
  }

 private:
  static constexpr int kBits = 200;

  // Make one more bit of what was cut off, so that it decides where the bits end half way.
  double rounded(int inexact) {
    mpfr_set(longer_, value_, MPFR_RNDN);
    if (inexact != 0) mpfr_sgn(longer_) > 0 ? mpfr_nextabove(longer_) : mpfr_nextbelow(longer_);
    return mpfr_get_d(longer_, MPFR_RNDN);
  }

  static mpfr_ptr initialised(mpfr_ptr number) {
    mpfr_init2(number, kBits + 1);
    return number;
  }

  mpfr_t x_, y_, value_, longer_;
  mpfr_ptr ready_ = initialised(longer_);
};

/// Arguments that look random, the same for everyone.
class Arguments {
 public:
  /// In [low, high).
  double between(double low, double high) {
    return low + (high - low) * std::ldexp(static_cast<double>(bits_() >> 11), -53);
  }
  /// Of any exponent from `low` to `high`, and of either sign.
  double ofExponents(double low, double high) {
    const double size = std::ldexp(between(1, 2), static_cast<int>(between(low, high)));
    return (bits_() & 1) != 0 ? size : -size;
  }
  /// Any bits but NaN's and infinity's.
  double any() {
    for (;;) {
      const auto number = std::bit_cast<double>(bits_());
      if (std::isfinite(number)) return number;
    }
  }
  /// Beside a multiple of pi/2, no farther than the second double from the nearest.
  double besideZero() {
    double number = std::floor(between(1, 636'619)) * 1.5707963267948966;
    for (std::uint64_t steps = bits_() % 3; steps > 0; --steps) {
      number = std::nextafter(number, (bits_() & 1) != 0 ? 1e9 : -1e9);
    }
    return (bits_() & 1) != 0 ? number : -number;
  }
  /// Legs m^2 - n^2 and 2 m n: their hypotenuse m^2 + n^2 has 54 bits, half way between doubles.
  std::pair<double, double> halfWayTriangle() {
    for (;;) {
      const double m = std::floor(between(0x1p26, 0x1.6p26)), n = std::floor(between(0x1p24, m));
      const double sum = std::fma(m, m, n * n), x = m * m - n * n;
      if (sum >= 0x1p53 && x < 0x1p53 && std::fmod(m + n, 2) == 1) return {x, 2 * m * n};
    }
  }
  bool once(int of) { return bits_() % static_cast<unsigned>(of) == 0; }

 private:
  std::mt19937_64 bits_{20'231'123};
};

/// A function, what it ought to give, and arguments for both; those of one argument ignore `y`.
struct RoundedFunction {
  struct Point {
    double x = 0, y = 0;
  };

  std::string name;
  std::function<double(Point)> own;
  std::function<double(Reference&, Point)> exact;
  std::function<Point(Arguments&)> next;
};

inline RoundedFunction unary(std::string name, double (*own)(double), MpfrUnary exact,
                             std::function<double(Arguments&)> next) {
  using Point = RoundedFunction::Point;
  return {std::move(name), [own](Point at) { return own(at.x); },
          [exact](Reference& reference, Point at) { return reference.of(exact, at.x); },
          [next = std::move(next)](Arguments& arguments) { return Point{next(arguments)}; }};
}

inline RoundedFunction::Point anyPoint(Arguments& arguments) {
  if (arguments.once(4)) return {arguments.any(), arguments.any()};
  if (arguments.once(4)) {  // whose ratio is a subnormal number of few bits
    const double size = std::floor(arguments.between(1, 64));
    return {size, std::ldexp(std::floor(arguments.between(-4e3, 4e3)), -1074)};
  }
  if (arguments.once(2)) return {arguments.ofExponents(-30, 30), arguments.ofExponents(-30, 30)};
  return {arguments.between(-1, 1), arguments.between(-1, 1)};
}

inline std::vector<RoundedFunction> roundedFunctions() {
  using Point = RoundedFunction::Point;
  const auto angle = [](Arguments& arguments) {
    if (arguments.once(4)) return arguments.besideZero();
    if (arguments.once(4)) return arguments.ofExponents(-1074, 0);
    return arguments.once(2) ? arguments.between(-8, 8)
                             : arguments.between(-kLargestAngle, kLargestAngle);
  };
  const auto power = [](Arguments& arguments) {
    if (arguments.once(4)) return arguments.between(-745.2, -708);  // subnormal results
    return arguments.once(3) ? arguments.ofExponents(-60, 4) : arguments.between(-745, 709.7);
  };
  const auto positive = [](Arguments& arguments) {
    if (arguments.once(2)) return std::fabs(arguments.any());
    return arguments.once(2) ? arguments.between(0.98, 1.02) : arguments.between(0, 100);
  };
  const auto moderate = [](Arguments& arguments) {
    if (arguments.once(2)) return arguments.between(-20, 20);
    return arguments.once(2) ? arguments.ofExponents(-40, 6) : arguments.any();
  };
  return {
      unary("sine", sine, mpfr_sin, angle),
      unary("cosine", cosine, mpfr_cos, angle),
      {"cosineSine", [](Point at) { return cosineSine(at.x).sine; },
       [](Reference& reference, Point at) { return reference.of(mpfr_sin, at.x); },
       [angle](Arguments& arguments) { return Point{angle(arguments)}; }},
      unary(
          "arcTangent", [](double x) { return arcTangent(x); }, mpfr_atan, moderate),
      {"arcTangent of two", [](Point at) { return arcTangent(at.y, at.x); },
       [](Reference& reference, Point at) { return reference.of(mpfr_atan2, at.y, at.x); },
       anyPoint},
      unary("exponential", exponential, mpfr_exp, power),
      unary("logarithm", logarithm, mpfr_log, positive),
      unary("hyperbolicTangent", hyperbolicTangent, mpfr_tanh, moderate),
      unary("inverseHyperbolicSine", inverseHyperbolicSine, mpfr_asinh, moderate),
      {"roundedHypotenuse", [](Point at) { return roundedHypotenuse(at.x, at.y); },
       [](Reference& reference, Point at) { return reference.of(mpfr_hypot, at.x, at.y); },
       [](Arguments& arguments) {
         if (!arguments.once(8)) return anyPoint(arguments);
         const auto [x, y] = arguments.halfWayTriangle();
         return Point{x, y};
       }},
  };
}

/// Arguments, of `count`, whose results aren't correctly rounded.
inline std::vector<RoundedFunction::Point> wronglyRounded(const RoundedFunction& function,
                                                          std::int64_t count) {
  Arguments arguments;
  Reference reference;
  std::vector<RoundedFunction::Point> wrong;
  for (std::int64_t i = 0; i < count; ++i) {
    const RoundedFunction::Point at = function.next(arguments);
    const auto own = std::bit_cast<std::uint64_t>(function.own(at));
    if (own != std::bit_cast<std::uint64_t>(function.exact(reference, at))) wrong.push_back(at);
  }
  return wrong;
}

}  // namespace rotatebook
