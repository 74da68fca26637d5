// Pictures compared with ones that were looked at and found right.
#pragma once

#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "image/comparison.h"
#include "image/image.h"

namespace rotatebook::image::testing {

/// The picture goldens/NAME.png in the folder of the running tests, such as tests/render.
image::Image golden(const std::string& name);

/// True where the environment variable ROTATEBOOK_UPDATE_GOLDENS is "1": run the tests so
/// after a change of the picture that is meant, look at the new goldens, and commit them.
bool updatingGoldens();

/// Replaces golden NAME by `picture` in the source tree.
void updateGolden(const std::string& name, image::ImageView picture);

/// Returns the path at which a failed comparison leaves NAME.actual.png or NAME.difference.png (16
/// times the difference).
std::filesystem::path leftovers(const std::string& name, const std::string& kind);

/// Success if `picture` is golden NAME within `tolerance`; else the numbers and what to look at.
::testing::AssertionResult matchesGolden(const std::string& name, image::ImageView picture,
                                         image::Tolerance tolerance);

}  // namespace rotatebook::image::testing
