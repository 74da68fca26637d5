#include "base/error.h"

#include "base/text.h"

namespace rotatebook {

Error::Error(ErrorKind kind, const std::string& message)
    : std::runtime_error(messageText(message)), kind_(kind) {}

}  // namespace rotatebook
