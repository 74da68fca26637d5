// Count of the elementary functions' results that aren't correctly rounded, of ten million
// arguments each or of as many as are asked for.
#include <cstdint>
#include <cstdlib>
#include <iostream>

#include "base/correct_rounding.h"

int main(int argc, char** argv) {
  using namespace rotatebook;
  const std::int64_t count = argc > 1 ? std::atoll(argv[1]) : 10'000'000;
  std::size_t wrong = 0;
  for (const RoundedFunction& function : roundedFunctions()) {
    if (argc > 2 && function.name != argv[2]) continue;
    const auto found = wronglyRounded(function, count);
    wrong += found.size();
    std::cout << function.name << ": " << found.size() << " of " << count << " wrong";
    if (!found.empty()) std::cout << std::hexfloat << ", at " << found[0].x << " " << found[0].y;
    std::cout << std::defaultfloat << std::endl;
  }
  return wrong == 0 ? 0 : 1;
}
