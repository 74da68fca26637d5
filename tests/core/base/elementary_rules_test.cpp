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

// Functions that are exact by definition are not among them: sqrt, fabs, floor, fmod, ldexp and
// their like.
const std::string kFunction =
    R"((a?(sin|cos|tan)h?|atan2|sincos|exp(2|10|m1)?|log(2|10|1p|b)?|powi?|cbrt|hypot|erfc?|[tl]gamma|)"
    R"(polar|arg|beta|expint|riemann_zeta|hermite|laguerre|legendre|(comp_)?ellint_\w+|)"
    R"((assoc|cyl|sph)_\w+)[fl]?)";
const std::string kCall = R"((^|[^\w.>:]))" + kFunction + R"(\s*\()";
// Called or passed on.
const std::string kQualified =
    R"(((std|numext|Eigen|(^|[^\w:]))::|__builtin_))" + kFunction + R"(\b(?!::))";
// What has members of these names are Eigen's arrays.
const std::string kMember =
    R"((\.|->)\s*()" + kFunction + R"(|digamma|logistic|rsqrt|eulerAngles)\s*\()";
// Eigen and Boost call them in these.
const std::string kOthers =
    R"(<random>|<complex>|std::complex|boost/|AngleAxis|Rotation2D|angularDistance|slerp|computeDirect)";
const std::regex kInexact(kCall + "|" + kQualified + "|" + kMember + "|" + kOthers);

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

void expectInexact(const std::vector<std::string>& lines) {
  for (const std::string& line : lines) EXPECT_THAT(inexactIn(line), ElementsAre(line));
}

TEST(ElementaryRules, FindCalls) {
  EXPECT_THAT(inexactIn("x = std::sin(y);\n"), ElementsAre("x = std::sin(y);"));
  expectInexact({"::cosf (x)", "return -exp(x);", "a * pow(2, 3)", "std::hypot(x, y)",
                 "std::log1p(x)", "x = (tanh(y))", "std::ellint_1(k, phi)",
                 "std::comp_ellint_1f(k)", "std::cyl_bessel_j(n, x)", "std::polar(1, x)",
                 "std::arg(z)", "__builtin_sin(x)", "__builtin_powi(x, 2)", "__builtin_expf (x)"});
}

TEST(ElementaryRules, FindFunctionsThatArePassedOn) {
  expectInexact({"double (*function)(double) = std::sin;", "apply(std::exp, x)", "using std::pow;",
                 "apply(::cosf, x)", "apply(Eigen::numext::log, x)"});
}

TEST(ElementaryRules, FindEigenAndBoost) {
  expectInexact({"Eigen::numext::exp(x)", "numext::log1p(x)", "Eigen::exp(values)", "values.sin()",
                 "values.exp(x)", "values.array().pow(3)", "values->log()", "z.arg()",
                 "values.array().tanh()", "values.rsqrt()", "matrix.eulerAngles(0, 1, 2)"});
  expectInexact({"#include <boost/math/constants.hpp>", "q.angularDistance(p)",
                 "Eigen::AngleAxisd(1, x)", "Eigen::Rotation2Dd turn(x)", "std::complex<double> z;",
                 "solver.computeDirect(tensor)"});
}

TEST(ElementaryRules, AllowWhatIsExact) {
  for (const std::string line :
       {"std::sqrt(x)", "sine(x)", "// sin(x)", "values.sine()", "exponential(x)", "std::expected",
        "std::ldexp(x, 2)", "logarithm(x)", "std::ilogb(x)", "double cosine = 1;", "catalog(x)",
        "elementary::sin(x)", "elementary::sin", "sample.logarithm(x)", "pair.cosine",
        "options.log", "::sinful", "__builtin_expect(x, 1)", "array.cwiseAbs()"}) {
    EXPECT_THAT(inexactIn(line), IsEmpty()) << line;
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
