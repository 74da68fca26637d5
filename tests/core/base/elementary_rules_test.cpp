// The core calls no function of the C library whose last digit differs from machine to machine.
#include <filesystem>
#include <fstream>
#include <regex>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace rotatebook {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

// What is exact by definition is not among them: sqrt, fabs, floor, fmod, ldexp and their like.
// Eigen and Boost call the others in what is named last.
const std::regex kInexact(
    R"((^|[^\w.>:]|std::|(^|[^\w:])::)(a?(sin|cos|tan)h?|atan2|sincos|exp(2|10|m1)?|log(2|10|1p|b)?|pow|)"
    R"(cbrt|hypot|erfc?|[tl]gamma)[fl]?\s*\(|<random>|boost/|AngleAxis|angularDistance|slerp|)"
    R"(computeDirect)");

std::vector<std::string> inexactIn(const std::string& text) {
  std::vector<std::string> lines;
  std::size_t begin = 0;
  while (begin < text.size()) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const std::string line = text.substr(begin, end - begin);
    begin = end + 1;
    if (std::regex_search(line.substr(0, line.find("//")), kInexact)) lines.push_back(line);
  }
  return lines;
}

std::string textOf(const fs::path& file) {
  std::ifstream stream(file);
  return {std::istreambuf_iterator<char>(stream), {}};
}

TEST(ElementaryRules, DistinguishRightFromWrong) {
  EXPECT_THAT(inexactIn("x = std::sin(y);\n"), ElementsAre("x = std::sin(y);"));
  for (const std::string line :
       {"::cosf (x)", "return -exp(x);", "a * pow(2, 3)", "std::hypot(x, y)", "std::log1p(x)",
        "x = (tanh(y))", "#include <boost/math/constants.hpp>", "q.angularDistance(p)",
        "Eigen::AngleAxisd(1, x)", "solver.computeDirect(tensor)"}) {
    EXPECT_THAT(inexactIn(line), ElementsAre(line));
  }
  for (const std::string line :
       {"std::sqrt(x)", "sine(x)", "// sin(x)", "values.exp(x)", "exponential(x)",
        "std::ldexp(x, 2)", "logarithm(x)", "std::ilogb(x)", "double cosine = 1;", "catalog(x)",
        "elementary::sin(x)"}) {
    EXPECT_THAT(inexactIn(line), IsEmpty());
  }
}

TEST(ElementaryRules, HoldInAllOfTheCore) {
  std::size_t seen = 0;
  const fs::path core = fs::path(ROTATEBOOK_SOURCE) / "src/core";
  for (const auto& entry : fs::recursive_directory_iterator(core)) {
    if (entry.path().extension() != ".h" && entry.path().extension() != ".cpp") continue;
    ++seen;
    for (const std::string& line : inexactIn(textOf(entry.path()))) {
      ADD_FAILURE() << entry.path() << ": " << line;
    }
  }
  EXPECT_GT(seen, 90U);  // measured 116
}

}  // namespace
}  // namespace rotatebook
