#include "image/golden.h"

#include <cstdlib>
#include <string_view>

#include "base/error.h"
#include "image/png_file.h"

namespace rotatebook::image::testing {
namespace {

std::filesystem::path goldenPath(const std::string& name) {
  return std::filesystem::path(ROTATEBOOK_TEST_DATA) / "goldens" / (name + ".png");
}

}  // namespace

image::Image golden(const std::string& name) {
  return image::readPng(goldenPath(name));
}

bool updatingGoldens() {
  const char* value = std::getenv("ROTATEBOOK_UPDATE_GOLDENS");
  return value != nullptr && std::string_view(value) == "1";
}

void updateGolden(const std::string& name, image::ImageView picture) {
  std::filesystem::create_directories(goldenPath(name).parent_path());
  image::writePng(goldenPath(name), picture);
}

std::filesystem::path leftovers(const std::string& name, const std::string& kind) {
  return std::filesystem::path(ROTATEBOOK_TEST_OUTPUT) /
         std::filesystem::path(ROTATEBOOK_TEST_DATA).filename() / (name + "." + kind + ".png");
}

::testing::AssertionResult matchesGolden(const std::string& name, image::ImageView picture,
                                         image::Tolerance tolerance) {
  const std::filesystem::path actual = leftovers(name, "actual");
  std::filesystem::create_directories(actual.parent_path());
  try {
    const image::Image expected = golden(name);
    const image::Comparison found = image::compare(expected.view(), picture, tolerance);
    if (found.same) {
      return ::testing::AssertionSuccess()
             << name << ": largest " << found.largest << ", mean " << found.mean << ", "
             << found.differingPercent << " % off by more than " << tolerance.largest;
    }
    image::writePng(actual, picture);
    const std::filesystem::path difference = leftovers(name, "difference");
    image::writePng(difference, image::differenceImage(expected.view(), picture).view());
    return ::testing::AssertionFailure()
           << name << " differs: largest " << found.largest << ", mean " << found.mean << ", "
           << found.differingPercent << " % of the pixels off by more than " << tolerance.largest
           << " (allowed " << tolerance.failPercent << " %); see " << actual.string() << " and "
           << difference.string();
  } catch (const Error& error) {
    image::writePng(actual, picture);
    return ::testing::AssertionFailure() << error.what() << "; see " << actual.string();
  }
}

}  // namespace rotatebook::image::testing
