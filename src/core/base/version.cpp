#include "base/version.h"

namespace rotatebook {

const char* const kVersion = ROTATEBOOK_VERSION;

}  // namespace rotatebook
