#include "base/version.h"

#include <string_view>

namespace rotatebook {

static_assert(std::string_view(kVersion) == ROTATEBOOK_VERSION,
              "base/version.h has another version than CMakeLists.txt: change both");

}  // namespace rotatebook
