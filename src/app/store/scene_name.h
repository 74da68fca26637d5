// The rules for names of scenes, after which all outputs are named.
#pragma once

#include <string>

namespace rotatebook::store {

/// Returns why outputs can't be named after `name`, as a predicate: "is empty"; empty if they can.
std::string problemOfName(const std::string& name);

}  // namespace rotatebook::store
