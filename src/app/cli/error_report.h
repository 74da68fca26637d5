// What an error is to the user. Inside the room only.
#pragma once

#include <exception>
#include <string_view>

namespace rotatebook::cli {

/// Says "rotatebook: `subject`MESSAGE" on the standard error; returns the exit status that such an
/// error gives. Takes no memory, which may be what is wanting.
int reportError(const std::exception_ptr& error, std::string_view subject = "");

}  // namespace rotatebook::cli
